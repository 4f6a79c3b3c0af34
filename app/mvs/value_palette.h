#pragma once
// Colours for the values of an annotation: the `palette` of color_from_uri and color_from_source.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/annotations.h"
#include "app/mvs/scene_tree.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostPaletteColors = 1000;  ///< of a list

/// The packed colour of a value; empty: keep the present colour.
using ColorOfValue = std::function<std::optional<std::uint32_t>(const std::string& value)>;

/// @param rows  of the annotation: their first values determine the range of the colours
/// @throws std::invalid_argument with the reason
ColorOfValue colorsOfPalette(const Json& palette, const std::vector<AnnotationRow>& rows);

/// A colour of a discrete or continuous palette at 0 to 1. @throws std::invalid_argument with the reason
std::optional<std::uint32_t> paletteColorAt(const Json& palette, double share);

/// Interpolates between two packed colours, in sRGB values, as in Mol*.
std::uint32_t mixedColor(std::uint32_t from, std::uint32_t to, double share);

/// The packed colours of a list named in MolViewSpec ("Viridis"); none if there is no such list.
std::vector<std::uint32_t> namedColorList(std::string_view name);
/// As above by Mol*'s own names ("viridis", "red-yellow-blue").
std::vector<std::uint32_t> molstarColorList(std::string_view name);
/// Colours by word ("ElementSymbol": "Fe"), packed; none if there is no such palette.
std::map<std::string, std::uint32_t> namedColorMap(std::string_view name);

}  // namespace nacre::app::mvs
