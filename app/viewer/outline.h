#pragma once
// Marks of atoms over a picture: an outline around their visible part, and a light tint.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/results.h"

namespace nacre::app {

/// Atoms that are marked in the window, from 0.
struct Highlights {
    std::vector<bool> selected;                   ///< may be shorter than the molecule
    std::uint32_t firstHovered = 0, hovered = 0;  ///< a run of atoms: those that a click would select
    bool any() const { return hovered > 0 || !selected.empty(); }
    friend bool operator==(const Highlights&, const Highlights&) = default;
};

/// Neighbouring pixels of a row with equal coverage.
struct MarkSpan {
    std::uint32_t x = 0, y = 0, width = 0;
    std::uint8_t alpha = 0;
    friend bool operator==(const MarkSpan&, const MarkSpan&) = default;
};

/// sRGB-coded, red in the lowest byte: a pink that no element or chain has.
constexpr std::uint32_t kMarkColor = 0xa02dff;

/// @param atoms  for each pixel, row by row, the visible atom, from 1; 0: none
/// @param width  of the outline, pixels
std::vector<MarkSpan> makeOutline(std::span<const std::uint32_t> atoms, PixelSize size, const Highlights& marks,
                                  double width);

/// Paints spans onto a picture of their size.
void paintMarks(const std::vector<MarkSpan>& spans, Picture& picture);

}  // namespace nacre::app
