#include "engine/tiles/tile_set.h"

namespace nacre {

void TileSet::cover(std::uint32_t width, std::uint32_t height, const TileMask* mask) {
    const std::uint32_t across = (width + kBinPixels - 1) / kBinPixels, down = (height + kBinPixels - 1) / kBinPixels;
    mask_.wanted.clear();
    if (mask) mask_ = *mask;
    if (covers_ && across == across_ && down == down_) return;
    across_ = across;
    down_ = down;
    covers_ = true;
    tiles_.clear();
    spans_.clear();
    for (std::uint32_t y = 0; y < down_; ++y) {
        spans_.push_back(
            {0, static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(across_), static_cast<std::uint16_t>(y + 1)});
        for (std::uint32_t x = 0; x < across_; ++x)
            for (std::uint32_t i = 0; i < kTilesInBin * kTilesInBin; ++i)
                tiles_.push_back({static_cast<std::uint16_t>(x * kTilesInBin + i / kTilesInBin),
                                  static_cast<std::uint16_t>(y * kTilesInBin + i % kTilesInBin)});
    }
}

std::vector<TileSet::Span> TileSet::drawnRows() const {
    std::vector<Span> rows;
    for (const Span& s : spans_)
        for (std::uint32_t y = s.y * kTilesInBin; y < s.endY * kTilesInBin; ++y)
            for (std::uint32_t x = s.x * kTilesInBin, end = x; x < s.endX * kTilesInBin; x = end + 1) {
                for (end = x; end < s.endX * kTilesInBin && draws(end, y);) ++end;
                if (end > x)
                    rows.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                    static_cast<std::uint16_t>(end), static_cast<std::uint16_t>(y + 1)});
            }
    return rows;
}

void TileSet::writeTiles(std::uint32_t* to) const {
    constexpr int kUnwanted = 12, kSmall = 31;  // shaders/common/tile_entries.glsl
    for (const Tile& t : tiles_)
        *to++ = t.x | (masked() ? mask_.unwanted(t.x, t.y) << kUnwanted : 0u) | std::uint32_t{t.y} << 16 |
                (showsSmall(t.x / kTilesInBin, t.y / kTilesInBin) ? 1u << kSmall : 0u);
}

}  // namespace nacre
