#pragma once
// Cartoons: the fold of proteins and nucleic acids as ribbons, arrows, tubes and plates. Knows no Vulkan.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/molecule/residue_facts.h"

namespace nacre {

/// How helices are drawn.
enum class HelixForm : std::uint8_t {
    ribbon,   ///< an oval band that winds through the alpha carbons
    tube,     ///< a thick tube along the helix's own axis, which may bend
    cylinder  ///< a straight cylinder; a bent helix is as few of them as keep within 1.5 Å of its axis
};

/// How the bases of nucleic acids are drawn.
enum class BaseForm : std::uint8_t {
    plates,  ///< their rings as plates, on a stick from the backbone
    ladder,  ///< a stick from the backbone to where the pairing is (N1 of purines, N3 of pyrimidines)
    none
};

struct CartoonOptions {
    HelixForm helices = HelixForm::ribbon;
    BaseForm bases = BaseForm::plates;
    /// A tube whose radius grows with the B factor: 0.4 Å times ((z + 2) / 2)^1.5, between 0.6 and 4, where z is the B
    /// factor's distance from its mean over all that is drawn, in standard deviations. PyMOL's numbers.
    bool putty = false;
    bool disulfides = true;  ///< bonds between sulphurs of two residues, as sticks from ribbon to ribbon
    /// Rings of vertices from one residue to the next, even, and vertices around each. 0: 8 and 12 up to 20,000
    /// residues, 6 and 10 up to 60,000, then 4 and 8.
    int segments = 0, sides = 0;
    friend bool operator==(const CartoonOptions&, const CartoonOptions&) = default;
};

/// The cartoon of those residues whose guide atom (CA, P; O5' or what follows it where a strand begins without P) is
/// among `atoms`. What is left out bends nothing: the curve is that of whole chains.
///
/// Chains break where C and the next N (O3' and the next P) are over 2.5 Å apart; models of alpha carbons or phosphates
/// alone, where those are over 5 Å (8.5 Å). A residue by itself is a rod from N to C, or a ball. Every triangle belongs
/// to one residue: at the middle between two alpha carbons vertices are stored twice; nucleotides meet at P. The mesh
/// is made of closed pieces which touch or run into one another: every edge, of vertices at the same place, is shared
/// by two triangles of opposite sense. So it is at its coarser levels, whose bound holds where vertices are left out:
/// of sides, of rings between two residues' ends, and of round ends. All levels together have no more triangles than
/// the mesh.
/// @param atoms  indices of drawn atoms (drawn_atoms.h), ascending
/// @param secondary  of each residue of the molecule (secondaryStructure()); helices under three residues and strands
///        under two are drawn as coil
/// @param origin  what the positions are relative to, Å, in the file's frame
/// @return empty if no such residue is there
Mesh cartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
             std::span<const SecondaryStructure> secondary, const CartoonOptions& options, const glm::dvec3& origin);

/// The atoms, among `atoms`, whose residues cartoon() draws: all of these residues, side chains and hydrogens too.
/// Ascending. What is left (ligands, ions, waters) needs another style to be seen.
std::vector<std::uint32_t> atomsOfCartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms);

}  // namespace nacre
