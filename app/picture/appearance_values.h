#pragma once
// Values of atoms' appearance: palettes, styles, and rules. Every function throws std::invalid_argument with the
// reason, as text that continues "--option: "; functions for selections also nacre::Error.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "app/picture/color_values.h"
#include "engine/scene/build/appearance.h"

namespace nacre::app {

/// "spacefill", "ball-and-stick", "licorice", ...
Style parseStyle(std::string_view text);

/// The name of a palette.
AnyPalette parsePalette(std::string_view text);
/// Names of palettes, separated by commas. @param ramps  for numbers; else for classes
std::string paletteNames(bool ramps);

/// "LOW..HIGH", two numbers that differ; empty if there are no dots.
std::optional<ColorRange> parseColorRange(std::string_view text);

/// The names of all colour schemes, separated by commas.
std::string schemeNames();

/// A colour scheme, an opaque colour as for parseColor(), or "element:COLOR", with that colour for carbons; schemes
/// with a ramp accept range and palette: "b-factor:10..60:viridis".
Coloring parseColoring(std::string_view text);

/// Sets the style of all atoms. By default a cartoon is coloured by chain: by element it would show alpha carbons only.
void setStyle(Style style, RepresentationOptions& look);

constexpr std::size_t kMostColorTables = 64;
/// A table of colours (docs/geometry.md): a file's name, followed by `:value=COLUMN`, `:FROM..TO` and `:PALETTE`; or
/// the table itself, as JSON or as CSV, whose lines may be separated by ';' after `csv:`. It is read when it is drawn.
Coloring parseColorSource(std::string_view text);
std::string colorSourceText(const Coloring& coloring);
/// Whether a value is a table itself, not a file's name.
bool isTableText(std::string_view text);

/// In the order of Material.
inline constexpr std::array<const char*, 4> kMaterialNames{"matte", "plastic", "metal", "glow"};

constexpr std::size_t kMostRules = 1000;
/// "SELECTION=STYLE", also followed by ":opacity=SHARE" or ":material=NAME"; "SELECTION"; and "SELECTION=SCHEME" or
/// "SELECTION=COLOR", split at the last '='.
Rule parseShow(std::string_view text);
Rule parseHide(std::string_view text);
Rule parseColorBy(std::string_view text);

}  // namespace nacre::app
