#pragma once
// Where the molecules of windows and phones come from.

#include <functional>
#include <string>

#include "app/picture/input_options.h"
#include "app/viewer/loader.h"

namespace nacre::app {

/// What a saved view names is downloaded if the user says so.
/// @param first  what the program was started with; what is opened later by hand has none of its further options
Sources windowSources(const InputOptions& first);

/// The same on phones, where files may need the system to be read.
/// @param first  as above: what a view names, which is asked for before it is downloaded
/// @param readFile  gives a file's bytes, where a path alone does not open it
Sources phoneSources(const InputOptions& first, const std::function<std::string(const std::string&)>& readFile = {});

/// An input that means the same from any folder.
std::string lasting(const std::string& input);

}  // namespace nacre::app
