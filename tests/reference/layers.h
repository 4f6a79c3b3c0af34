#pragma once
// What one picture says about each pixel, row 0 on top: the channels of `--layers` that geometry alone decides.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace nacre::reference {

constexpr std::uint32_t kNoPrimitive = 0xffffffffu;

struct Layers {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> id;  ///< 1-based atom; 0 = background
    std::vector<float> z;           ///< Å: orthographic from the plane z = +R, perspective from the eye along -z
    std::vector<float> nx, ny, nz;  ///< view-space unit normal; 0 in the background

    // Known to the ray caster alone; empty in the layers of a drawn picture.
    std::vector<std::uint32_t> primitive;  ///< spheres first, then cylinders; kNoPrimitive in the background
    std::vector<float> gap;                ///< Å from the nearest surface to that of the next primitive behind it
    std::vector<std::uint8_t> nearEdge;    ///< 1: one of the eight neighbours shows another atom, or background

    std::size_t pixels() const { return std::size_t{width} * height; }
    std::size_t index(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} * width + column; }
};

/// All background, without the ray caster's own channels.
inline Layers emptyLayers(std::uint32_t width, std::uint32_t height) {
    Layers layers;
    layers.width = width;
    layers.height = height;
    layers.id.assign(layers.pixels(), 0);
    layers.z.assign(layers.pixels(), std::numeric_limits<float>::infinity());
    layers.nx.assign(layers.pixels(), 0.0f);
    layers.ny = layers.nz = layers.nx;
    return layers;
}

/// True if `differ(neighbour)` holds for one of the (up to eight) neighbours that the picture has.
template <typename Differ>
bool anyNeighbor(const Layers& layers, std::uint32_t column, std::uint32_t row, Differ differ) {
    const std::uint32_t left = column > 0 ? column - 1 : 0, top = row > 0 ? row - 1 : 0;
    for (std::uint32_t y = top; y <= row + 1 && y < layers.height; ++y)
        for (std::uint32_t x = left; x <= column + 1 && x < layers.width; ++x)
            if (differ(layers.index(x, y))) return true;
    return false;
}

}  // namespace nacre::reference
