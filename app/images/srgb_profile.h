#pragma once

#include <cstdint>
#include <vector>

namespace nacre::app {

/// The ICC profile of sRGB (ICC.1:2010, version 4.3): primaries and white of IEC 61966-2-1, adapted to D50 after
/// Bradford, and its curve as a function, perceptual. 480 bytes, constant.
std::vector<std::uint8_t> srgbProfile();

}  // namespace nacre::app
