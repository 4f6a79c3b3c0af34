#pragma once

namespace nacre::app {

/// Occasionally returns free memory to the system: call it after each of many pictures. Drawing threads leave free
/// pieces in every arena of the C library, which keeps them: resident memory would grow by some kilobytes per picture
/// without being in use.
void givePicturesMemoryBack();

}  // namespace nacre::app
