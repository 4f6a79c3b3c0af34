#include "engine/molecule/superpose.h"

#include <algorithm>
#include <cmath>
#include <gemmi/qcp.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace nacre {
namespace {

glm::dvec3 middle(std::span<const glm::dvec3> points) {
    glm::dvec3 sum{};
    for (const glm::dvec3& point : points) sum += point;
    return sum / static_cast<double>(points.size());
}

/// The smallest rotation that takes one unit vector to another.
glm::dmat3 turnFromTo(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 axis = glm::cross(from, to);
    const double sine = glm::length(axis), angle = std::atan2(sine, glm::dot(from, to));
    if (sine > 1e-12) return glm::mat3_cast(glm::angleAxis(angle, axis / sine));
    if (angle < 1) return glm::dmat3(1.0);
    const glm::dvec3 aside = std::abs(from.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::mat3_cast(glm::angleAxis(angle, glm::normalize(glm::cross(from, aside))));
}

double computeRmsd(const Superposition& s, std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving) {
    double sum = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        const glm::dvec3 d = s(moving[i]) - fixed[i];
        sum += glm::dot(d, d);
    }
    return std::sqrt(sum / static_cast<double>(fixed.size()));
}

/// Vector from the middle to the point farthest from it.
glm::dvec3 farthestFrom(const glm::dvec3& middle, std::span<const glm::dvec3> points) {
    glm::dvec3 farthest{};
    for (const glm::dvec3& point : points)
        if (glm::length(point - middle) > glm::length(farthest)) farthest = point - middle;
    return farthest;
}

/// Whether points are collinear or coincident, within 1e-4 of their extent.
bool onALine(std::span<const glm::dvec3> points) {
    const glm::dvec3 m = middle(points), line = farthestFrom(m, points);
    const double length = glm::length(line);
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
        return !(glm::length(glm::cross(point - m, line)) > 1e-4 * length * length);
    });
}

/// Points on a line leave the rotation about it open: among all best motions, returns the one that rotates least.
Superposition superposeLines(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving) {
    const glm::dvec3 a = middle(fixed), b = middle(moving);
    const bool fixedLine = onALine(fixed);
    const glm::dvec3 line = fixedLine ? farthestFrom(a, fixed) : farthestFrom(b, moving);
    glm::dvec3 other{};
    for (std::size_t i = 0; i < fixed.size(); ++i)
        other +=
            fixedLine ? glm::dot(fixed[i] - a, line) * (moving[i] - b) : glm::dot(moving[i] - b, line) * (fixed[i] - a);
    Superposition s;
    if (glm::length(other) > 0)
        s.rotation = fixedLine ? turnFromTo(glm::normalize(other), glm::normalize(line))
                               : turnFromTo(glm::normalize(line), glm::normalize(other));
    s.shift = a - s.rotation * b;
    s.rmsd = computeRmsd(s, fixed, moving);
    return s;
}

}  // namespace

Superposition superpose(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving) {
    // For such points the polynomial has no solution, or many.
    if (onALine(fixed) || onALine(moving)) return superposeLines(fixed, moving);
    const auto positions = [&](std::span<const glm::dvec3> points) {
        std::vector<gemmi::Position> list;
        list.reserve(points.size());
        for (const glm::dvec3& p : points) list.emplace_back(p.x, p.y, p.z);
        return list;
    };
    const std::vector<gemmi::Position> a = positions(fixed), b = positions(moving);
    const gemmi::SupResult result = gemmi::superpose_positions(a.data(), b.data(), a.size(), nullptr);
    Superposition s;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) s.rotation[column][row] = result.transform.mat[row][column];
    s.shift = {result.transform.vec.x, result.transform.vec.y, result.transform.vec.z};
    s.rmsd = computeRmsd(s, fixed, moving);
    return s;
}

PrunedSuperposition superposePruned(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving) {
    constexpr int kMostRounds = 5;
    constexpr double kOutlier = 2, kAlwaysKept = 0.1;  // times the RMSD; Å
    PrunedSuperposition pruned;
    pruned.motion = superpose(fixed, moving);
    pruned.rmsdOfAll = pruned.motion.rmsd;
    pruned.kept.assign(fixed.size(), 1);
    pruned.count = fixed.size();
    for (int round = 0; round < kMostRounds; ++round) {
        std::vector<glm::dvec3> to, from;
        const double most = std::max(kOutlier * pruned.motion.rmsd, kAlwaysKept);
        for (std::size_t i = 0; i < fixed.size(); ++i) {
            if (!pruned.kept[i]) continue;
            pruned.kept[i] = glm::distance(pruned.motion(moving[i]), fixed[i]) <= most;
            if (!pruned.kept[i]) continue;
            to.push_back(fixed[i]);
            from.push_back(moving[i]);
        }
        if (to.size() == pruned.count) break;
        pruned.count = to.size();
        pruned.motion = superpose(to, from);
    }
    return pruned;
}

}  // namespace nacre
