#include "engine/volume/unit_cell.h"

#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double kLongestEdge = 1e6;  // Å
constexpr double kFlattest = 1e-4;    // minimum volume of a cell with edges of 1

double cosine(double degrees) { return degrees == 90 ? 0 : std::cos(degrees * std::numbers::pi / 180); }

/// Squared volume of a cell with edges of 1.
double unitVolume2(const glm::dvec3& angles) {
    const double a = cosine(angles.x), b = cosine(angles.y), c = cosine(angles.z);
    return 1 - a * a - b * b - c * c + 2 * a * b * c;
}

}  // namespace

bool UnitCell::isValid() const {
    for (int i = 0; i < 3; ++i)
        if (!(lengths[i] > 0 && lengths[i] <= kLongestEdge && angles[i] > 0 && angles[i] < 180)) return false;
    return unitVolume2(angles) > kFlattest * kFlattest;
}

glm::dmat3 UnitCell::edges() const {
    const double a = cosine(angles.x), b = cosine(angles.y), c = cosine(angles.z);
    const double sine = std::sqrt(1 - c * c), height = std::sqrt(unitVolume2(angles)) / sine;
    return {glm::dvec3(1, 0, 0) * lengths.x, glm::dvec3(c, sine, 0) * lengths.y,
            glm::dvec3(b, (a - b * c) / sine, height) * lengths.z};
}

}  // namespace nacre
