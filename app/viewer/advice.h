#pragma once

#include <string>

namespace nacre::app {

/// What may be done about an error, in a sentence: by what its text says.
std::string adviceFor(const std::string& error);

}  // namespace nacre::app
