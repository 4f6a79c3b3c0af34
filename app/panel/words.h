#pragma once
// What options' values are called where people choose them.

#include <span>
#include <string>
#include <string_view>

#include "engine/scene/appearance.h"

namespace nacre::app {

/// A value of an option as its control calls it; itself where it is none of the control's choices.
std::string wordOf(std::string_view key, std::string_view value);
/// The same of a coloring: "By chain"; colours that swatches have by their names.
std::string colorWord(const Coloring& coloring);
struct NamedColor {
    const char* name;
    std::uint32_t rgb;  ///< 0xRRGGBB
    /// Opaque, red in the lowest byte.
    std::uint32_t packed() const { return 0xff000000 | (rgb & 0xff) << 16 | (rgb & 0xff00) | (rgb >> 16 & 0xff); }
};
/// Colours that are told apart by most people: M. Okabe and K. Ito's, and some more.
std::span<const NamedColor> swatches();

}  // namespace nacre::app
