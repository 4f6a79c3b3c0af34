#pragma once

namespace nacre::app {

/// Gives free memory back to the system once in a while: called after each of many pictures. Threads that draw in turn
/// leave free pieces in every arena of the C library, which keeps them: resident memory grows by some kilobytes per
/// picture though no more of it is in use.
void givePicturesMemoryBack();

}  // namespace nacre::app
