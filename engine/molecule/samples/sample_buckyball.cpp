// C60: the truncated icosahedron, with its two bond lengths.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "engine/molecule/samples/samples.h"

namespace nacre {
namespace {

// K. Hedberg et al., Science 254 (1991) 410-412, electron diffraction of the gas, Å.
constexpr double kPentagonBond = 1.458;  // between a pentagon and a hexagon: single
constexpr double kHexagonBond = 1.401;   // between two hexagons: double

std::vector<glm::dvec3> icosahedron(double edge) {
    std::vector<glm::dvec3> corners;
    const double a = edge / 2;
    const double b = a * std::numbers::phi;
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-1.0, 1.0}) {
            corners.push_back({0, s * a, t * b});
            corners.push_back({s * a, t * b, 0});
            corners.push_back({t * b, 0, s * a});
        }
    }
    return corners;
}

}  // namespace

Molecule sampleBuckyball() {
    SampleBuilder builder("Buckminsterfullerene C60");
    builder.chain("A");
    builder.residue("60C", 1, true);

    // Each edge of the icosahedron is cut one pentagon bond from both ends; the rest is the double bond.
    const double edge = kHexagonBond + 2 * kPentagonBond;
    const std::vector<glm::dvec3> corners = icosahedron(edge);
    std::vector<glm::dvec3> positions;
    for (const glm::dvec3& from : corners) {
        for (const glm::dvec3& to : corners) {
            const double length = glm::distance(from, to);
            if (length < 0.5 * edge || length > 1.1 * edge) continue;
            positions.push_back(from + (to - from) * (kPentagonBond / edge));
        }
    }
    for (std::size_t i = 0; i < positions.size(); ++i) builder.atom("C" + std::to_string(i + 1), "C", positions[i]);
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        for (std::uint32_t j = i + 1; j < positions.size(); ++j) {
            const double length = glm::distance(positions[i], positions[j]);
            if (std::abs(length - kPentagonBond) < 1e-6) builder.bond(i, j, 1);
            if (std::abs(length - kHexagonBond) < 1e-6) builder.bond(i, j, 2);
        }
    }
    return builder.finish();
}

}  // namespace nacre
