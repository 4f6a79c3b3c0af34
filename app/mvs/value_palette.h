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

/// The packed colour of a value; empty: what it colours stays as it is.
using ColorOfValue = std::function<std::optional<std::uint32_t>(const std::string& value)>;

/// @param rows  of the annotation: their first values bound the colours
/// @throws std::invalid_argument with the reason
ColorOfValue colorsOfPalette(const Json& palette, const std::vector<AnnotationRow>& rows);

/// A colour along a discrete or continuous palette, for 0 to 1. @throws std::invalid_argument with the reason
std::optional<std::uint32_t> paletteColorAt(const Json& palette, double share);

/// A share of the way between two colours, packed: a mean of their sRGB values, as in Mol*.
std::uint32_t mixedColor(std::uint32_t from, std::uint32_t to, double share);

/// The colours of a list that MolViewSpec names ("Viridis"), packed; none if there is no such list.
std::vector<std::uint32_t> namedColorList(std::string_view name);
/// Colours by word ("ElementSymbol": "Fe"), packed; none if there is no such palette.
std::map<std::string, std::uint32_t> namedColorMap(std::string_view name);

}  // namespace nacre::app::mvs
