#include "engine/software/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nacre {
namespace {

// Margins for shaders' rounding: pixels at a disc's edge, and a fraction of its radius.
constexpr float kRoomPixels = 1.0f / 32, kRoomShare = 1e-3f;

}  // namespace

void Coverage::begin(const TileView& view, double radiusPixels) {
    constexpr double kCellsInRadius = 4;
    const auto side = static_cast<std::uint32_t>(std::clamp(radiusPixels / kCellsInRadius, 1.0, 64.0));
    side_ = static_cast<float>(side);
    perSide_ = 1.0f / side_;
    across_ = (view.width + side - 1) / side;
    down_ = (view.height + side - 1) / side;
    // A pixel's centre must be covered or, with several samples, the whole pixel.
    const float corner = (view.centers ? side_ - 1 : side_) * 0.5f * std::sqrt(2.0f);
    inset_ = corner + kRoomPixels;
    outset_ = corner + kRoomPixels;
    depths_.assign(std::size_t{across_} * down_, std::numeric_limits<float>::max());
}

/// Visits cells whose centres are inside a disc, in some rows. @param work  takes neighbouring cells of a row; returns
/// false to stop @returns whether all were visited
template <typename Work>
bool Coverage::eachRow(const CellDisc& disc, RowBand rows, const Work& work) {
    const glm::vec2 at = disc.at;
    const float right = static_cast<float>(across_), first = static_cast<float>(rows.first);
    // The cell at its centre is most decisive, and the only one of a small disc.
    if (at.x >= 0 && at.x < right && at.y >= first && at.y < static_cast<float>(rows.end)) {
        const auto x = static_cast<std::uint32_t>(at.x), y = static_cast<std::uint32_t>(at.y);
        const float aside = at.x - static_cast<float>(x) - 0.5f, above = at.y - static_cast<float>(y) - 0.5f;
        if (aside * aside + above * above <= disc.squared) {
            float* cell = depths_.data() + std::size_t{y} * across_ + x;
            if (!work(cell, cell + 1)) return false;
        }
        if (disc.radius < 0.5f) return true;
    }
    // Centres are at integers plus a half; truncation of a positive number removes less than one.
    const float low = at.y - disc.radius - 0.5f, high = at.y + disc.radius - 0.5f;
    std::uint32_t y =
        low > first ? static_cast<std::uint32_t>(std::min(low, static_cast<float>(rows.end))) : rows.first;
    for (; y < rows.end && static_cast<float>(y) <= high; ++y) {
        const float away = static_cast<float>(y) + 0.5f - at.y, under = disc.squared - away * away;
        if (!(under >= 0)) continue;
        const float half = std::sqrt(under), from = at.x - half - 0.5f, to = at.x + half - 0.5f;
        if (!(to >= 0) || !(from < right)) continue;
        auto x = from > 0 ? static_cast<std::uint32_t>(from) : 0;
        x += static_cast<float>(x) < from ? 1 : 0;
        const std::uint32_t end = static_cast<std::uint32_t>(std::min(to, right - 1)) + 1;
        float* row = depths_.data() + std::size_t{y} * across_;
        if (x < end && !work(row + x, row + end)) return false;
    }
    return true;
}

void Coverage::cover(const TileView& view, const glm::vec3& center, float radius, RowBand rows) {
    const float Z = view.origin - center.z;
    // A clipping plane removes part of a sphere's picture.
    if (!(Z - radius > view.clipNear) || !(Z + radius < view.clipFar)) return;
    if (view.perspective && !(Z > radius)) return;
    const float scale = view.perspective ? view.origin / Z : 1.0f;
    const float reach = (radius * scale * view.pixels * (1 - kRoomShare) - inset_) * perSide_;
    if (!(reach > 0)) return;
    const glm::vec2 at = toPixel(view, glm::vec2(center) * scale) * perSide_;
    eachRow({at, reach, reach * reach}, rows, [&](float* from, float* to) {
        for (; from != to; ++from) *from = std::min(*from, Z);
        return true;
    });
}

bool Coverage::hidesLarge(const CellDisc& disc, float near, RowBand rows) {
    return eachRow(disc, rows, [&](const float* from, const float* to) {
        for (; from != to; ++from)
            if (!(*from < near)) return false;
        return true;
    });
}

}  // namespace nacre
