#include "engine/scene/front_triangles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "engine/scene/tile_lists.h"

namespace nacre {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kBehindAll = -std::numeric_limits<float>::max();

float side(float ax, float ay, float bx, float by) { return ax * by - ay * bx; }

}  // namespace

/// A triangle in the picture, counter-clockwise.
struct FrontTriangles::Shape {
    glm::vec3 a, b, c;          // pixel and key
    float roomA, roomB, roomC;  // of an edge function, on the edge across from the corner: what rounding does to it
    float perArea;              // 1 / (twice its area)
    float nearest;              // key
    float error;                // of a key within it
    bool splinter;              // so narrow that nothing about it is certain
};

void FrontTriangles::begin(const TileView& view) {
    width_ = view.width;
    height_ = view.height;
    perspective_ = view.perspective;
    axisX_ = view.axis.x;
    axisY_ = view.axis.y;
    clipNear_ = view.clipNear;
    clipFar_ = view.clipFar;
    // Single precision has 6e-8 of the largest number, and some ten roundings follow one another.
    error_ = 1e-6f * view.range * view.pixels;
    errorOfZ_ = 1e-6f * std::max(view.range, view.origin);
    drawn_ = 0;
    pixels_.resize(std::max<std::size_t>(pixels_.size(), std::size_t{width_} * height_));
    rows_.assign(height_, false);
    doubts_.clear();
}

void FrontTriangles::meet(Pixel& pixel, float key, float error, bool certain, std::uint32_t index) {
    if (pixel.index != kNone && key + error < pixel.key - pixel.error) return;  // behind
    const bool wins = pixel.index == kNone || key - error > pixel.key + pixel.error;
    if (!certain) {
        doubts_.push_back(index);
    } else if (wins) {
        pixel = {key, error, index};
    } else if (key > pixel.key) {
        doubts_.push_back(pixel.index);
        pixel = {key, error, index};
    } else {
        doubts_.push_back(index);
    }
}

void FrontTriangles::drawShape(const Shape& s, std::uint32_t index) {
    const float left = std::min(s.a.x, std::min(s.b.x, s.c.x)), right = std::max(s.a.x, std::max(s.b.x, s.c.x));
    const float top = std::min(s.a.y, std::min(s.b.y, s.c.y)), bottom = std::max(s.a.y, std::max(s.b.y, s.c.y));
    constexpr float kRoom = 1.0f / 32;
    // Whole numbers are cut off towards 0, where the picture begins.
    const auto pixelAt = [](float place, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::clamp(place, 0.0f, static_cast<float>(size)));
    };
    const std::uint32_t firstX = pixelAt(left + (0.5f - kRoom), width_), endX = pixelAt(right + (0.5f + kRoom), width_);
    const std::uint32_t firstY = pixelAt(top + (0.5f - kRoom), height_),
                        endY = pixelAt(bottom + (0.5f + kRoom), height_);
    if (firstX >= endX) return;
    for (std::uint32_t y = firstY; y < endY; ++y) {
        Pixel* row = pixels_.data() + std::size_t{y} * width_;
        if (!rows_[y]) std::fill_n(row, width_, Pixel{kBehindAll, 0, kNone}), rows_[y] = true;
        const float ay = s.a.y - (static_cast<float>(y) + 0.5f), by = s.b.y - (static_cast<float>(y) + 0.5f),
                    cy = s.c.y - (static_cast<float>(y) + 0.5f);
        for (std::uint32_t x = firstX; x < endX; ++x) {
            const float at = static_cast<float>(x) + 0.5f;
            const float ax = s.a.x - at, bx = s.b.x - at, cx = s.c.x - at;
            const float ofA = side(bx, by, cx, cy), ofB = side(cx, cy, ax, ay), ofC = side(ax, ay, bx, by);
            if (ofA < -s.roomA || ofB < -s.roomB || ofC < -s.roomC) continue;
            if (s.splinter) {
                meet(row[x], s.nearest, 0, false, index);
                continue;
            }
            const float key = (ofA * s.a.z + ofB * s.b.z + ofC * s.c.z) * s.perArea;
            bool certain = ofA > s.roomA && ofB > s.roomB && ofC > s.roomC;
            const float Z = perspective_ ? 1.0f / key : -key;
            const float room = perspective_ ? s.error * Z * Z : s.error;
            if (Z + room < clipNear_ || Z - room > clipFar_) continue;
            if (Z - room <= clipNear_ || Z + room >= clipFar_) certain = false;
            meet(row[x], key, s.error, certain, index);
        }
    }
}

void FrontTriangles::draw(std::span<const Triangle> triangles, std::span<const glm::vec3> corners) {
    for (const Triangle& t : triangles) {
        const std::uint32_t index = drawn_++;
        glm::vec3 a = corners[t.a], b = corners[t.b], c = corners[t.c];
        const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        if (perspective_ && !(low.z > 0)) {
            doubts_.push_back(index);
            continue;
        }
        // Most hold no centre, which is known at once.
        if (std::floor(high.x - 0.5f + 1.0f / 32) < low.x - 0.5f - 1.0f / 32) continue;
        if (std::floor(high.y - 0.5f + 1.0f / 32) < low.y - 0.5f - 1.0f / 32) continue;
        float area = side(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
        if (area < 0) std::swap(b, c), area = -area;
        const float off = std::max(std::max(std::abs(low.x - axisX_), std::abs(high.x - axisX_)),
                                   std::max(std::abs(low.y - axisY_), std::abs(high.y - axisY_)));
        const float error = error_ + 2e-6f * off;
        const auto length = [](const glm::vec3& from, const glm::vec3& to) {
            return std::abs(to.x - from.x) + std::abs(to.y - from.y);
        };
        const float ab = length(a, b), bc = length(b, c), ca = length(c, a), around = ab + bc + ca;
        Shape s{a, b, c, 2 * error * bc, 2 * error * ca, 2 * error * ab, 1 / area, 0, 0, area < 16 * error * around};
        for (glm::vec3* corner : {&s.a, &s.b, &s.c}) corner->z = perspective_ ? 1 / corner->z : -corner->z;
        s.nearest = std::max(s.a.z, std::max(s.b.z, s.c.z));
        const float farthest = std::min(s.a.z, std::min(s.b.z, s.c.z));
        // A key may be off by as much as it rises on the way that a corner is off, and by what Z is rounded.
        s.error = 4 * error * (s.nearest - farthest) * around * s.perArea +
                  errorOfZ_ * (perspective_ ? s.nearest * s.nearest : 1.0f);
        drawShape(s, index);
    }
}

void FrontTriangles::end() {
    front_.assign((std::size_t{drawn_} + 63) / 64, 0);
    const auto mark = [&](std::uint32_t index) { front_[index / 64] |= std::uint64_t{1} << index % 64; };
    for (std::uint32_t y = 0; y < height_; ++y) {
        if (!rows_[y]) continue;
        const Pixel* row = pixels_.data() + std::size_t{y} * width_;
        for (std::uint32_t x = 0; x < width_; ++x)
            if (row[x].index != kNone) mark(row[x].index);
    }
    for (const std::uint32_t index : doubts_) mark(index);
}

std::size_t FrontTriangles::next(std::size_t index) const {
    for (std::size_t word = index / 64; word < front_.size(); ++word) {
        const std::uint64_t bits =
            front_[word] & (word == index / 64 ? ~std::uint64_t{0} << index % 64 : ~std::uint64_t{0});
        if (bits != 0) return 64 * word + static_cast<std::size_t>(std::countr_zero(bits));
    }
    return 64 * front_.size();
}

}  // namespace nacre
