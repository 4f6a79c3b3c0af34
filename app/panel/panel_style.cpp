#include "app/panel/panel_style.h"

#include <filesystem>
#include <system_error>

namespace nacre::app {
namespace {

constexpr float kTextPoints = 15;
constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf", "/system/fonts/Roboto-Regular.ttf", "/system/fonts/DroidSans.ttf"};

}  // namespace

void addPanelFont(float pixelsPerPoint) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    for (const char* font : kFonts) {
        std::error_code ignored;
        if (!std::filesystem::exists(font, ignored)) continue;
        fonts.AddFontFromFileTTF(font, kTextPoints * pixelsPerPoint);
        return;
    }
    ImFontConfig own;  // Dear ImGui's
    own.SizePixels = kTextPoints * pixelsPerPoint;
    fonts.AddFontDefault(&own);
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
