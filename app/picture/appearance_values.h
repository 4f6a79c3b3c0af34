#pragma once
// Values that say how atoms look: colours, palettes, styles, and the rules made of them. Every function throws
// std::invalid_argument with the reason, in words that continue "--option: "; those that take a selection also
// nacre::Error.

#include <array>
#include <string>
#include <string_view>

#include "engine/scene/appearance.h"

namespace nacre::app {

/// "transparent", a colour's name as CSS has it, #rgb, #rrggbb or #rrggbbaa; sRGB-coded 0..1, straight alpha.
std::array<float, 4> parseColor(std::string_view text);

/// "spacefill", "ball-and-stick", "licorice", ...
Style parseStyle(std::string_view text);

/// The name of a palette.
Palette parsePalette(std::string_view text);
/// Their names, with commas. @param ramps  those of numbers, else those of kinds
std::string paletteNames(bool ramps);

/// The names of all colour schemes, with commas.
std::string schemeNames();

/// The name of a colour scheme, an opaque colour as parseColor() takes it, or "element:COLOR", whose carbons alone
/// have the colour; behind the name of a scheme that has them, its range and its palette: "b-factor:10..60:viridis".
Coloring parseColoring(std::string_view text);

/// A style for all. A cartoon in the colours of elements would be that of its alpha carbons: where no colours were
/// asked for, its chains have their own.
void setStyle(Style style, RepresentationOptions& look);

constexpr std::size_t kMostColorTables = 64;
/// A table of colours (docs/geometry.md): a file's name, behind it `:value=COLUMN`, `:FROM..TO` and `:PALETTE`; or the
/// table itself, as JSON or as CSV, whose lines may be separated by ';' behind `csv:`. It is read when it is drawn.
Coloring parseColorSource(std::string_view text);
std::string colorSourceText(const Coloring& coloring);
/// Whether a value is a table itself, no file's name.
bool isTableText(std::string_view text);

constexpr std::size_t kMostRules = 1000;
/// "SELECTION=STYLE", "SELECTION" and "SELECTION=SCHEME" or "SELECTION=COLOR", divided at the last '='.
Rule parseShow(std::string_view text);
Rule parseHide(std::string_view text);
Rule parseColorBy(std::string_view text);

}  // namespace nacre::app
