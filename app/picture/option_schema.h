#pragma once
// The table of options as JSON Schema: for pages that offer them, and for programs that check requests.

#include <functional>
#include <string>

#include "app/picture/options.h"

namespace nacre::app {

/// JSON Schema of an object of options, with the form of each value in "x-syntax" and some values in "examples".
/// @param has  whether an option is in it
std::string optionSchema(const std::string& title, const std::function<bool(const Option&)>& has);

}  // namespace nacre::app
