#pragma once
// What stands off a cartoon's ribbon: the bases of nucleic acids, and the bonds between sulphurs.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/cartoon.h"
#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// A residue that is drawn, and where its ribbon passes.
struct RibbonPlace {
    std::uint32_t residue = 0;  ///< the first record at its position
    glm::dvec3 place{};         ///< Å, in the file's frame
};

/// Adds a base for each nucleotide: plates of its rings where all their atoms are there and lie as rings do, else a
/// stick as far as the base is there.
/// @param places  of nucleotides, by ascending residue
void addBases(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places, BaseForm form,
              const glm::dvec3& origin, int sides);

/// Adds sticks from ribbon to ribbon for each bond between two sulphurs of residues that are drawn.
/// @param places  of amino acids, by ascending residue
void addDisulfides(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places, const glm::dvec3& origin,
                   int sides);

}  // namespace nacre
