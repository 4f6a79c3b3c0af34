#pragma once
// Sources of molecules for windows and phones.

#include <functional>
#include <string>

#include "app/picture/input_options.h"
#include "app/viewer/loader.h"

namespace nacre::app {

/// An input of a saved view is downloaded if the user agrees.
/// @param first  from the program's start; its other options do not apply to files opened later
Sources windowSources(const InputOptions& first);

/// As above on phones, where the system may have to read files.
/// @param first  as above; downloads for a view ask first
/// @param readFile  returns a file's bytes, if a path alone does not open it
Sources phoneSources(const InputOptions& first, const std::function<std::string(const std::string&)>& readFile = {});

/// The input in a form that is valid in any folder: "~/a.pdb" and "a.pdb" as full paths; "4hhb" as "pdb:4hhb", unless
/// there is a file of that name.
std::string lasting(const std::string& input);

}  // namespace nacre::app
