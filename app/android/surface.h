#pragma once

#include <functional>

#include "engine/device_options.h"

struct ANativeWindow;

namespace nacre::app {

/// @param window tells the window of the moment; null: there is none
SurfaceSource surfaceOf(std::function<ANativeWindow*()> window);

}  // namespace nacre::app
