#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre::python {

/// User-defined colours that replace a scheme's.
struct Colors {
    std::vector<std::uint32_t> atoms;  ///< packed as in engine/scene/color/colors.h, one per atom; empty: the scheme's
    std::vector<LegendEntry> legend;   ///< along the ramp, if the colours represent numbers
    AnyPalette ramp = {};
    bool operator==(const Colors& other) const { return atoms == other.atoms && ramp == other.ramp; }
};
/// Maps numbers to a ramp; non-finite ones are grey. @param limits  values at its ends; empty: minimum and maximum
/// @throws app::UsageError if the palette is no ramp
Colors colorsOfValues(const std::vector<double>& values, const std::string& palette,
                      const std::optional<std::pair<double, double>>& limits);
/// @throws app::UsageError unless there is one colour per atom
void checkCount(const Colors& colors, std::size_t atoms);
/// Applies the colours to a scene.
void paint(const Colors& colors, Representation& scene);

}  // namespace nacre::python
