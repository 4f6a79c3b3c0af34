#pragma once
// The camera for lists of tiles.

#include <cstdint>
#include <glm/vec4.hpp>

#include "engine/lists/screen_view.h"
#include "engine/passes/tile_mask.h"

namespace nacre {

struct TileView : ScreenView {
    /// Pixels are sampled at their centres only. Triangles between centres are dropped and, with one layer, those
    /// hidden at every centre; pixels start with the nearest one.
    bool centers = false;
    /// Pixels are sampled at their centres, then between them. They start with the nearest triangle, and triangles
    /// hidden at all surrounding centres are dropped.
    bool edges = false;
    float small = 0;                 ///< primitives of a smaller half width may lie between centres, pixels
    bool frontsOnly = false;         ///< triangles are invisible from behind
    float wireScale = 1;             ///< pixels per pixel of the picture, for the width of wires
    const TileMask* mask = nullptr;  ///< null: all tiles are drawn
    bool layers = false;             ///< all layers are seen, not only the nearest
};

/// Primitives of a stream with one transform.
struct TileCall {
    const glm::vec4* rows = nullptr;  ///< three: into view space
    std::uint32_t first = 0, count = 0;
    std::uint32_t number = 0;  ///< of the stream's first primitive there
};

}  // namespace nacre
