#pragma once
// Colours, sizes and the font of the panel: one theme for dark surroundings and one for light, one scale of text.

#include <imgui.h>

#include <span>

namespace nacre::app {

/// Straight alpha, sRGB-coded. What stands upon what is kept at 4.5:1 or more (WCAG 2.1, 1.4.3), lines and marks at 3:1
/// where they alone say something (1.4.11); tests/panel reads it off this table.
struct Theme {
    bool dark;
    ImVec4 ground;    ///< of the panel
    ImVec4 raised;    ///< of cards upon it
    ImVec4 field;     ///< of buttons and fields
    ImVec4 hovered;   ///< the same under the pointer
    ImVec4 line;      ///< between parts
    ImVec4 text;      ///< upon all of these
    ImVec4 faint;     ///< explanations
    ImVec4 accent;    ///< of what is chosen
    ImVec4 onAccent;  ///< text upon it
    ImVec4 mark;      ///< of switches and sliders, and of the focus
    ImVec4 warning;   ///< text
};
const Theme& darkTheme();
const Theme& lightTheme();

inline constexpr ImU32 kMark = IM_COL32(255, 190, 30, 255), kMarkEdge = IM_COL32(20, 22, 26, 230),
                       kSelected = IM_COL32(255, 90, 200, 255);

inline constexpr float kTextPoints = 15;
/// Height of a widget that a finger hits, in points.
inline constexpr float kFingerPoints = 48;

/// The scale of text: captions, text, headings.
enum class TextSize { caption, body, heading };

/// Of those sizes the one that is nearest to some pixels of ImFont::FontSize.
ImFont* fontOf(float size);
ImFont* fontOf(TextSize size);
/// FontSize of an em: Dear ImGui counts from the highest to the lowest of DejaVu Sans.
inline constexpr float kFontSizeOfEm = 1.164f;

/// Sets sizes and colours of the current context.
void setPanelStyle(const Theme& theme, float pixelsPerPoint, bool fingers);

}  // namespace nacre::app
