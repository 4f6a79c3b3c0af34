#include "app/panel/panel_style.h"

#include <cmath>

#include "app/shared/font.h"

namespace nacre::app {
namespace {

constexpr float kTextPoints = 15;
// Latin, Greek, dashes and primes, raised and lowered digits, arrows, the minus sign.
constexpr ImWchar kGlyphs[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2044, 0x2070, 0x209c,
                               0x2190, 0x2193, 0x2212, 0x2212, 0xfffd, 0xfffd, 0};

}  // namespace

void addPanelFont(float pixelsPerPoint) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const std::span<const std::byte> file = fontFile();
    for (const float share : {1.0f, 0.68f, 1.45f}) {
        ImFontConfig own;
        own.FontDataOwnedByAtlas = false;  // nor is it written to
        fonts.AddFontFromMemoryTTF(const_cast<std::byte*>(file.data()), static_cast<int>(file.size()),
                                   kTextPoints * share * pixelsPerPoint, &own, kGlyphs);
    }
}

ImFont* fontOf(float size) {
    ImFont* best = nullptr;
    for (ImFont* font : ImGui::GetIO().Fonts->Fonts)
        if (!best || std::abs(font->FontSize - size) < std::abs(best->FontSize - size)) best = font;
    return best;
}

void setPanelStyle(float pixelsPerPoint, bool fingers) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 8;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 5;
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = fingers ? ImVec2(14, (kFingerPoints - kTextPoints) / 2) : ImVec2(8, 4);
    style.ItemSpacing = ImVec2(8, 6);
    style.WindowBorderSize = style.PopupBorderSize = 0;
    style.ScaleAllSizes(pixelsPerPoint);
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = kText;
    colors[ImGuiCol_TextDisabled] = kFaint;
    colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = kGround;
    colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Button] = kField;
    // A finger that has left hovers nowhere.
    colors[ImGuiCol_FrameBgHovered] = colors[ImGuiCol_ButtonHovered] =
        fingers ? kField : ImVec4(0.27f, 0.31f, 0.37f, 1);
    colors[ImGuiCol_FrameBgActive] = colors[ImGuiCol_ButtonActive] = colors[ImGuiCol_Header] = kAccent;
    colors[ImGuiCol_HeaderActive] = kAccent;
    colors[ImGuiCol_HeaderHovered] = fingers ? kField : kAccent;
    colors[ImGuiCol_CheckMark] = ImVec4(0.45f, 0.75f, 1.0f, 1);
    colors[ImGuiCol_PlotHistogram] = kAccent;
    colors[ImGuiCol_Separator] = ImVec4(0.30f, 0.33f, 0.38f, 1);
}

}  // namespace nacre::app
