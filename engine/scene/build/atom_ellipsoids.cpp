#include "engine/scene/build/atom_ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/molecule/displacement.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr double kInside = 0.8;  // of the distance to the surface

std::optional<std::array<glm::dvec3, 3>> statedAxes(const Molecule& molecule, std::uint32_t atom) {
    if (molecule.displacements.empty() || !molecule.displacements[atom].stated()) return std::nullopt;
    return displacementAxes(molecule.displacements[atom]);
}

}  // namespace

AtomEllipsoids::AtomEllipsoids(const Molecule& molecule, double percent)
    : molecule_(molecule), scale_(probabilityScale(percent)) {}

std::optional<std::array<glm::dvec3, 3>> AtomEllipsoids::axes(std::uint32_t atom) const {
    auto axes = statedAxes(molecule_, atom);
    if (axes)
        for (glm::dvec3& axis : *axes) axis *= scale_;
    return axes;
}

double AtomEllipsoids::sphere(const Atom& atom) const {
    constexpr double kSmall = 0.1;  // Å
    if (isHydrogen(atom.element) || !(atom.temperatureFactor > 0)) return kSmall;
    const double u = static_cast<double>(atom.temperatureFactor) / kEightPiSquared;
    return scale_ * std::sqrt(std::min(u, kLargestDisplacement));
}

double AtomEllipsoids::bondEnd(std::uint32_t atom, const glm::dvec3& way) const {
    const auto own = axes(atom);
    if (!own) return 0;
    double square = 0;
    for (const glm::dvec3& axis : *own) {
        const double share = glm::dot(axis, way) / glm::dot(axis, axis);
        square += share * share;
    }
    return kInside / std::sqrt(square);
}

double AtomEllipsoids::reach(std::uint32_t atom) const {
    const auto own = axes(atom);
    return own ? glm::length((*own)[0]) : sphere(molecule_.atoms[atom]);
}

std::vector<std::string> AtomEllipsoids::warnings(std::span<const std::uint32_t> atoms) const {
    std::size_t isotropic = 0, indefinite = 0, unknown = 0;
    for (const std::uint32_t atom : atoms) {
        if (axes(atom) || isHydrogen(molecule_.atoms[atom].element)) continue;
        const bool stated = !molecule_.displacements.empty() && molecule_.displacements[atom].stated();
        ++(stated ? indefinite : molecule_.atoms[atom].temperatureFactor > 0 ? isotropic : unknown);
    }
    std::vector<std::string> warnings;
    const auto say = [&](std::size_t count, const std::string& one, const std::string& many) {
        if (count > 0) warnings.push_back(std::to_string(count) + (count == 1 ? " atom " + one : " atoms " + many));
    };
    say(isotropic, "has no anisotropic displacement: a sphere of its B factor is drawn",
        "have no anisotropic displacement: spheres of their B factors are drawn");
    say(indefinite, "has a displacement tensor that is not positive definite: a sphere of its B factor is drawn",
        "have displacement tensors that are not positive definite: spheres of their B factors are drawn");
    say(unknown, "has no displacement and no B factor: a small ball is drawn",
        "have no displacement and no B factor: small balls are drawn");
    return warnings;
}

std::uint32_t bandColor(std::uint32_t color) {
    constexpr std::uint32_t kDark = 3 * 60;
    const auto part = [&](int shift) { return color >> shift & 255; };
    const bool light = part(0) + part(8) + part(16) < kDark;
    std::uint32_t band = color & 0xff000000u;
    for (const int shift : {0, 8, 16}) band |= (light ? (part(shift) + 255) / 2 : part(shift) * 3 / 10) << shift;
    return band;
}

}  // namespace nacre
