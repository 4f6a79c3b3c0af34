#pragma once
// Intermediate images of a frame, for engineers.

#include <span>

namespace nacre {

enum class DebugView {
    none,
    depth,      ///< of the nearest surface: white near, black far (Figure 4 of the paper)
    encoded,    ///< first three channels of the encoded depth attachment, as stored
    plates,     ///< full colour where the opaque prepass draws, pale elsewhere (Figure 8)
    overdraw,   ///< impostor fragments that pass the early depth test: one colour per doubling
    occlusion,  ///< ambient occlusion alone, in linear light (Figure 7)
    patches,    ///< the occlusion atlas (Figure 6); pans and zooms with the view
    id,         ///< one colour per atom
    normals,    ///< x, y, z of the view-space normal as red, green, blue; 0 is mid-grey
    tiles,      ///< mean fragments per pixel in tiles of 16 x 16 pixels, coloured as overdraw
};

/// Names by value; the first is "none".
std::span<const char* const> debugViewNames();

/// Whether the view needs ambient occlusion.
constexpr bool needsOcclusion(DebugView view) { return view == DebugView::occlusion || view == DebugView::patches; }

}  // namespace nacre
