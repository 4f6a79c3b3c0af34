#pragma once

#include <cstdlib>

namespace nacre::test {

/// Programs that tests start neither read nor write the user's cache, unless a test names one.
inline const int kNoCache = setenv("NACRE_CACHE", "off", 1);

}  // namespace nacre::test
