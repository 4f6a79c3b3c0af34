#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre::python {

/// Colours of one's own, instead of a scheme's.
struct Colors {
    std::vector<std::uint32_t> atoms;  ///< packed as in engine/scene/colors.h, one for each atom; empty: the scheme's
    std::vector<LegendEntry> legend;   ///< along the ramp, if they show numbers
    Palette ramp = Palette::automatic;
    bool operator==(const Colors& other) const { return atoms == other.atoms && ramp == other.ramp; }
};
/// Numbers along a ramp; what is no finite number is grey. @param limits  values at its ends; empty: the least and the
/// largest @throws app::UsageError if the palette is no ramp
Colors colorsOfValues(const std::vector<double>& values, const std::string& palette,
                      const std::optional<std::pair<double, double>>& limits);
/// @throws app::UsageError unless there is a colour for each of so many atoms
void checkCount(const Colors& colors, std::size_t atoms);
/// Puts them into a scene, instead of its own.
void paint(const Colors& colors, Representation& scene);

}  // namespace nacre::python
