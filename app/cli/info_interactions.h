#pragma once
// Output of `nacre info --interactions`.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/scene/contacts.h"

namespace nacre::app {

/// A CSV cell: quoted if needed.
std::string csvCell(const std::string& text);
std::string decimals(double value, int digits);
/// Rounded to thousandths.
double thousandths(double value);
/// "A/HIS57 NE2": chain, residue and atom names of one side.
std::string endName(const Molecule& molecule, const std::vector<std::uint32_t>& atoms);

/// @throws Error if a selection matches no atoms
InteractionQuery interactionQuery(const Molecule& molecule, const ContactOptions& contacts);
/// @param contacts  with selections
/// @param assembly  its id: those of all copies that it has, each once, and those between copies, of which one end is
/// an image; empty: of the file's atoms
/// @throws Error if a selection matches no atoms, or there is no such assembly
std::vector<Interaction> interactionsOf(const Molecule& molecule, const ContactOptions& contacts,
                                        const std::string& assembly = "");

/// Each {kind, a, b, distance (Å), angles {name: degrees}, offset (Å, of rings), donor ("a" or "b", else absent),
/// waters}; a, b and each of waters {chain, model if there are several, residue, number, insertion, atoms, ids, and
/// other_copy: true of an image}.
nlohmann::ordered_json interactionList(const Molecule& molecule, const std::vector<Interaction>& interactions);

/// As CSV, one line each with a header. Several atoms or waters in a cell are separated by spaces.
std::string interactionCsv(const Molecule& molecule, const std::vector<Interaction>& interactions);

/// As text.
std::string interactionText(const Molecule& molecule, const std::vector<Interaction>& interactions);

}  // namespace nacre::app
