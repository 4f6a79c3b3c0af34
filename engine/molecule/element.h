#pragma once

#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre {

/// Element of a symbol in any case ("FE", "Fe", "D"); 0 for "X" or an unknown one.
Element elementFromSymbol(std::string_view symbol);
std::string_view elementSymbol(Element element);

/// van der Waals radius, Å (gemmi's table; its value for an unknown element).
float vanDerWaalsRadius(Element element);
/// The radius of an atom: its own, if it has one.
inline float vanDerWaalsRadius(const Atom& atom) {
    return atom.radius > 0 ? atom.radius : vanDerWaalsRadius(atom.element);
}
/// Covalent radius, Å (gemmi's table: Cordero et al. 2008).
float covalentRadius(Element element);

bool isHydrogen(Element element);
bool isMetal(Element element);

/// The element of a mass (u), also of hydrogens with repartitioned mass; 0: no element is near it.
Element elementFromMass(double mass);

}  // namespace nacre
