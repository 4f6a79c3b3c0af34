#pragma once

#include <nlohmann/json.hpp>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// What `info --json` says of a molecule: what applies of format, title, resolution (Å), atoms, models, records,
/// total_atoms_all_models, total_atoms_all_records, total_bonds_all_records, bonds (as the file states them),
/// conect_unique_pairs, chains, chains_auth, chains_label, hetatm, altloc_atoms, insertion_code_atoms,
/// negative_resnum_atoms, biomt_operators, assemblies, oper_list,
/// assembly_list (id, details, copies, atoms in all of them), bbox [[min], [max]] and box_vectors in Å,
/// partial_charge (their sum), chain_list (name, model if there are several, polymer, length, sequence of the residues
/// that have coordinates, ligands, ions, waters), ligands, ions and waters of all chains; and bonds_known (drawn by
/// source, order and what they join) and warnings.
nlohmann::ordered_json infoJson(const Molecule& molecule);

}  // namespace nacre::app
