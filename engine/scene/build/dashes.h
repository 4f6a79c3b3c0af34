#pragma once
// Dashed lines in space: rounded dashes of spheres and cylinders. Knows nothing of their meaning.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace nacre {

struct Representation;

/// Lengths along a line, Å, with round ends: a dash and a gap, and optionally a second dash and gap. A dash no longer
/// than the line's width becomes a dot. The pattern begins and ends with half of its last gap.
struct DashPattern {
    std::array<double, 4> lengths{0.3, 0.2, 0, 0};  ///< dash, gap, dash, gap; last gap 0: the first two only

    double period() const { return lengths[0] + lengths[1] + lengths[2] + lengths[3]; }
};

/// As in SphereLook.
struct LineLook {
    std::uint32_t color = 0, id = 0;
};

struct DashedLine {
    glm::dvec3 a{}, b{};    ///< ends, Å from the scene's centre
    double radius = 0.07;   ///< Å
    DashPattern pattern{};  ///< scaled so that whole patterns fill the line
    LineLook look{};
    std::optional<LineLook> lookB{};  ///< of the half next to b, if different
};

constexpr double kShortestLine = 0.1;        ///< Å; shorter lines are not drawn
constexpr std::size_t kMostPatterns = 2000;  ///< per line; longer lines have longer dashes

/// Shortens a line to end at the surfaces of two balls. @param radiusA, radiusB  0: no ball
/// @returns false if less than kShortestLine is left
bool shorten(DashedLine& line, double radiusA, double radiusB);

/// Adds a solid stick with round ends from a to b; a ball if it is no longer than its width.
void appendCapsule(const DashedLine& line, Representation& scene);

/// Adds a line's dashes. @returns their number
std::size_t appendDashes(const DashedLine& line, Representation& scene);

}  // namespace nacre
