#pragma once
// Colours, sizes and the font of the panel.

#include <imgui.h>

namespace nacre::app {

// White and light grey on nearly black: 15:1 and 9:1, where WCAG 2.1 asks for 7:1 at its strictest.
inline const ImVec4 kText(0.96f, 0.97f, 0.98f, 1), kFaint(0.74f, 0.77f, 0.80f, 1), kGround(0.09f, 0.10f, 0.12f, 1);
inline const ImVec4 kAccent(0.16f, 0.43f, 0.72f, 1), kField(0.20f, 0.22f, 0.26f, 1), kWarning(1.0f, 0.80f, 0.45f, 1);
inline constexpr ImU32 kMark = IM_COL32(255, 190, 30, 255), kMarkEdge = IM_COL32(20, 22, 26, 230);

/// Height of a widget that a finger hits, in points.
inline constexpr float kFingerPoints = 48;

/// Adds the font to the current context, in the sizes of text, of sub- and superscripts, and of a title.
void addPanelFont(float pixelsPerPoint);
/// Of those sizes the one that is nearest to some pixels of ImFont::FontSize.
ImFont* fontOf(float size);
/// FontSize of an em: Dear ImGui counts from the highest to the lowest of DejaVu Sans.
inline constexpr float kFontSizeOfEm = 1.164f;

/// Sets sizes and colours of the current context.
void setPanelStyle(float pixelsPerPoint, bool fingers);

}  // namespace nacre::app
