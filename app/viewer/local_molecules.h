#pragma once

#include <functional>
#include <string>

#include "app/viewer/loader.h"

namespace nacre::app {

/// Built-in samples ("sample:dna") and files, for phones: no downloads, and a molecule may use a quarter of the
/// device's memory (systems end apps that use about half of it).
/// @param readFile returns a file's bytes, if a path alone does not open it
Sources localMolecules(std::function<std::string(const std::string&)> readFile = {});

}  // namespace nacre::app
