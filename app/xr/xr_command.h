#pragma once

#include "app/picture/description.h"

namespace nacre::app {

/// Shows a molecule in a headset until the user, the headset's software or a signal ends it. @throws Error
void xrCommand(const PictureDescription& first);

}  // namespace nacre::app
