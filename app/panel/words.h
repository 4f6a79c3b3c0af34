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
/// Of what the panel offers: the words, and the colouring that they stand for.
struct ColorWord {
    const char* word;
    const char* option;  ///< as `--color` takes it
};
std::span<const ColorWord> colorWords();

struct NamedColor {
    const char* name;
    std::uint32_t rgb;  ///< 0xRRGGBB
};
/// Colours that are told apart by most people: M. Okabe and K. Ito's, and some more.
std::span<const NamedColor> swatches();
std::span<const NamedColor> backgrounds();

}  // namespace nacre::app
