#pragma once
// What was asked for and cannot be seen.

#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// Options of a picture that change nothing in it, and a cut that leaves nothing: a sentence for a warning each.
/// @param effects  that it is drawn with: zooming to a part cuts, too
/// @param reach  of the scene from its centre, Å
std::vector<std::string> idleOptions(const PictureDescription& options, const Representation& scene,
                                     const Effects& effects, double reach);

}  // namespace nacre::app
