#pragma once

namespace nacre::python {

/// Lets Python answer its signals while work runs without its lock: Ctrl C ends the work by an exception. Cheap enough
/// to be called often.
void checkInterrupt();

}  // namespace nacre::python
