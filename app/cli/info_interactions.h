#pragma once
// Output of `nacre info --interactions`, and the frequency of each over the models of a file or the frames of a
// trajectory.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/input/interaction_list.h"
#include "app/picture/input_options.h"

namespace nacre::app {

std::string decimals(double value, int digits);
/// "A/HIS57 NE2": chain, residue and atom names of one side.
std::string endName(const Molecule& molecule, const std::vector<std::uint32_t>& atoms);

/// As CSV, one line each with a header. Several atoms or waters in a cell are separated by spaces.
std::string interactionCsv(const Molecule& molecule, const std::vector<Interaction>& interactions);

/// As text.
std::string interactionText(const Molecule& molecule, const std::vector<Interaction>& interactions);

struct ContactFrequency {
    Interaction first;                    ///< at its first occurrence
    std::size_t count = 0;                ///< models or frames that have it
    double sum = 0, least = 0, most = 0;  ///< shortest distance in each of them, Å
};

struct ContactFrequencies {
    std::vector<ContactFrequency> contacts;  ///< the most frequent first
    std::size_t of = 0;                      ///< models or frames
};

/// Two interactions are equal if they have the same kind and ends, by chain, residue and atoms; for water bridges any
/// water. Searches each frame of a trajectory, or each model of the molecule.
/// @throws Error if a selection matches no atoms, or the trajectory cannot be read
ContactFrequencies contactFrequencies(const Molecule& molecule, const ContactOptions& contacts,
                                      const TrajectoryOptions& trajectory);

/// Each {kind, a, b, count, share, distance {mean, min, max}}; a and b as in interactionList().
nlohmann::ordered_json frequencyList(const Molecule& molecule, const ContactFrequencies& frequencies);
/// As CSV, one line each with a header.
std::string frequencyCsv(const Molecule& molecule, const ContactFrequencies& frequencies);
/// As text.
std::string frequencyText(const Molecule& molecule, const ContactFrequencies& frequencies);

}  // namespace nacre::app
