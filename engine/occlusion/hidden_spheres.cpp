#include "engine/occlusion/hidden_spheres.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>

namespace nacre {
namespace {

constexpr float kNothing = std::numeric_limits<float>::lowest();
constexpr float kCellsPerRadius = 6, kMostCells = 1024;
constexpr float kMargin = 0.01f, kRounding = 1e-5f;  // for rounding: Å, and share of the scene's size

/// Square cells on a plane across the view. Each has the height below which one sphere covers all of it.
class Cells {
public:
    /// @param discs  finite: positions on the plane, heights, and radii, Å
    explicit Cells(std::span<const glm::vec4> discs) {
        glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
        float radii = 0, largest = 0;
        for (const glm::vec4& d : discs) {
            low = glm::min(low, glm::vec2(d) - d.w);
            high = glm::max(high, glm::vec2(d) + d.w);
            radii += d.w;
            largest = std::max(largest, d.w);
        }
        const glm::vec2 size = high - low;
        side_ =
            std::max(radii / static_cast<float>(discs.size()) / kCellsPerRadius, std::max(size.x, size.y) / kMostCells);
        valid_ = std::isfinite(side_) && side_ > 0 && 2 * side_ <= largest;  // else no cell is inside a disc
        if (!valid_) return;
        corner_ = low;
        margin_ = kMargin + kRounding * std::max(size.x, size.y);
        across_ = static_cast<int>(size.x / side_) + 1;
        down_ = static_cast<int>(size.y / side_) + 1;
        heights_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_), kNothing);
    }
    bool valid() const { return valid_; }

    /// Covers the cells inside a disc.
    void cover(const glm::vec4& disc) {
        const float x = place(disc.x, corner_.x), y = place(disc.y, corner_.y);
        const float radius = (disc.w - margin_) / side_;
        for (int row = first(y - radius); row <= last(y + radius, down_); ++row) {
            const float above = farthest(row, y), rest = radius * radius - above * above;
            if (rest <= 0) continue;
            const float half = std::sqrt(rest);
            float* heights = rowOf(row);
            for (int i = first(x - half); i <= last(x + half, across_); ++i) {
                const float aside = farthest(i, x), deep = rest - aside * aside;
                if (deep > 0) heights[i] = std::max(heights[i], disc.z + std::sqrt(deep) * side_);
            }
        }
    }

    /// Whether all cells that a disc touches are covered above its sphere.
    bool hide(const glm::vec4& disc) const {
        const float x = place(disc.x, corner_.x), y = place(disc.y, corner_.y);
        const float radius = (disc.w + margin_) / side_, top = disc.z + disc.w + margin_;
        for (int row = first(y - radius); row <= last(y + radius, down_); ++row) {
            const float above = nearest(row, y), rest = radius * radius - above * above;
            if (rest < 0) continue;
            const float half = std::sqrt(rest);
            const float* heights = rowOf(row);
            for (int i = first(x - half); i <= last(x + half, across_); ++i)
                if (!(heights[i] > top)) return false;
        }
        return true;
    }

private:
    float place(float at, float corner) const { return (at - corner) / side_; }
    static int first(float at) { return static_cast<int>(std::max(at, 0.0f)); }
    static int last(float at, int count) { return std::min(static_cast<int>(at), count - 1); }
    /// Distance of a place from the far end of a cell, and from its nearest point.
    static float farthest(int cell, float at) { return std::abs(static_cast<float>(cell) + 0.5f - at) + 0.5f; }
    static float nearest(int cell, float at) {
        return std::max(std::abs(static_cast<float>(cell) + 0.5f - at) - 0.5f, 0.0f);
    }
    std::size_t startOf(int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(across_); }
    float* rowOf(int row) { return heights_.data() + startOf(row); }
    const float* rowOf(int row) const { return heights_.data() + startOf(row); }

    bool valid_ = false;
    float side_ = 1, margin_ = 0;  // Å
    glm::vec2 corner_{};
    int across_ = 0, down_ = 0;
    std::vector<float> heights_;
};

}  // namespace

std::vector<bool> hiddenSpheres(std::span<const Sphere> spheres, const glm::dvec3& towards,
                                const std::stop_token& stop) {
    const glm::dvec3 other = std::abs(towards.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, towards)), up = glm::cross(towards, glm::dvec3(right));
    const glm::vec3 view = towards;
    std::vector<glm::vec4> discs;
    discs.reserve(spheres.size());
    for (const Sphere& s : spheres) {
        const float sum = s.center.x + s.center.y + s.center.z + s.radius;
        if (!std::isfinite(sum)) return std::vector<bool>(spheres.size(), false);
        discs.emplace_back(glm::dot(right, s.center), glm::dot(up, s.center), glm::dot(view, s.center), s.radius);
    }
    std::vector<bool> hidden(spheres.size(), false);
    if (discs.empty()) return hidden;
    Cells cells(discs);
    if (!cells.valid()) return hidden;
    // From near to far: what is hidden hides nothing more.
    std::vector<std::uint32_t> order(discs.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return discs[a].z + discs[a].w > discs[b].z + discs[b].w; });
    for (const std::uint32_t i : order) {
        if (stop.stop_requested()) break;
        hidden[i] = cells.hide(discs[i]);
        if (!hidden[i]) cells.cover(discs[i]);
    }
    return hidden;
}

}  // namespace nacre
