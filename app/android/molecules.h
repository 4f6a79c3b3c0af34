#pragma once

#include "app/viewer/loader.h"

namespace nacre::app {

/// Built-in samples ("sample:dna") and files. Nothing is downloaded: the app asks for no network.
Sources moleculeSources();

}  // namespace nacre::app
