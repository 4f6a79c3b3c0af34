// alpha-D-glucopyranose in the 4C1 chair, built from bond lengths and angles.

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <string>

#include "engine/molecule/samples/samples.h"

namespace nacre {
namespace {

// Means over crystal structures, Å: F. H. Allen et al., J. Chem. Soc. Perkin Trans. 2 (1987) S1-S19; rounded.
constexpr double kCarbonCarbon = 1.53;
constexpr double kCarbonOxygen = 1.43;
constexpr double kCarbonHydrogen = 1.10;
constexpr double kOxygenHydrogen = 0.97;

constexpr double fromDegrees(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double kTetrahedral = fromDegrees(109.4712206);
constexpr double kRingAngleAtCarbon = fromDegrees(110.0);
constexpr double kRingAngleAtOxygen = fromDegrees(113.5);

enum { C1, C2, C3, C4, C5, O5, kRingSize };
using Ring = std::array<glm::dvec3, kRingSize>;

double ringBond(int i) { return i == O5 || i == C5 ? kCarbonOxygen : kCarbonCarbon; }  // from atom i to the next
int next(int i) { return (i + 1) % kRingSize; }

/// Moves two points along their line until they are `wanted` apart.
void settle(glm::dvec3& a, glm::dvec3& b, double wanted) {
    const glm::dvec3 line = b - a;
    const glm::dvec3 half = line * (0.5 * (1 - wanted / glm::length(line)));
    a += half;
    b -= half;
}

/// Six bonds and six angles determine a six-membered chair, so that projecting onto them in turn finds it.
Ring chair() {
    Ring ring;
    // 4C1: C4 above and C1 below the plane of the others, seen from the side where the numbering runs clockwise.
    for (int i = 0; i < kRingSize; ++i) {
        const double angle = fromDegrees(-60.0 * i);
        ring[i] = {1.45 * std::cos(angle), 1.45 * std::sin(angle), i % 2 == 0 ? -0.25 : 0.25};
    }
    for (int round = 0; round < 2000; ++round) {
        for (int i = 0; i < kRingSize; ++i) {
            const int j = next(i);
            const int k = next(j);
            settle(ring[i], ring[j], ringBond(i));
            const double p = ringBond(i);
            const double q = ringBond(j);
            const double angle = j == O5 ? kRingAngleAtOxygen : kRingAngleAtCarbon;
            settle(ring[i], ring[k], std::sqrt(p * p + q * q - 2 * p * q * std::cos(angle)));
        }
    }
    return ring;
}

/// The two free directions of a tetrahedral atom with two neighbours, opened to the tetrahedral angle.
/// `axial` is the one along the ring's axis, `equatorial` the one around it.
struct Substituents {
    glm::dvec3 axial;
    glm::dvec3 equatorial;
};

Substituents substituents(const Ring& ring, int i) {
    const glm::dvec3 a = glm::normalize(ring[(i + kRingSize - 1) % kRingSize] - ring[i]);
    const glm::dvec3 b = glm::normalize(ring[next(i)] - ring[i]);
    const glm::dvec3 away = -glm::normalize(a + b);
    const glm::dvec3 side = glm::normalize(glm::cross(a, b));
    const glm::dvec3 one = away * std::cos(kTetrahedral / 2) + side * std::sin(kTetrahedral / 2);
    const glm::dvec3 two = away * std::cos(kTetrahedral / 2) - side * std::sin(kTetrahedral / 2);
    if (std::abs(one.z) > std::abs(two.z)) return {one, two};
    return {two, one};
}

/// The point bound to `c` at `length`, with the tetrahedral angle to `b` and the torsion a-b-c-point.
glm::dvec3 placeAtom(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, double length, double torsion) {
    const glm::dvec3 along = glm::normalize(c - b);
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, along));
    const glm::dvec3 inPlane = glm::cross(normal, along);
    const double across = std::sin(kTetrahedral);
    return c + length * (-std::cos(kTetrahedral) * along + across * std::cos(torsion) * inPlane +
                         across * std::sin(torsion) * normal);
}

/// Position along each hydroxyl's C-O bond where its hydrogen points, as torsion from the ring atom before it.
constexpr std::array<double, 4> kHydroxylTorsions = {fromDegrees(60), fromDegrees(180), fromDegrees(180),
                                                     fromDegrees(180)};

struct Hydroxyl {
    glm::dvec3 oxygen;
    glm::dvec3 hydrogen;
};

Hydroxyl hydroxyl(const Ring& ring, int i, glm::dvec3 direction) {
    const glm::dvec3 before = ring[(i + kRingSize - 1) % kRingSize];
    const glm::dvec3 oxygen = ring[i] + kCarbonOxygen * direction;
    return {oxygen, placeAtom(before, ring[i], oxygen, kOxygenHydrogen, kHydroxylTorsions[i])};
}

}  // namespace

