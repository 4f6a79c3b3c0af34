#pragma once
// Pictures of what a frame works with, for engineers.

#include <span>

namespace nacre {

enum class DebugView {
    none,
    depth,      ///< of the nearest surface: white near, black far (the paper's Figure 4)
    encoded,    ///< the encoded depth attachment as it is stored: its first three channels
    plates,     ///< what the opaque prepass covers in full colour, the rest pale (Figure 8)
    overdraw,   ///< fragments of the impostors that pass the early depth test: every doubling another colour
    occlusion,  ///< ambient occlusion alone, in linear light (Figure 7)
    patches,    ///< the occlusion atlas (Figure 6); pans and zooms with the view
    id,         ///< a colour an atom
    normals,    ///< x, y, z of the view-space normal as red, green, blue; 0 is mid-grey
    tiles,      ///< mean fragments a pixel in tiles of 16 x 16 pixels, coloured as overdraw
};

/// Names by value; the first is "none".
std::span<const char* const> debugViewNames();

/// Whether there is nothing to show without ambient occlusion.
constexpr bool needsOcclusion(DebugView view) { return view == DebugView::occlusion || view == DebugView::patches; }

}  // namespace nacre
