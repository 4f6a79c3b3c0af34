#pragma once
// Van der Waals radii of Mol*, which scenes are written for. Many metals are larger than by gemmi's table, which other
// pictures have, and hydrogen is smaller.

#include "engine/molecule/element.h"

namespace nacre::app::mvs {

/// Å
float molstarRadius(Element element);

}  // namespace nacre::app::mvs
