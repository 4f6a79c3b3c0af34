#pragma once
// Colours by the values of a map: a potential on a molecule's surface, local resolution on a contour, a slice.

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
    /// automatic: red, white and blue where the range goes to either side of 0; else the one that a caller names
    AnyPalette palette = {};
    /// Empty: from the 2nd to the 98th percentile of the values that are met; the same to either side of 0 if they
    /// have both signs.
    std::optional<ColorRange> range = {};
    std::uint32_t tint = 0;  ///< instead of a palette: from black to this colour, packed as in colors.h; 0: none
    double offset = 0;       ///< Å, outwards from a surface: where its values are taken
};

/// The same with all that it leaves open.
class ValueColors {
public:
    static constexpr std::uint32_t kSteps = 256;  ///< of the ramp; the number behind the last stands for no value

    /// @param values  those that are to be coloured: not a number where nothing is known
    /// @param ramp    where the coloring names none, and the range has one sign
    /// @param signs   whether a range of both signs is treated apart
    ValueColors(const ValueColoring& coloring, std::span<const double> values, const AnyPalette& ramp,
                bool signs = true);

    std::uint32_t stepOf(double value) const;
    /// @param otherwise  of no value
    std::uint32_t colorOf(std::uint32_t step, std::uint32_t otherwise) const;
    const ColorRange& range() const { return range_; }
    const AnyPalette& palette() const { return palette_; }
    Legend legend(const std::string& name) const;

private:
    std::uint32_t colorAt(double share) const;

    ColorRange range_;
    AnyPalette palette_;
    std::uint32_t tint_ = 0;
};

/// Colours the vertices of a scene's molecular surfaces; where the map says nothing they stay as they are. Adds a
/// legend.
/// @returns the range of the colours; empty: there is no surface
std::optional<ColorRange> colorSurfaces(const ValueColoring& coloring, Representation& scene);

}  // namespace nacre
