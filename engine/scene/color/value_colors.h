#pragma once
// Colours by the values of a map: a potential on a molecular surface, local resolution on a contour, a slice.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/scene/build/representation.h"
#include "engine/scene/color/color_schemes.h"
#include "engine/volume/density_map.h"

namespace nacre {

/// How values become colours.
struct ValueColoring {
    const DensityMap* map = nullptr;
    std::string name = {};  ///< of the map, for the legend
    /// automatic: red, white and blue if the range has both signs; else the caller's default
    AnyPalette palette = {};
    /// Empty: from the 2nd to the 98th percentile of the coloured values; symmetric about 0 if they have both signs.
    std::optional<ColorRange> range = {};
    std::uint32_t tint = 0;  ///< instead of a palette: from black to this colour, packed as in colors.h; 0: none
    double offset = 0;       ///< distance from a surface, outwards, at which values are taken, Å
};

/// A ValueColoring with range and palette resolved.
class ValueColors {
public:
    static constexpr std::uint32_t kSteps = 256;  ///< of the ramp; the number after the last means no value

    /// @param values  to be coloured; NaN where unknown
    /// @param ramp    default palette for a range of one sign
    /// @param signs   whether a range with both signs gets its own palette
    ValueColors(const ValueColoring& coloring, std::span<const double> values, const AnyPalette& ramp,
                bool signs = true);

    std::uint32_t toStep(double value) const;
    /// @param otherwise  the colour where there is no value
    std::uint32_t stepColor(std::uint32_t step, std::uint32_t otherwise) const;
    const ColorRange& range() const { return range_; }
    const AnyPalette& palette() const { return palette_; }
    Legend legend(const std::string& name) const;

private:
    std::uint32_t colorAt(double share) const;

    ColorRange range_;
    AnyPalette palette_;
    std::uint32_t tint_ = 0;
};

/// Colours the vertices of a scene's molecular surfaces; those without a value keep their colours. Adds a legend.
/// @returns the range of the colours; empty: there is no surface
std::optional<ColorRange> colorSurfaces(const ValueColoring& coloring, Representation& scene);

}  // namespace nacre
