#pragma once
// Parts of a cartoon besides the ribbon: bases of nucleic acids, and disulphide bonds.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "engine/mesh/cartoon.h"
#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"

namespace nacre {

/// A drawn residue, and the position of its ribbon.
struct RibbonPlace {
    std::uint32_t residue = 0;  ///< the first record at its position
    glm::dvec3 place{};         ///< Å, in the file's frame
};

/// Adds a base for each nucleotide: plates for its rings if they are complete, else a stick to the last existing atom.
/// @param places  of nucleotides, by ascending residue @param options  with a resolved number of sides
void addBases(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places, const CartoonOptions& options,
              const glm::dvec3& origin);

/// Adds sticks from ribbon to ribbon for each bond between sulphurs of two drawn residues.
/// @param places  of amino acids, by ascending residue
void addDisulfides(Mesh& mesh, const ResidueFacts& facts, std::span<const RibbonPlace> places,
                   const CartoonOptions& options, const glm::dvec3& origin);

}  // namespace nacre