Molecule sampleGlucose() {
    SampleBuilder builder("alpha-D-glucopyranose");
    builder.chain("A");
    builder.residue("GLC", 1, true);

    const Ring ring = chair();
    std::array<std::uint32_t, kRingSize> ringAtoms{};
    constexpr std::array<const char*, kRingSize> names = {"C1", "C2", "C3", "C4", "C5", "O5"};
    for (int i = 0; i < kRingSize; ++i) ringAtoms[i] = builder.atom(names[i], i == O5 ? "O" : "C", ring[i]);
    for (int i = 0; i < kRingSize; ++i) builder.bond(ringAtoms[i], ringAtoms[next(i)], 1);

    // In glucose every group is equatorial; alpha turns the one at C1 axial.
    for (int i = C1; i <= C4; ++i) {
        const auto [axial, equatorial] = substituents(ring, i);
        const Hydroxyl group = hydroxyl(ring, i, i == C1 ? axial : equatorial);
        const std::string number = std::to_string(i + 1);
        const auto oxygen = builder.atom("O" + number, "O", group.oxygen);
        const auto onOxygen = builder.atom("HO" + number, "H", group.hydrogen);
        const glm::dvec3 other = i == C1 ? equatorial : axial;
        const auto onCarbon = builder.atom("H" + number, "H", ring[i] + kCarbonHydrogen * other);
        builder.bond(ringAtoms[i], oxygen, 1);
        builder.bond(oxygen, onOxygen, 1);
        builder.bond(ringAtoms[i], onCarbon, 1);
    }

    const auto [axial, equatorial] = substituents(ring, C5);
    const auto h5 = builder.atom("H5", "H", ring[C5] + kCarbonHydrogen * axial);
    const glm::dvec3 carbon = ring[C5] + kCarbonCarbon * equatorial;
    // The gauche-trans rotamer, O5-C5-C6-O6 = +60 degrees, as in the crystal of alpha-D-glucose.
    const glm::dvec3 oxygen = placeAtom(ring[O5], ring[C5], carbon, kCarbonOxygen, fromDegrees(60));
    const auto c6 = builder.atom("C6", "C", carbon);
    const auto o6 = builder.atom("O6", "O", oxygen);
    const auto h61 = builder.atom("H61", "H", placeAtom(ring[O5], ring[C5], carbon, kCarbonHydrogen, fromDegrees(180)));
    const auto h62 = builder.atom("H62", "H", placeAtom(ring[O5], ring[C5], carbon, kCarbonHydrogen, fromDegrees(-60)));
    const auto ho6 = builder.atom("HO6", "H", placeAtom(ring[C5], carbon, oxygen, kOxygenHydrogen, fromDegrees(180)));
    builder.bond(ringAtoms[C5], h5, 1);
    builder.bond(ringAtoms[C5], c6, 1);
    for (const auto atom : {o6, h61, h62}) builder.bond(c6, atom, 1);
    builder.bond(o6, ho6, 1);
    return builder.finish();
}

}  // namespace nacre
