#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/input/molecule_info.h"

namespace nacre::app {

/// What `info --residues` adds: each residue in the file's order {chain, model if there are several, number, insertion
/// ("" = none), name}, and for those of proteins `secondary`: helix, strand or coil, as the file states it or else by
/// hydrogen bonds (kabsch_sander.h).
nlohmann::ordered_json residueList(const Molecule& molecule);
/// The same for people, a line each.
std::string residueText(const nlohmann::ordered_json& residues);

/// The same for people.
std::string infoText(const std::string& name, const nlohmann::ordered_json& json);

}  // namespace nacre::app
