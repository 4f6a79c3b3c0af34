#pragma once
// Structural alignment of two chains of amino acids, whatever their sequences: TM-align (Y. Zhang and J. Skolnick,
// Nucleic Acids Res. 33 (2005) 2302) and its TM-score (Proteins 57 (2004) 702).

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/superpose.h"

namespace nacre {

/// A residue for the alignment.
struct TraceResidue {
    glm::dvec3 place{};  ///< of its alpha carbon, Å
    SecondaryStructure fold = SecondaryStructure::none;
};

struct StructureAlignment {
    Superposition motion;                                        ///< of the moving chain; rmsd: of `pairs`
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< moving, fixed: positions in the chains, in order
    double scoreByMoving = 0, scoreByFixed = 0;  ///< TM-score, 0 to 1, normalised by the length of either chain
};

constexpr std::size_t kFewestAligned = 5, kMostAligned = 3'000;  ///< residues of a chain

/// Starts from alignments of five kinds (gapless; by secondary structure; by fragments that superpose; by distance and
/// secondary structure together), improves each by superposition and dynamic programming in turn, and takes the best.
/// Pairs are residues that end up within a distance that grows with the chains' length. Time grows with the product of
/// the lengths.
/// @param moving, fixed  kFewestAligned to kMostAligned residues each
StructureAlignment alignStructures(std::span<const TraceResidue> moving, std::span<const TraceResidue> fixed);

}  // namespace nacre
