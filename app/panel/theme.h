#pragma once
// Colours, sizes and fonts of the panel: a dark and a light theme, one scale of text sizes.

#include <imgui.h>

namespace nacre::app {

/// Straight alpha, sRGB-coded. Text has a contrast of 4.5:1 or more (WCAG 2.1, 1.4.3), lines and marks with a meaning
/// 3:1 (1.4.11); tests/panel checks this table.
struct Theme {
    bool dark;
    ImVec4 ground;    ///< of the panel
    ImVec4 raised;    ///< of cards
    ImVec4 field;     ///< of buttons and fields
    ImVec4 hovered;   ///< fields under the pointer
    ImVec4 line;      ///< separators
    ImVec4 text;      ///< on all of these
    ImVec4 faint;     ///< explanations
    ImVec4 accent;    ///< of selected items
    ImVec4 onAccent;  ///< text on it
    ImVec4 mark;      ///< of switches, sliders and focus
    ImVec4 warning;   ///< text
};
const Theme& darkTheme();
const Theme& lightTheme();

inline constexpr ImU32 kMark = IM_COL32(255, 190, 30, 255), kMarkEdge = IM_COL32(20, 22, 26, 230);

inline constexpr float kTextPoints = 15;
/// Minimum height of a widget for touch, points.
inline constexpr float kFingerPoints = 48;

/// Text sizes.
enum class TextSize { caption, body, heading };

/// The font whose size is nearest to a number of pixels of ImFont::FontSize.
ImFont* findFont(float size);
ImFont* findFont(TextSize size);
/// FontSize per em: Dear ImGui measures from the highest to the lowest point of DejaVu Sans.
inline constexpr float kFontSizeOfEm = 1.164f;

/// Sets sizes and colours of the current context.
/// @param target  height of clickable widgets, points; 0: as small as their text allows
void setPanelStyle(const Theme& theme, float pixelsPerPoint, bool fingers, float target);

}  // namespace nacre::app
