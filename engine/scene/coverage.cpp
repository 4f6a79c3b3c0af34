#include "engine/scene/coverage.h"

#include <algorithm>
#include <limits>

namespace nacre {
namespace {

// For what shaders round differently: pixels at a disc's edge, and a share of its radius.
constexpr float kRoomPixels = 1.0f / 32, kRoomShare = 1e-3f;

}  // namespace

void Coverage::begin(const TileView& view, double radiusPixels) {
    constexpr double kCellsInRadius = 4;
    const auto side = static_cast<std::uint32_t>(std::clamp(radiusPixels / kCellsInRadius, 1.0, 64.0));
    side_ = static_cast<float>(side);
    across_ = (view.width + side - 1) / side;
    down_ = (view.height + side - 1) / side;
    // Of a pixel its middle must be covered, or, where it has samples, all of it.
    const float corner = (view.centers ? side_ - 1 : side_) * 0.5f * std::sqrt(2.0f);
    inset_ = corner + kRoomPixels;
    centers_ = view.centers && side == 1;
    ask_ = centers_ ? 0.5f : 0.0f;
    depths_.assign(std::size_t{across_} * down_, std::numeric_limits<float>::max());
}

void Coverage::cover(const TileView& view, const glm::vec3& center, float radius) {
    const float Z = view.origin - center.z;
    // A sphere that a plane cuts has lost some of its picture.
    if (!(Z - radius > view.clipNear) || !(Z + radius < view.clipFar)) return;
    if (view.perspective && !(Z > radius)) return;
    const float scale = view.perspective ? view.origin / Z : 1.0f;
    const float reach = (radius * scale * view.pixels * (1 - kRoomShare) - inset_) / side_;
    if (!(reach > 0)) return;
    const glm::vec2 at = pixelOf(view, glm::vec2(center) * scale) / side_ - 0.5f;  // cells' middles are whole numbers
    const float right = static_cast<float>(across_) - 1, bottom = static_cast<float>(down_) - 1;
    const float top = std::max(std::ceil(at.y - reach), 0.0f), end = std::min(at.y + reach, bottom);
    for (float y = top; y <= end; y += 1) {
        const float half = std::sqrt(std::max(reach * reach - (y - at.y) * (y - at.y), 0.0f));
        const float from = std::max(std::ceil(at.x - half), 0.0f), to = std::min(std::floor(at.x + half), right);
        if (!(from <= to)) continue;
        float* row = depths_.data() + static_cast<std::size_t>(y) * across_;
        for (auto x = static_cast<std::uint32_t>(from); x <= static_cast<std::uint32_t>(to); ++x)
            row[x] = std::min(row[x], Z);
    }
}

bool Coverage::hides(glm::vec2 low, glm::vec2 high, float near) const {
    const auto clamped = [](float cell, std::uint32_t end) {
        return cell > 0 ? static_cast<std::uint32_t>(std::min(cell, static_cast<float>(end))) : 0;
    };
    // Cells that hold what is asked about of any pixel between the corners.
    const glm::vec2 from = (low - kRoomPixels - ask_) / side_, to = (high + kRoomPixels - ask_) / side_;
    const std::uint32_t left = clamped(centers_ ? std::ceil(from.x) : std::floor(from.x), across_);
    const std::uint32_t top = clamped(centers_ ? std::ceil(from.y) : std::floor(from.y), down_);
    const std::uint32_t right = clamped(std::floor(to.x) + 1, across_), bottom = clamped(std::floor(to.y) + 1, down_);
    for (std::uint32_t y = top; y < bottom; ++y) {
        const float* row = depths_.data() + std::size_t{y} * across_;
        for (std::uint32_t x = left; x < right; ++x)
            if (!(row[x] < near)) return false;
    }
    return true;
}

}  // namespace nacre
