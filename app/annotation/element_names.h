#pragma once

#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre::app {

/// IUPAC's name, "Oxygen"; "Atom" for an unknown element.
std::string_view elementName(Element element);

}  // namespace nacre::app
