#pragma once
// The tiles of a picture that compute draws. Bins of `kBinPixels` per side, row by row from the top left, have a list
// each; tiles of a bin share it.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/passes/tile_frame.h"
#include "engine/passes/tile_mask.h"

namespace nacre {

class TileSet {
public:
    static constexpr std::uint32_t kTilePixels = 8;
    static constexpr std::uint32_t kTilesInBin = 2;
    static constexpr std::uint32_t kBinPixels = TileBins::kPixels;
    static_assert(kBinPixels == kTilePixels * kTilesInBin);

    using Span = TileBins::Span;
    struct Tile {
        std::uint16_t x, y;
    };

    /// All tiles of a picture: the device makes the lists. @param mask  null: all pixels matter
    void cover(std::uint32_t width, std::uint32_t height, const TileMask* mask);

    std::uint32_t across() const { return across_; }        ///< bins per row
    std::uint32_t down() const { return down_; }            ///< rows of bins
    std::span<const Tile> tiles() const { return tiles_; }  ///< in drawing order, grouped by bin
    std::span<const Span> spans() const { return spans_; }  ///< bins that show anything
    bool masked() const { return !mask_.wanted.empty(); }
    /// Whether a tile is drawn if its bin holds anything.
    bool draws(std::uint32_t x, std::uint32_t y) const {
        return covers_ || !masked() || mask_.unwanted(x, y) != kAllUnwanted;
    }
    /// Neighbouring tiles of a row that are drawn, in bins that show anything. In tiles.
    std::vector<Span> drawnRows() const;
    /// Whether a bin may show a primitive smaller than TileWork::small().
    bool showsSmall(std::size_t x, std::size_t y) const {
        return !smallBins_.empty() && smallBins_[y * across_ + x] != 0;
    }
    /// Writes the tiles: x | unwanted quarters << 12 | y << 16 | 1 << 31 where showsSmall(). The device's data begin
    /// with them; then the begin of each bin's list and the end of the last; a primitive's number, 1; the lists.
    /// Readers of an empty list may load the word before it, which is a valid number.
    void writeTiles(std::uint32_t* to) const;
    /// Words of those data. @param entries  of all lists
    std::size_t words(std::size_t entries) const { return tiles_.size() + std::size_t{across_} * down_ + 2 + entries; }

protected:
    static constexpr std::uint32_t kAllUnwanted = 15;

    std::uint32_t across_ = 0, down_ = 0;
    TileMask mask_;  // empty: all tiles are drawn
    std::vector<Tile> tiles_;
    std::vector<Span> spans_;
    std::vector<std::uint8_t> smallBins_;  // bins that show small primitives; empty: none does
    bool covers_ = false;                  // all tiles are drawn
};

}  // namespace nacre
