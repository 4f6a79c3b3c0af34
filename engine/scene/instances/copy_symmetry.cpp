// Which copies of an assembly see the same surroundings.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/scene/instances/copies.h"

namespace nacre {
namespace {

constexpr std::size_t kMostCopies = 4096;  // the search takes quadratic time
constexpr double kTolerance = 0.1;         // Å

/// A rigid motion: rotation (or reflection) and shift.
struct Motion {
    glm::dmat3 turn{1.0};
    glm::dvec3 shift{};

    explicit Motion(const glm::dmat4x3& m) : turn(m[0], m[1], m[2]), shift(m[3]) {}
    Motion(const glm::dmat3& t, const glm::dvec3& s) : turn(t), shift(s) {}
    Motion inverse() const {
        const glm::dmat3 back = glm::transpose(turn);
        return {back, -(back * shift)};
    }
    friend Motion operator*(const Motion& after, const Motion& before) {
        return {after.turn * before.turn, after.turn * before.shift + after.shift};
    }
};

/// Finds a motion among others by binary search, on where each moves one generic point.
class MotionTable {
public:
    MotionTable(const std::vector<Motion>& motions, double reach) : motions_(motions), reach_(reach) {
        for (std::uint32_t i = 0; i < motions.size(); ++i) sorted_.push_back({computeMark(motions[i]), i});
        std::sort(sorted_.begin(), sorted_.end());
    }
    /// Index of a motion that agrees with `wanted` within the tolerance everywhere within reach; or -1.
    std::int64_t find(const Motion& wanted) const {
        const double mark = computeMark(wanted);
        const std::pair<double, std::uint32_t> from{mark - kTolerance, 0};
        for (auto it = std::lower_bound(sorted_.begin(), sorted_.end(), from);
             it != sorted_.end() && it->first <= mark + kTolerance; ++it)
            if (same(motions_[it->second], wanted)) return it->second;
        return -1;
    }

private:
    /// Coordinate of the moved generic point, which is within reach and on no symmetry axis.
    double computeMark(const Motion& m) const {
        return (m.turn * (glm::dvec3(0.4273, -0.6131, 0.5417) * reach_) + m.shift).x;
    }
    bool same(const Motion& a, const Motion& b) const {
        // The ends of the axes move the farthest; the origin moves by the shift.
        double most = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-reach_, reach_}) {
                const glm::dvec3 apart = (a.turn[axis] - b.turn[axis]) * side + a.shift - b.shift;
                most = std::max({most, std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)});
            }
        return most <= kTolerance;
    }

    const std::vector<Motion>& motions_;
    double reach_;
    std::vector<std::pair<double, std::uint32_t>> sorted_;
};

}  // namespace

std::vector<std::uint32_t> representativeCopies(const std::vector<glm::dmat4x3>& transforms,
                                                const std::vector<std::uint32_t>& list, double reach) {
    if (list.size() > kMostCopies) return list;
    std::vector<Motion> motions;
    motions.reserve(list.size());
    for (const std::uint32_t i : list) motions.emplace_back(transforms[i]);
    const MotionTable table(motions, reach);
    // Joins copies related by a symmetry; the lowest index represents a group.
    std::vector<std::uint32_t> group(list.size());
    for (std::uint32_t i = 0; i < group.size(); ++i) group[i] = i;
    const auto root = [&](std::uint32_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    const Motion home = motions.front().inverse();
    std::vector<std::uint32_t> image(list.size());
    for (std::uint32_t to = 1; to < motions.size(); ++to) {
        const Motion candidate = motions[to] * home;
        bool symmetry = true;
        for (std::uint32_t i = 0; symmetry && i < motions.size(); ++i) {
            const std::int64_t found = table.find(candidate * motions[i]);
            symmetry = found >= 0;
            image[i] = static_cast<std::uint32_t>(found);
        }
        for (std::uint32_t i = 0; symmetry && i < motions.size(); ++i) {
            const std::uint32_t a = root(i), b = root(image[i]);
            group[std::max(a, b)] = std::min(a, b);
        }
    }
    std::vector<std::uint32_t> representatives;
    for (std::uint32_t i = 0; i < group.size(); ++i)
        if (group[i] == i) representatives.push_back(list[i]);
    return representatives;
}

}  // namespace nacre
