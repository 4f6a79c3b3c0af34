#pragma once
// Dashed lines in space: rounded dashes made of spheres and cylinders, as everything else is. Knows nothing of what
// they mean.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

namespace nacre {

struct Representation;

/// Lengths along a line, Å, with their round ends: a dash and a gap, and perhaps another dash and gap. A dash no longer
/// than the line is wide is a dot. The pattern begins and ends with half of its last gap.
struct DashPattern {
    std::array<double, 4> lengths{0.3, 0.2, 0, 0};  ///< dash, gap, dash, gap; a last gap of 0: there are two

    double period() const { return lengths[0] + lengths[1] + lengths[2] + lengths[3]; }
};

/// As SphereLook has them.
struct LineLook {
    std::uint32_t color = 0, id = 0;
};

struct DashedLine {
    glm::dvec3 a{}, b{};    ///< where it ends, Å from the scene's centre
    double radius = 0.07;   ///< Å
    DashPattern pattern{};  ///< stretched or shrunk so that whole patterns fill the line
    LineLook look{};
    std::optional<LineLook> lookB{};  ///< of the half next to b, if it has one of its own
};

constexpr double kShortestLine = 0.1;        ///< Å; nothing is drawn of a shorter one
constexpr std::size_t kMostPatterns = 2000;  ///< of one line; a longer one has longer dashes

/// The line between two balls: from surface to surface. @param radiusA, radiusB  0 where no ball is
/// @returns false if they leave less than kShortestLine
bool shorten(DashedLine& line, double radiusA, double radiusB);

/// Adds a stick with round ends from a to b, over all of the line; a ball where that is no longer than it is wide.
void appendCapsule(const DashedLine& line, Representation& scene);

/// Adds a line's dashes. @returns how many
std::size_t appendDashes(const DashedLine& line, Representation& scene);

}  // namespace nacre
