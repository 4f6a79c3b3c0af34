#pragma once

#include <functional>
#include <string>

#include "app/picture/description.h"

namespace nacre::app {

/// Downloads the maps that a picture names, as loadMolecule() does for its molecule, and keeps them (map_input.h).
/// Local files are read when they are drawn. @throws Error
void loadMaps(const PictureDescription& picture, const std::function<void(double)>& onDownload = {});

}  // namespace nacre::app
