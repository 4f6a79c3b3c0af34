#pragma once
// Measurements between picked atoms.

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "engine/molecule/chemistry/interactions.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

double measureDistance(const glm::dvec3& a, const glm::dvec3& b);                    ///< Å
double measureAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);  ///< at b, degrees, 0..180
/// About the bond b-c, degrees, -180..180: positive if d is clockwise from a, seen from b to c. W. Klyne and V. Prelog,
/// Experientia 16 (1960) 521.
double measureTorsion(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// "distance 3.21 Å", "angle 109.5°" or "torsion -60.0°" for two to four atoms; empty for fewer.
std::string measurementText(std::span<const glm::dvec3> places);

/// Only the value: "3.21 Å".
std::string measuredValue(std::span<const glm::dvec3> places);

/// IUPAC's name, "Oxygen"; "Atom" for an unknown element.
std::string_view elementName(Element element);

/// Element, name, residue, chain and number: "Oxygen O6, residue DG 4, chain A, atom 78"; after the residue its full
/// name, if the file has one: "(amprenavir)".
/// @param atom index into Molecule::atoms
std::string atomText(const Molecule& molecule, std::uint32_t atom);

/// "Hydrogen bond 2.91 Å, ASP 189 OD1 to BEN 1 N1"; for rings and charged groups their residues.
std::string contactText(const Molecule& molecule, const Interaction& contact);

/// "HIS 87 NE2", as far as known. @param atom index into Molecule::atoms
std::string shortAtomText(const Molecule& molecule, std::uint32_t atom);

}  // namespace nacre::app
