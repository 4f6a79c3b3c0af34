#pragma once
// Assemblies by instancing: one set of primitives, and the places where runs of them stand.

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Neighbouring spheres, neighbouring cylinders, or neighbouring triangles, that have the same copies.
struct PrimitiveRun {
    std::uint32_t first = 0, count = 0;
    std::uint32_t list = 0;  ///< index into Copies::lists
    glm::dvec3 center{};     ///< of a sphere about the run as it is stored, Å
    double radius = 0;
};

/// Where runs of primitives are drawn. Without transforms everything is drawn once, as it is stored.
struct Copies {
    std::vector<glm::dmat4x3> transforms;           ///< p -> transform * vec4(p, 1); no two the same
    std::vector<std::vector<std::uint32_t>> lists;  ///< of transforms, ascending; no two the same
    /// In the order of the primitives; together all of them.
    std::vector<PrimitiveRun> spheres, cylinders, triangles;
    /// Packed as in colors.h, at most kMostCopyColors: that copies take in turn, where a primitive's colour is only a
    /// tint of it (isCopyTint). Empty: all copies look the same.
    std::vector<std::uint32_t> colors;
};

/// As many as shaders hold (shaders/common/layout.h).
constexpr std::size_t kMostCopyColors = 16;

/// An order of copies in which those that take the same of `colors` colours in turn stand far from one another.
/// @param centers  where each copy is
std::vector<std::uint32_t> spreadCopies(const std::vector<glm::dvec3>& centers, std::size_t colors);

/// Where an assembly puts a molecule's subchains.
struct Placement {
    static constexpr std::uint32_t kNowhere = UINT32_MAX;
    std::vector<glm::dmat4x3> transforms;  ///< in the file's frame
    std::vector<std::vector<std::uint32_t>> lists;
    std::vector<std::uint32_t> listOfSubchain;  ///< kNowhere: the assembly leaves it out
};

/// @throws Error if no assembly has the id (naming those that there are), or a transform is no rigid motion
Placement placeAssembly(const Molecule& molecule, const std::string& id);

/// The list that holds what two lists have in common; added if there is none yet. kNowhere if that is nothing.
std::uint32_t commonList(std::vector<std::vector<std::uint32_t>>& lists, std::uint32_t a, std::uint32_t b);

/// Copies that stand for all: an assembly that looks the same from the place of one copy as from that of another
/// (60 copies of a capsid's protein) needs only one of them looked at. Found by numbers: the motions that take copy 0
/// to another one and every copy onto some copy.
/// @param reach  Å from the origin within which copies must agree to 0.1 Å
/// @param list   of transforms; more than 4,096 all stand for themselves
std::vector<std::uint32_t> representativeCopies(const std::vector<glm::dmat4x3>& transforms,
                                                const std::vector<std::uint32_t>& list, double reach);

}  // namespace nacre
