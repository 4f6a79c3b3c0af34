#pragma once
// Cartoons: proteins and nucleic acids as ribbons, arrows, tubes and plates. Makes no Vulkan calls.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/molecule/residue_facts.h"

namespace nacre {

/// How helices are drawn.
enum class HelixForm : std::uint8_t {
    ribbon,   ///< an oval band through the alpha carbons
    tube,     ///< a thick tube along the helix's own axis, which may bend
    cylinder  ///< a straight cylinder; a bent helix is split into as few as stay within 1.5 Å of its axis
};

/// How the bases of nucleic acids are drawn.
enum class BaseForm : std::uint8_t {
    plates,  ///< ring plates on a stick from the backbone
    rings,   ///< plates, and the sugar's ring filled
    ladder,  ///< a stick from the backbone to the pairing edge (N1 of purines, N3 of pyrimidines)
    none
};

struct CartoonOptions {
    HelixForm helices = HelixForm::ribbon;
    BaseForm bases = BaseForm::plates;
    /// Tube whose radius grows with the B factor: 0.4 Å times ((z + 2) / 2)^1.5, clamped to factors of 0.6 to 4. z is
    /// the B factor's distance from the mean of all drawn residues, in standard deviations. PyMOL's numbers.
    bool putty = false;
    bool disulfides = true;  ///< disulphide bonds as sticks from ribbon to ribbon
    /// Vertex rings per residue, even, and vertices per ring. 0: 8 and 12 up to 20,000 residues, 6 and 10 up to 60,000,
    /// then 4 and 8.
    int segments = 0, sides = 0;
    double scale = 1;               ///< of all widths and thicknesses
    double tube = 0;                ///< Å: radius of the putty's tube everywhere; 0: by the B factor
    double tubePerTemperature = 0;  ///< Å of radius per Å² of the B factor, beyond `tube`; 0.05 to 20 Å together
    /// How far helices and strands extend beyond the alpha carbons of their first and last residue, in residues: 0, or
    /// 0.5 as in Mol*, which gives each residue's whole segment its shape.
    double overhang = 0;
    friend bool operator==(const CartoonOptions&, const CartoonOptions&) = default;
};

/// The cartoon of the residues whose guide atom (CA, P; O5' or its successor if a strand begins without P) is among
/// `atoms`. Omitted residues do not change the curve, which is that of whole chains.
///
/// Chains break where C and the next N (O3' and the next P) are over 2.5 Å apart; in models of alpha carbons or
/// phosphates only, at over 5 Å (8.5 Å). Their residues may stand in any order in the file if bonds join them. A
/// residue without CA that is bonded to both neighbours has the alpha carbons along its own bonds: three in GFP's
/// chromophore. A single residue is a rod from N to C, or a ball. Every triangle belongs to one residue: vertices are
/// duplicated midway between two alpha carbons; nucleotides meet at P. The mesh consists of closed pieces that touch or
/// intersect: every edge (vertices compared by position) is shared by two triangles of opposite orientation. This also
/// holds for coarser levels, which omit sides, rings within residues, and rings of round ends; their error bounds are
/// guaranteed. All coarser levels together have no more triangles than the mesh.
/// @param atoms  indices of drawn atoms (drawn_atoms.h), ascending
/// @param secondary  of each residue of the molecule (secondaryStructure()); helices under three residues and strands
/// under two are drawn as coil
/// @param origin  of the positions, Å, in the file's frame
/// @return empty without such residues
Mesh cartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms,
             std::span<const SecondaryStructure> secondary, const CartoonOptions& options, const glm::dvec3& origin);

/// Fills in the numbers of rings and vertices that options leave open. @param residues  drawn ones, in all copies
CartoonOptions settledCartoon(const CartoonOptions& options, std::size_t residues);

/// An unbroken stretch of a chain.
struct GuideTrace {
    std::vector<std::uint32_t> atoms;  ///< guide atoms (CA, P), drawn or not
    std::uint32_t end = 0;             ///< where its ribbon ends: O3' of nucleic acids, if there is one
};
std::vector<GuideTrace> guideTraces(const ResidueFacts& facts);

struct CartoonAtoms {
    /// All atoms of the residues that cartoon() draws, with side chains and hydrogens, ascending. The rest (ligands,
    /// ions, waters) needs another style.
    std::vector<std::uint32_t> drawn;
    /// Those of `drawn` that also need another style: atoms of fused residues, such as GFP's chromophore, whose shape
    /// the ribbon does not show.
    std::vector<std::uint32_t> beside;
};

CartoonAtoms atomsOfCartoon(const ResidueFacts& facts, std::span<const std::uint32_t> atoms);

}  // namespace nacre
