#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/input/molecule_info.h"

namespace nacre::app {

/// Output of `info --residues`: each residue in file order {chain, model, number, insertion ("" = none), name,
/// secondary}; the last, of proteins only: helix, strand or coil, from the file or else from hydrogen bonds
/// (kabsch_sander.h).
nlohmann::ordered_json residueList(const Molecule& molecule);
/// The list as text, one line each.
std::string residueText(const nlohmann::ordered_json& residues);

/// As text.
std::string infoText(const std::string& name, const nlohmann::ordered_json& json);

}  // namespace nacre::app
