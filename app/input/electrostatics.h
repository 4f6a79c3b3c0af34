#pragma once
// The electrostatic potential of a molecule, calculated by the programs pdb2pqr and apbs.

#include <memory>

#include "app/picture/input_options.h"
#include "engine/molecule/residue_facts.h"
#include "engine/volume/density_map.h"

namespace nacre::app {

/// Solves the linear Poisson-Boltzmann equation for the first model, in kT/e at 298 K: dielectric constants 2 and
/// 78.54, 0.15 mol/l of salt. pdb2pqr adds hydrogens and AMBER's charges, unless the file states charges and radii
/// (PQR). Recent results are kept.
/// @throws Error if a program is missing or fails, or there are no charges
std::shared_ptr<const DensityMap> electrostaticPotential(const ResidueFacts& facts, const InputOptions& input);

}  // namespace nacre::app
