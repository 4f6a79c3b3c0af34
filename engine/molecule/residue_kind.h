#pragma once
// Kinds of residues, by name first, by bonds if the name is unknown.

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Everything other than polymer, water and ions is a ligand: cofactors, sugars, lipids, additives, and the atoms of
/// formats without residues.
enum class ResidueKind : std::uint8_t { protein, nucleic, water, ion, ligand };

/// Kind of each residue. The file's entities come first: parts of a polypeptide or nucleic acid are polymer; other
/// entities are a ligand, or an ion or water by name. Without entities names are looked up in gemmi's table of residues
/// and in ours of protonation states; caps of chains (ACE, NME, NH2, FOR) count as protein. A residue of unknown name
/// belongs to a polymer if it has that polymer's backbone atoms and one of them is bonded to another residue, or if it
/// is bonded to both its neighbours as amino acids are. Next to a polymer of ATOM records, up to eight HETATM amino
/// acids or nucleotides without a backbone bond to it are a ligand: a peptide-like inhibitor. An ion is a single metal
/// or halogen atom that is no part of a larger residue, or one of a few small inorganic ones (SO4, PO4, NO3, NH4, ...).
std::vector<ResidueKind> residueKinds(const Molecule& molecule);

/// One-letter code of an amino acid; protonation states and modified residues have their parent's; '\0' for others.
char aminoAcidLetter(const Name& residueName);

/// One-letter code of a nucleotide; modified ones have their parent's (DNA as RNA: "DG" is G); '\0' for others.
char nucleotideLetter(const Name& residueName);

/// Whether a polymer's atom belongs to the backbone. Protein: N, CA, C, O, the terminal oxygens, and their hydrogens.
/// Nucleic acid: phosphate and sugar, with their hydrogens. False for other kinds.
bool isBackbone(ResidueKind kind, const Name& atomName);

}  // namespace nacre
