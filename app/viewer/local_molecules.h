#pragma once

#include <functional>
#include <string>

#include "app/viewer/loader.h"

namespace nacre::app {

/// Built-in samples ("sample:dna") and files, for phones: nothing is downloaded, and a molecule may take a quarter of
/// the device's memory (a system ends an app that takes about half of it).
/// @param readFile gives a file's bytes, where a path alone does not open it
Sources localMolecules(std::function<std::string(const std::string&)> readFile = {});

}  // namespace nacre::app
