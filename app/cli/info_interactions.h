#pragma once
// What `nacre info --interactions` says.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/molecule/chemistry/interactions.h"

namespace nacre::app {

/// What --interactions and --interaction-rules ask for.
struct InteractionRequest {
    std::string a, b;  ///< selections; b empty: the surroundings of a, or all against all
    InteractionRules rules = InteractionRules::molstar;
};

/// "all", "SEL" or "SEL,SEL". A comma that is part of a selection's list stays one: `chain A,B` is one selection.
/// @throws Error as parseSelection() does
InteractionRequest parseInteractionRequest(const std::string& text);

/// "molstar", "plip", "baker-hubbard" or "wernet-nilsson". @throws Error
InteractionRules parseInteractionRules(const std::string& name);

/// @throws Error if a selection matches no atoms
std::vector<Interaction> interactionsOf(const Molecule& molecule, const InteractionRequest& request);

/// Each {kind, a, b, distance (Å), angles {name: degrees}, offset (Å, of rings), donor ("a" or "b", else absent),
/// waters}; a, b and each of waters {chain, model if there are several, residue, number, insertion, atoms, ids}.
nlohmann::ordered_json interactionList(const Molecule& molecule, const std::vector<Interaction>& interactions);

/// The same, a line each with a header, for spreadsheets. Several atoms or waters of a cell are joined by spaces.
std::string interactionCsv(const Molecule& molecule, const std::vector<Interaction>& interactions);

/// The same for people.
std::string interactionText(const Molecule& molecule, const std::vector<Interaction>& interactions);

}  // namespace nacre::app
