#pragma once
// Closed solids of triangles: rods, balls and prisms, relative to one origin. They are part of every level of a mesh.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"

namespace nacre {

/// Adds a vertex. @return its index
std::uint32_t addVertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t atom);

/// A rod with round ends; the half next to a belongs to atomA. A ball if both ends coincide.
/// @param sides  vertices around it, at least 4, even
void addRod(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
            std::uint32_t atomB, int sides);

/// A cylinder with flat ends; the half next to a belongs to atomA. Nothing if both ends coincide.
/// @param sides  vertices around it, at least 3
void addCylinder(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double radius, std::uint32_t atomA,
                 std::uint32_t atomB, int sides);

/// A ball of rings of latitude. @param sides  vertices around it, at least 4, even
void addBall(Mesh& mesh, const glm::dvec3& center, double radius, std::uint32_t atom, int sides);

/// A plate: an outline, counter-clockwise around a unit normal, thickened to both sides along it.
void addPlate(Mesh& mesh, std::span<const glm::dvec3> outline, const glm::dvec3& normal, double halfThickness,
              std::span<const std::vector<std::uint32_t>> fans, std::uint32_t atom);

}  // namespace nacre
