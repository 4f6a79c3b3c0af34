#pragma once

namespace nacre::app {

/// The licences of Nacre and its components; plain text, UTF-8, lines of any length.
const char* notices();

}  // namespace nacre::app
