#pragma once

#include <nlohmann/json.hpp>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// Output of `info --json` for a molecule, as applicable: format, title, resolution (Å), atoms, models, records,
/// total_atoms_all_models, total_atoms_all_records, total_bonds_all_records, bonds (from the file),
/// conect_unique_pairs, chains, chains_auth, chains_label, hetatm, altloc_atoms, insertion_code_atoms,
/// negative_resnum_atoms, biomt_operators, assemblies, oper_list, assembly_list (id, details, copies, atoms in all
/// copies), bbox [[min], [max]], box_vectors and box_origin in Å, partial_charge (sum), chain_list (name, model if
/// there are several, polymer, length, sequence of the modelled residues, ligands, ions, waters), ligands, ions and
/// waters of all chains; and bonds_known (drawn by source, order and type) and warnings.
nlohmann::ordered_json infoJson(const Molecule& molecule);

}  // namespace nacre::app
