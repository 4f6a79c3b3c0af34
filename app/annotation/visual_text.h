#pragma once

#include <string>

namespace nacre::app {

/// A line in visual order, left to right, with Arabic letters joined as Unicode's presentation forms: for what draws
/// character by character, as the panel does. Unchanged if nothing in it runs from the right.
std::string visualText(const std::string& text);

/// False for a text in which nothing does.
bool mayRunFromRight(const std::string& text);

}  // namespace nacre::app
