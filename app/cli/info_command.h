#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/input/molecule_info.h"
#include "engine/volume/density_map.h"

namespace nacre::app {

/// Output of `info --residues`: each residue in file order {chain, model, number, insertion ("" = none), name,
/// secondary}; the last, of proteins only: helix, strand or coil, from the file or else from hydrogen bonds
/// (kabsch_sander.h).
nlohmann::ordered_json residueList(const Molecule& molecule);
/// The list as text, one line each.
std::string residueText(const nlohmann::ordered_json& residues);

/// As text.
std::string infoText(const std::string& name, const nlohmann::ordered_json& json);

/// Output of `info --json` for a density map: format, and `map`: grid (nodes along a, b, c: of a crystal's whole cell,
/// else of the box), cell (a, b, c in Å and three angles in degrees), origin (position of the file's first node, Å),
/// axes (of a, b, c: the file's columns, rows and sections), space_group, box {size, start} in the file, and
/// min, max, mean and rms (deviation from the mean: 1 sigma) of the known values.
nlohmann::ordered_json mapInfoJson(const DensityMap& map);

/// As text.
std::string mapInfoText(const std::string& name, const nlohmann::ordered_json& json);

}  // namespace nacre::app
