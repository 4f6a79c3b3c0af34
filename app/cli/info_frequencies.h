#pragma once
// How often each interaction is there, over the models of a file or the frames of a trajectory.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/picture/input_options.h"
#include "engine/scene/contacts.h"

namespace nacre::app {

struct ContactFrequency {
    Interaction first;                    ///< as it is where it is met first
    std::size_t count = 0;                ///< models or frames that have it
    double sum = 0, least = 0, most = 0;  ///< distances, Å, where it is there: the shortest of each
};

struct ContactFrequencies {
    std::vector<ContactFrequency> contacts;  ///< the most frequent first
    std::size_t of = 0;                      ///< models or frames
};

/// Interactions are the same if their kind and their ends are, by chain, residue and atoms; of water bridges whatever
/// the water. Of a trajectory each frame is searched, else each model of the molecule.
/// @throws Error if a selection matches no atoms, or the trajectory does not read
ContactFrequencies contactFrequencies(const Molecule& molecule, const ContactOptions& contacts,
                                      const TrajectoryOptions& trajectory);

/// Each {kind, a, b, count, share, distance {mean, min, max}}; a and b as interactionList() has them.
nlohmann::ordered_json frequencyList(const Molecule& molecule, const ContactFrequencies& frequencies);
/// The same, a line each with a header, for spreadsheets.
std::string frequencyCsv(const Molecule& molecule, const ContactFrequencies& frequencies);
/// The same for people.
std::string frequencyText(const Molecule& molecule, const ContactFrequencies& frequencies);

}  // namespace nacre::app
