#pragma once
// The wanted pixels of a frame.

#include <cstdint>
#include <vector>

namespace nacre {

/// The wanted quarters of a picture's tiles: squares of 4 x 4 pixels, row by row.
struct TileMask {
    static constexpr std::uint32_t kSide = 4;  ///< of a quarter, pixels
    std::uint32_t across = 0;
    std::vector<std::uint8_t> wanted;
    bool wants(std::uint32_t x, std::uint32_t y) const {
        const std::size_t at = std::size_t{y} * across + x;
        return x < across && at < wanted.size() && wanted[at] != 0;
    }
    /// A bit for each quarter of a tile that is not wanted: 1 left, 2 right, 4 and 8 below them.
    std::uint32_t unwanted(std::uint32_t tileX, std::uint32_t tileY) const {
        std::uint32_t bits = 0;
        for (std::uint32_t i = 0; i < 4; ++i) bits |= wants(2 * tileX + i % 2, 2 * tileY + i / 2) ? 0u : 1u << i;
        return bits;
    }
};

}  // namespace nacre
