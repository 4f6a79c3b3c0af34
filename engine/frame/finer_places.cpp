#include "engine/frame/finer_places.h"

#include <algorithm>
#include <cmath>

#include "engine/settings.h"

namespace nacre {
namespace {

/// Tells whether any channel differs.
class Difference {
public:
    constexpr explicit Difference(std::uint32_t least)
        : room_(kNone + least * kOnes), within_((kNone | (kNone - kOnes)) & ~((2 * least - 1) * kOnes)) {}
    constexpr bool operator()(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t even = (a & kBytes) + room_ - (b & kBytes);
        const std::uint32_t odd = (a >> 8 & kBytes) + room_ - (b >> 8 & kBytes);
        return (((even & within_) ^ kNone) | ((odd & within_) ^ kNone)) != 0;
    }

private:
    static constexpr std::uint32_t kBytes = 0x00ff00ff, kOnes = 0x00010001, kNone = 0x02000200;
    std::uint32_t room_, within_;
};
static_assert(!Difference(16)(0x80818283, 0x80818283) && !Difference(16)(0x80, 0x8f) && Difference(16)(0x80, 0x91));
static_assert(!Difference(32)(0x80 << 16, 0x9f << 16) && Difference(32)(0x80 << 16, 0xa1 << 16));
static_assert(Difference(16)(0, 0xff000000) && Difference(32)(0xff00, 0));

/// Marks the pixels of two rows that differ.
void compare(Difference differs, const std::uint32_t* a, const std::uint32_t* b, std::uint32_t count, std::uint8_t* ofA,
             std::uint8_t* ofB) {
    for (std::uint32_t x = 0; x < count; ++x) {
        const std::uint8_t apart = differs(a[x], b[x]) ? 0xff : 0;
        ofA[x] |= apart;
        ofB[x] |= apart;
    }
}

/// A channel in steps that look alike: the square root is close to sRGB's coding.
std::uint32_t stepOf(float linear) {
    return static_cast<std::uint32_t>(255 * std::sqrt(std::clamp(linear, 0.0f, 1.0f)));
}

std::vector<std::uint32_t> stepsOf(const float* seen, std::size_t count) {
    std::vector<std::uint32_t> steps(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 4; ++c) steps[i] |= stepOf(seen[4 * i + c]) << (8 * c);
    return steps;
}

}  // namespace

FinerPlaces::FinerPlaces(const std::uint32_t* seen, std::uint32_t rowPixels, graph::Extent image, std::uint32_t least)
    : across_(image.width), pixels_(std::size_t{image.width} * image.height) {
    const Difference differs(least);
    for (std::uint32_t y = 0; y < image.height; ++y, seen += rowPixels) {
        std::uint8_t* const row = pixels_.data() + std::size_t{y} * across_;
        compare(differs, seen, seen + 1, image.width - 1, row, row + 1);
        if (y + 1 < image.height) compare(differs, seen, seen + rowPixels, image.width, row, row + across_);
    }
}

FinerPlaces::FinerPlaces(const float* seen, graph::Extent image, std::uint32_t least)
    : FinerPlaces(stepsOf(seen, std::size_t{image.width} * image.height).data(), image.width, image, least) {}

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
