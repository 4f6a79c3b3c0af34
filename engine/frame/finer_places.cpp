#include "engine/frame/finer_places.h"

#include <algorithm>
#include <cmath>

#include "engine/settings.h"

namespace nacre {
namespace {

constexpr std::uint32_t kEach = 0x00010001;  // of two channels at a time

/// Differences of two channels, plus 0x200 each.
constexpr std::uint32_t subtract(std::uint32_t a, std::uint32_t b) {
    return (a & 0xff * kEach) + 0x200 * kEach - (b & 0xff * kEach);
}

/// Whether one of two differences is `steps` or more, up or down.
constexpr bool reaches(std::uint32_t differences, std::uint32_t steps) {
    const std::uint32_t up = differences + (0x200 - steps) * kEach, down = (0x600 - steps) * kEach - differences;
    return ((up | down) & 0x400 * kEach) != 0;
}

constexpr std::uint8_t kFewByte = FinerPlaces::kFew - 1, kManyByte = FinerPlaces::kMany - 1;
static_assert((kFewByte | kManyByte) == kManyByte);

/// The samples that two neighbouring pixels need, as FinerPlaces::bytes().
constexpr std::uint8_t compare(std::uint32_t a, std::uint32_t b) {
    constexpr std::uint32_t kSome = 16, kMuch = 48;  // of 255; without samples below kSome 50 dB and more are left
    const std::uint32_t even = subtract(a, b), odd = subtract(a >> 8, b >> 8);
    if (reaches(even, kMuch) || reaches(odd, kMuch)) return kManyByte;
    return reaches(even, kSome) || reaches(odd, kSome) ? kFewByte : 0;
}
static_assert(compare(0x80818283, 0x8f728283) == 0 && compare(0x80, 0x90) == kFewByte &&
              compare(0x9000, 0x8000) == kFewByte && compare(0xff000000, 0xd0000000) == kFewByte &&
              compare(0x300000, 0) == kManyByte && compare(0, 0xff000000) == kManyByte);

void compareRows(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t count, std::uint8_t* ofA,
                 std::uint8_t* ofB) {
    for (std::uint32_t x = 0; x < count; ++x) {
        const std::uint8_t need = compare(a[x], b[x]);
        ofA[x] |= need;
        ofB[x] |= need;
    }
}

/// A channel in steps of equal visibility: the square root is close to sRGB's coding.
std::uint32_t toStep(float linear) {
    return static_cast<std::uint32_t>(255 * std::sqrt(std::clamp(linear, 0.0f, 1.0f)));
}

std::vector<std::uint32_t> toSteps(const float* seen, std::size_t count, const glm::vec4& under) {
    std::vector<std::uint32_t> steps(count);
    for (std::size_t i = 0; i < count; ++i, seen += 4)
        for (int c = 0; c < 4; ++c) steps[i] |= toStep(seen[c] + (1 - seen[3]) * under[c]) << (8 * c);
    return steps;
}

}  // namespace

FinerPlaces::FinerPlaces(const std::uint32_t* seen, std::uint32_t rowPixels, graph::Extent image)
    : across_(image.width), pixels_(std::size_t{image.width} * image.height) {
    for (std::uint32_t y = 0; y < image.height; ++y, seen += rowPixels) {
        std::uint8_t* const row = pixels_.data() + std::size_t{y} * across_;
        compareRows(seen, seen + 1, image.width - 1, row, row + 1);
        if (y + 1 < image.height) compareRows(seen, seen + rowPixels, image.width, row, row + across_);
    }
}

FinerPlaces::FinerPlaces(const float* seen, graph::Extent image, const glm::vec4& under)
    : FinerPlaces(toSteps(seen, std::size_t{image.width} * image.height, under).data(), image.width, image) {}

void FinerPlaces::add(const PictureRect& part) {
    const std::size_t down = across_ == 0 ? 0 : pixels_.size() / across_;
    const std::uint32_t right = std::min(part.x + part.width, across_);
    for (std::size_t y = part.y; y < std::min<std::size_t>(part.y + part.height, down); ++y)
        for (std::uint32_t x = part.x; x < right; ++x) pixels_[y * across_ + x] = kManyByte;
}

void FinerPlaces::grow() {
    const std::size_t down = across_ == 0 ? 0 : pixels_.size() / across_;
    std::vector<std::uint8_t> wide = pixels_;
    for (std::size_t y = 0; y < down; ++y)
        for (std::size_t x = 1; x < across_; ++x) {
            const std::size_t at = y * across_ + x;
            wide[at] |= pixels_[at - 1];
            wide[at - 1] |= pixels_[at];
        }
    pixels_ = wide;
    for (std::size_t at = across_; at < pixels_.size(); ++at) {
        pixels_[at] |= wide[at - across_];
        pixels_[at - across_] |= wide[at];
    }
}

void FinerPlaces::takeMany() {
    for (std::uint8_t& pixel : pixels_) pixel = pixel == 0 ? 0 : kManyByte;
}

void FinerPlaces::keep(const std::vector<std::uint8_t>& sharp) {
    const std::size_t across = (across_ + kTogether - 1) / kTogether;
    for (std::size_t at = 0, y = 0; at < pixels_.size(); ++y)
        for (std::size_t x = 0; x < across_; ++x, ++at) pixels_[at] &= sharp[y / kTogether * across + x / kTogether];
}

bool FinerPlaces::any() const {
    return std::ranges::any_of(pixels_, [](std::uint8_t pixel) { return pixel != 0; });
}

PictureRect FinerPlaces::boundsIn(const PictureRect& part, std::uint32_t n) const {
    std::uint32_t left = part.width, top = part.height, right = 0, bottom = 0;
    for (std::uint32_t y = 0; y < part.height; ++y)
        for (std::uint32_t x = 0; x < part.width; ++x) {
            if (n == 0 ? !finer(part.x + x, part.y + y) : !needs(part.x + x, part.y + y, n)) continue;
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

std::vector<PictureRect> FinerPlaces::bandsIn(const PictureRect& part) const {
    constexpr std::uint32_t kRows = 2 * PictureRect::kStep;
    std::vector<PictureRect> bands;
    for (std::uint32_t y = 0; y < part.height; y += kRows) {
        const PictureRect band = boundsIn({part.x, part.y + y, part.width, std::min(kRows, part.height - y)});
        if (band.width > 0) bands.push_back(band);
    }
    return bands;
}

TileMask FinerPlaces::findTiles(const PictureRect& shown, const PictureRect& wanted, std::uint32_t n) const {
    const std::uint32_t side = TileMask::kSide / n;  // of a quarter, in pixels of the picture
    TileMask mask;
    mask.across = (shown.width + side - 1) / side;
    mask.wanted.resize(std::size_t{mask.across} * ((shown.height + side - 1) / side));
    for (std::uint32_t y = wanted.y; y < wanted.y + wanted.height; ++y)
        for (std::uint32_t x = wanted.x; x < wanted.x + wanted.width; ++x)
            if (needs(x, y, n)) mask.wanted[std::size_t{(y - shown.y) / side} * mask.across + (x - shown.x) / side] = 1;
    return mask;
}

std::pair<passes::EdgePlaces, TileMask> FinerPlaces::findEdges(const PictureRect& shown,
                                                               const PictureRect& wanted) const {
    constexpr std::uint32_t kSide = TileMask::kSide;
    passes::EdgePlaces edges{shown.width, std::vector<std::uint8_t>(std::size_t{shown.width} * shown.height)};
    TileMask mask;
    mask.across = (shown.width + kSide - 1) / kSide;
    mask.wanted.resize(std::size_t{mask.across} * ((shown.height + kSide - 1) / kSide));
    for (std::uint32_t y = wanted.y; y < wanted.y + wanted.height; ++y)
        for (std::uint32_t x = wanted.x; x < wanted.x + wanted.width; ++x) {
            if (!finer(x, y)) continue;
            const std::uint32_t left = x - shown.x, top = y - shown.y;
            edges.pixels[std::size_t{top} * shown.width + left] = 1;
            // Samples need the pixels around them.
            for (std::uint32_t row = (top - std::min(top, 1u)) / kSide;
                 row <= std::min(top + 1, shown.height - 1) / kSide; ++row)
                for (std::uint32_t at = (left - std::min(left, 1u)) / kSide;
                     at <= std::min(left + 1, shown.width - 1) / kSide; ++at)
                    mask.wanted[std::size_t{row} * mask.across + at] = 1;
        }
    return {std::move(edges), std::move(mask)};
}

}  // namespace nacre
