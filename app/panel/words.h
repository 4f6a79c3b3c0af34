#pragma once
// What options are called where people choose them.

#include <optional>
#include <span>
#include <string>

#include "engine/scene/appearance.h"

namespace nacre::app {

struct StyleWord {
    const char* word;
    std::optional<Style> style;  ///< empty: whichever suits the size
};
std::span<const StyleWord> styleWords();

/// A coloring in words: "By chain"; a colour as it is written.
std::string colorWord(const Coloring& coloring);
struct NamedColor {
    const char* name;
    std::uint32_t rgb;  ///< 0xRRGGBB
    /// Opaque, red in the lowest byte.
    std::uint32_t packed() const { return 0xff000000 | (rgb & 0xff) << 16 | (rgb & 0xff00) | (rgb >> 16 & 0xff); }
};
/// Colours that are told apart by most people: M. Okabe and K. Ito's, and some more.
std::span<const NamedColor> swatches();
std::span<const NamedColor> backgrounds();

}  // namespace nacre::app
