#pragma once

#include <string>

namespace nacre::app {

/// A line in the order in which it is drawn from left to right, letters joined as Arabic has it. As it is where
/// nothing in it runs from right to left, and where the program was built without FriBidi.
std::string visualText(const std::string& text);

}  // namespace nacre::app
