#pragma once
// Van der Waals radii of Mol*, for which scenes are written. Many metals are larger than in gemmi's table, which other
// pictures use, and hydrogen is smaller.

#include "engine/molecule/element.h"

namespace nacre::app::mvs {

/// Å
float molstarRadius(Element element);

}  // namespace nacre::app::mvs
