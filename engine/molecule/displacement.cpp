#include "engine/molecule/displacement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

namespace nacre {

glm::dmat3 tensorMatrix(const Displacement& u) {
    return {u.u11, u.u12, u.u13, u.u12, u.u22, u.u23, u.u13, u.u23, u.u33};
}

Displacement toDisplacement(const glm::dmat3& u) {
    constexpr double kMost = 1e6 * kLargestDisplacement;
    const auto part = [&](int i, int j) {
        return static_cast<float>(std::clamp((u[i][j] + u[j][i]) / 2, -kMost, kMost));
    };
    return {part(0, 0), part(1, 1), part(2, 2), part(0, 1), part(0, 2), part(1, 2)};
}

/// By rotations. C. G. J. Jacobi, Journal für die reine und angewandte Mathematik 30 (1846) 51.
PrincipalAxes principalAxes(glm::dmat3 m) {
    glm::dmat3 turned(1.0);  // its columns become the axes
    for (int sweep = 0; sweep < 50; ++sweep) {
        if (m[0][1] * m[0][1] + m[0][2] * m[0][2] + m[1][2] * m[1][2] == 0) break;
        for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            if (m[i][j] == 0) continue;
            const double half = (m[j][j] - m[i][i]) / (2 * m[i][j]);
            const double tangent = (half < 0 ? -1 : 1) / (std::abs(half) + std::hypot(half, 1.0));
            const double cosine = 1 / std::hypot(tangent, 1.0), sine = tangent * cosine;
            glm::dmat3 turn(1.0);
            turn[i][i] = turn[j][j] = cosine;
            turn[j][i] = sine;
            turn[i][j] = -sine;
            m = glm::transpose(turn) * m * turn;
            m[i][j] = m[j][i] = 0;  // up to rounding
            turned = turned * turn;
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return m[a][a] > m[b][b]; });
    PrincipalAxes axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes.values[i] = m[order[i]][order[i]];
        axes.ways[i] = turned[order[i]];
    }
    return axes;
}

std::optional<std::array<glm::dvec3, 3>> displacementAxes(const Displacement& u) {
    constexpr double kLeast = 1e-6;  // Å^2; files state four or five digits
    const PrincipalAxes axes = principalAxes(tensorMatrix(u));
    if (!(axes.values[2] >= kLeast && axes.values[0] <= kLargestDisplacement)) return std::nullopt;
    std::array<glm::dvec3, 3> half{};
    for (std::size_t i = 0; i < 3; ++i) half[i] = axes.ways[i] * std::sqrt(axes.values[i]);
    if (glm::dot(glm::cross(half[0], half[1]), half[2]) < 0) half[2] = -half[2];
    return half;
}

double probabilityScale(double percent) {
    const auto within = [](double r) {
        return std::erf(r / std::numbers::sqrt2) - std::sqrt(2 / std::numbers::pi) * r * std::exp(-r * r / 2);
    };
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (within(middle) * 100 < percent ? low : high) = middle;
    }
    return low;
}

void turnDisplacement(Molecule& molecule, std::size_t atom, const glm::dmat3& rotation) {
    if (molecule.displacements.empty() || !molecule.displacements[atom].stated()) return;
    Displacement& u = molecule.displacements[atom];
    u = toDisplacement(rotation * tensorMatrix(u) * glm::transpose(rotation));
}

}  // namespace nacre
