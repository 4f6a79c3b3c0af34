#pragma once
// The interactions that a description requests, also as JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/scene/build/contacts.h"

namespace nacre::app {

/// All fields of one side, as text: the residue of an end, and its atoms.
struct EndFields {
    std::string chain, residue, insertion;
    int model = 1, number = 0;
    std::vector<std::string> atoms;
    std::vector<std::uint32_t> ids;
};
EndFields endFields(const Molecule& molecule, const std::vector<std::uint32_t>& atoms);
/// "a", "b", or "" without a donor.
const char* donorName(const Interaction& interaction);
/// Rounded to thousandths.
double thousandths(double value);

/// @throws Error if a selection matches no atoms
InteractionQuery interactionQuery(const Molecule& molecule, const ContactOptions& contacts);
/// @param contacts  with selections
/// @param assembly  its id: interactions of all its copies, each once, and those between copies, with an image as one
/// end; empty: of the file's atoms
/// @throws Error if a selection matches no atoms, or there is no such assembly
std::vector<Interaction> listInteractions(const Molecule& molecule, const ContactOptions& contacts,
                                          const std::string& assembly = "");

/// Each as {kind, a, b, distance (Å), angles {name: degrees}, offset (Å, of rings), donor ("a" or "b"), waters}; a, b
/// and each of waters as {chain, model, residue, number, insertion, atoms, ids, other_copy (an image)}. Null where not
/// applicable.
nlohmann::ordered_json interactionList(const Molecule& molecule, const std::vector<Interaction>& interactions);

}  // namespace nacre::app
