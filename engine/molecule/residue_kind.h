#pragma once
// What a residue is, by its name first and by how it is bonded where the name is not known.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Everything that is neither polymer nor water nor ion is a ligand: cofactors, sugars, lipids, additives, and the
/// atoms of formats that know no residues.
enum class ResidueKind : std::uint8_t { protein, nucleic, water, ion, ligand };

/// Kind of each residue. The file's entities come first: what is part of a polypeptide or a nucleic acid is that, what
/// is of an entity that is no polymer is a ligand, or an ion or water by its name. Where the file states none, names
/// are looked up in gemmi's table of residues and in ours of protonation states; caps of chains (ACE, NME, NH2, FOR)
/// count as protein. A residue of unknown name is part of a polymer if it has that polymer's backbone atoms and one of
/// them is bonded to another residue. Beside a polymer of ATOM records, up to eight amino acids or nucleotides of
/// HETATM records that are bonded to none of it along the backbone are a ligand: a peptide-like inhibitor. An ion is a
/// single metal or halogen atom that is no part of a larger residue, or one of a few small inorganic ones (SO4, PO4,
/// NO3, NH4, ...).
std::vector<ResidueKind> residueKinds(const Molecule& molecule);

/// One-letter code of an amino acid, protonation states and modified residues under that of their parent; '\0' for
/// what is none or has no parent.
char aminoAcidLetter(const Name& residueName);

/// One-letter code of a nucleotide, modified ones under that of their parent (DNA's as RNA's: "DG" is G); '\0' for what
/// is none or has no parent.
char nucleotideLetter(const Name& residueName);

/// Whether an atom of a polymer belongs to its backbone. Protein: N, CA, C, O, the oxygens of the end, and their
/// hydrogens. Nucleic acid: phosphate and sugar, with their hydrogens. False for the other kinds.
bool isBackbone(ResidueKind kind, const Name& atomName);

}  // namespace nacre
