#include "engine/frame/finer_places.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/settings.h"

namespace nacre {
namespace {

/// A channel in steps that look alike: the square root is close to sRGB's coding.
std::uint8_t stepOf(float linear) { return static_cast<std::uint8_t>(255 * std::sqrt(std::clamp(linear, 0.0f, 1.0f))); }

/// In any channel. Smaller differences leave 50 dB and more.
bool differs(const std::uint8_t* a, const std::uint8_t* b) {
    constexpr int kLeast = 16;
    bool any = false;
    for (int c = 0; c < 4; ++c) any = any || std::abs(int{a[c]} - int{b[c]}) >= kLeast;
    return any;
}

}  // namespace

FinerPlaces::FinerPlaces(const Picture& seen) : across_(seen.width), pixels_(std::size_t{seen.width} * seen.height) {
    std::vector<std::uint8_t> steps(seen.rgba.size());
    std::transform(seen.rgba.begin(), seen.rgba.end(), steps.begin(), stepOf);
    const auto compare = [&](std::size_t a, std::size_t b) {
        if (differs(steps.data() + 4 * a, steps.data() + 4 * b)) pixels_[a] = pixels_[b] = 1;
    };
    for (std::uint32_t y = 0; y < seen.height; ++y)
        for (std::uint32_t x = 0; x < seen.width; ++x) {
            const std::size_t here = std::size_t{y} * across_ + x;
            if (x + 1 < seen.width) compare(here, here + 1);
            if (y + 1 < seen.height) compare(here, here + across_);
        }
}

PictureRect FinerPlaces::boundsIn(const PictureRect& part) const {
    std::uint32_t left = part.width, top = part.height, right = 0, bottom = 0;
    for (std::uint32_t y = 0; y < part.height; ++y)
        for (std::uint32_t x = 0; x < part.width; ++x) {
            if (!finer(part.x + x, part.y + y)) continue;
            left = std::min(left, x);
            top = std::min(top, y);
            right = std::max(right, x + 1);
            bottom = std::max(bottom, y + 1);
        }
    if (right == 0) return {};
    left -= left % PictureRect::kStep;
    top -= top % PictureRect::kStep;
    return {part.x + left, part.y + top, right - left, bottom - top};
}

TileMask FinerPlaces::tilesOf(const PictureRect& shown, const PictureRect& wanted) const {
    static_assert(TileMask::kSide == RenderSettings::kBlockSamples);
    TileMask mask;
    mask.across = shown.width;
    mask.wanted.resize(std::size_t{shown.width} * shown.height);
    for (std::uint32_t y = wanted.y; y < wanted.y + wanted.height; ++y)
        for (std::uint32_t x = wanted.x; x < wanted.x + wanted.width; ++x)
            mask.wanted[std::size_t{y - shown.y} * mask.across + x - shown.x] = finer(x, y) ? 1 : 0;
    return mask;
}

}  // namespace nacre
