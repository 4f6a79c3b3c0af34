#pragma once

namespace nacre::app {

/// Nacre's licence and those of the parts that it is made of; plain text, UTF-8, lines of any length.
const char* notices();

}  // namespace nacre::app
