#include "app/files/notices.h"

namespace nacre::app {

extern const unsigned char kNoticesBytes[];  // third_party/notices.cmake

const char* notices() { return reinterpret_cast<const char*>(kNoticesBytes); }

}  // namespace nacre::app
