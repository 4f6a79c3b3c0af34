#pragma once

#include <cstddef>
#include <span>

namespace nacre::app {

/// DejaVu Sans as a TrueType file: the font of pictures and of the panel. Built in, so that pictures look the same on
/// every machine.
std::span<const std::byte> fontFile();

}  // namespace nacre::app
