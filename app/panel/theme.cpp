#include "app/panel/theme.h"

#include <cmath>

namespace nacre::app {
namespace {

ImVec4 rgb(unsigned value, float alpha = 1) {
    return {static_cast<float>(value >> 16 & 255) / 255, static_cast<float>(value >> 8 & 255) / 255,
            static_cast<float>(value & 255) / 255, alpha};
}

}  // namespace

const Theme& darkTheme() {
    static const Theme theme{true,          rgb(0x171a1f), rgb(0x21252b), rgb(0x2d323a), rgb(0x3a414c), rgb(0x434b57),
                             rgb(0xf4f6f8), rgb(0xbcc3cb), rgb(0x2a68ad), rgb(0xffffff), rgb(0x78bdff), rgb(0xffcc73)};
    return theme;
}

const Theme& lightTheme() {
    static const Theme theme{false,         rgb(0xfafbfc), rgb(0xf0f2f5), rgb(0xe3e7ec), rgb(0xd3d9e1), rgb(0xb4bcc7),
                             rgb(0x14171b), rgb(0x474f59), rgb(0x1f61ab), rgb(0xffffff), rgb(0x1a5fae), rgb(0x7a4300)};
    return theme;
}

ImFont* findFont(float size) {
    ImFont* best = nullptr;
    for (ImFont* font : ImGui::GetIO().Fonts->Fonts)
        if (!best || std::abs(font->FontSize - size) < std::abs(best->FontSize - size)) best = font;
    return best;
}

ImFont* findFont(TextSize size) {
    return ImGui::GetIO().Fonts->Fonts[size == TextSize::body ? 0 : size == TextSize::caption ? 2 : 3];
}

void setPanelStyle(const Theme& theme, float pixelsPerPoint, bool fingers, float target) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    if (theme.dark)
        ImGui::StyleColorsDark(&style);
    else
        ImGui::StyleColorsLight(&style);
    style.WindowRounding = style.ChildRounding = 10;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = 6;
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = ImVec2(fingers ? 14 : 9, 6);
    style.ItemSpacing = ImVec2(8, 7);
    style.ScrollbarSize = 12;
    style.ScrollbarRounding = 6;
    style.GrabMinSize = fingers ? 24 : 14;
    style.WindowBorderSize = style.PopupBorderSize = 1;
    style.ScaleAllSizes(pixelsPerPoint);
    if (target > 0)
        style.FramePadding.y = std::ceil((target * pixelsPerPoint - std::round(kTextPoints * pixelsPerPoint)) / 2);
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = theme.text;
    colors[ImGuiCol_TextDisabled] = theme.faint;
    colors[ImGuiCol_WindowBg] = colors[ImGuiCol_PopupBg] = theme.ground;
    colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
    colors[ImGuiCol_Border] = colors[ImGuiCol_Separator] = theme.line;
    colors[ImGuiCol_FrameBg] = colors[ImGuiCol_Button] = colors[ImGuiCol_Header] = theme.field;
    // A lifted finger does not hover.
    const ImVec4& hovered = fingers ? theme.field : theme.hovered;
    for (const int which : {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered})
        colors[which] = hovered;
    for (const int which : {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive})
        colors[which] = theme.hovered;
    colors[ImGuiCol_CheckMark] = theme.mark;
    colors[ImGuiCol_NavHighlight] = theme.mark;
    colors[ImGuiCol_PlotHistogram] = theme.accent;
    colors[ImGuiCol_TextSelectedBg] = theme.accent;
    colors[ImGuiCol_TextSelectedBg].w = 0.45f;
    colors[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
    colors[ImGuiCol_ScrollbarGrab] = theme.line;
    colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = theme.faint;
}

}  // namespace nacre::app
