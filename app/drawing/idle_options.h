#pragma once
// Options without visible effect.

#include <string>
#include <vector>

#include "app/picture/description.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// Warnings, one sentence each, for options that change nothing in the picture, and for clipping that leaves nothing.
/// @param effects  of the picture: zooming to a part also clips
/// @param reach  of the scene from its centre, Å
std::vector<std::string> idleOptions(const PictureDescription& options, const Representation& scene,
                                     const Effects& effects, double reach);

}  // namespace nacre::app
