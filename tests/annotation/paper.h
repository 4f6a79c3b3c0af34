#pragma once
// What tests of words in pictures are laid out on and with.

#include <array>
#include <string>

#include "engine/scene/view/camera.h"

namespace nacre::app {

constexpr std::array<float, 4> kWhite{1, 1, 1, 1}, kNothing{0, 0, 0, 0};

inline View square(std::uint32_t side) { return makeView(Camera{}, 10, side, side); }

inline double measureWidth(const std::string& text, double size) {
    return 0.6 * size * static_cast<double>(text.size());
}

}  // namespace nacre::app
