#pragma once
// Displayed names of options' values.

#include <span>
#include <string>
#include <string_view>

#include "engine/scene/build/appearance.h"

namespace nacre::app {

/// A value of an option as its control shows it; unchanged if the control has no such choice.
std::string choiceLabel(std::string_view key, std::string_view value);
/// As above for a colouring: "By chain"; swatch colours by name.
std::string colorWord(const Coloring& coloring);
struct NamedColor {
    const char* name;
    std::uint32_t rgb;  ///< 0xRRGGBB
    /// Opaque, red in the lowest byte.
    std::uint32_t packed() const { return 0xff000000 | (rgb & 0xff) << 16 | (rgb & 0xff00) | (rgb >> 16 & 0xff); }
};
/// Colours that most people can distinguish: M. Okabe and K. Ito's, and some more.
std::span<const NamedColor> swatches();

}  // namespace nacre::app
