#include "engine/scene/build/atom_ellipsoids.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/molecule/displacement.h"
#include "engine/molecule/element.h"

namespace nacre {
namespace {

constexpr double kInside = 0.8;  // of the distance to the surface, or of the shortest axis: within the coarsest mesh

/// Signs of the axes of the octant that faces a viewer.
glm::dvec3 facingSigns(const std::array<glm::dvec3, 3>& axes, const Atom& atom, const glm::dvec4& viewer) {
    const glm::dvec3 way = glm::dvec3(viewer) - viewer.w * glm::dvec3(atom.position);
    const auto sign = [&](const glm::dvec3& axis) { return glm::dot(axis, way) < 0 ? -1.0 : 1.0; };
    return {sign(axes[0]), sign(axes[1]), sign(axes[2])};
}

std::optional<std::array<glm::dvec3, 3>> statedAxes(const Molecule& molecule, std::uint32_t atom) {
    if (molecule.displacements.empty() || !molecule.displacements[atom].stated()) return std::nullopt;
    return displacementAxes(molecule.displacements[atom]);
}

}  // namespace

AtomEllipsoids::AtomEllipsoids(const Molecule& molecule, double percent, const std::optional<glm::dvec4>& viewer)
    : molecule_(molecule), scale_(probabilityScale(percent)), viewer_(viewer) {}

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

std::optional<glm::dvec3> AtomEllipsoids::cut(std::uint32_t atom) const {
    const auto own = viewer_ ? axes(atom) : std::nullopt;
    if (!own) return std::nullopt;
    return facingSigns(*own, molecule_.atoms[atom], *viewer_);
}

double AtomEllipsoids::ball(std::uint32_t atom) const {
    const auto own = axes(atom);
    if (!own) return sphere(molecule_.atoms[atom]);
    return viewer_ ? double{kCutBall} : kInside * glm::length((*own)[2]);
}

double AtomEllipsoids::bondEnd(std::uint32_t atom, const glm::dvec3& way) const {
    const auto signs = cut(atom);
    if (!signs) return 0;
    const auto own = *axes(atom);
    bool open = true;  // the bond leaves through the cut
    for (std::size_t i = 0; i < 3; ++i) open = open && glm::dot(own[i], way) * (*signs)[static_cast<int>(i)] > 0;
    return open ? 0 : bondEndInCopies(atom, way);
}

double AtomEllipsoids::bondEndInCopies(std::uint32_t atom, const glm::dvec3& way) const {
    const auto own = viewer_ ? axes(atom) : std::nullopt;
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

double ballOfWhole(const Molecule& molecule, std::uint32_t atom, double reach) {
    const auto axes = statedAxes(molecule, atom);
    return axes ? kInside * reach * glm::length((*axes)[2]) / glm::length((*axes)[0]) : reach;
}

std::vector<std::uint8_t> facingOctants(const Molecule& molecule, const glm::dvec4& viewer) {
    std::vector<std::uint8_t> octants(molecule.atoms.size(), kNoOctant);
    for (std::uint32_t atom = 0; atom < octants.size(); ++atom)
        if (const auto axes = statedAxes(molecule, atom)) {
            const glm::dvec3 signs = facingSigns(*axes, molecule.atoms[atom], viewer);
            octants[atom] = static_cast<std::uint8_t>((signs.x < 0) | (signs.y < 0) << 1 | (signs.z < 0) << 2);
        }
    return octants;
}

std::uint32_t faceColor(std::uint32_t color) {
    std::uint32_t face = color & 0xff000000u;
    for (const int shift : {0, 8, 16}) face |= ((color >> shift & 255) + 3 * 255) / 4 << shift;
    return face;
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
