#pragma once
// Where the window's molecules come from.

#include <string>

#include "app/shared/input_options.h"
#include "app/viewer/loader.h"

namespace nacre::app {

/// What a saved view names is downloaded if the user says so.
/// @param first  what the program was started with; what is opened later by hand has none of its further options
Sources windowSources(const InputOptions& first);

/// An input that means the same from any folder.
std::string lasting(const std::string& input);

}  // namespace nacre::app
