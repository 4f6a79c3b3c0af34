#pragma once

#include <string>

namespace nacre::app {

/// A line in visual order, left to right, with Arabic letters joined. Unchanged if it has no right-to-left text, or if
/// the program was built without FriBidi.
std::string visualText(const std::string& text);

}  // namespace nacre::app
