#include "app/python/colors.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "app/picture/appearance_values.h"
#include "app/picture/usage_error.h"
#include "engine/scene/color/colors.h"

namespace nacre::python {

Colors colorsOfValues(const std::vector<double>& values, const std::string& palette,
                      const std::optional<std::pair<double, double>>& limits) {
    constexpr std::uint32_t kNone = packedColor(0xc4beb4);  // warm grey, as in schemes
    constexpr int kStops = 5;
    Colors colors;
    try {
        colors.ramp = app::parsePalette(palette);
    } catch (const std::invalid_argument& error) {
        throw app::UsageError(std::string("palette: ") + error.what());
    }
    if (!isRamp(colors.ramp))
        throw app::UsageError("palette: '" + palette + "' is for categories; numbers need one of " +
                              app::paletteNames(true));
    double low = INFINITY, high = -INFINITY;
    for (const double value : values)
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (limits) std::tie(low, high) = *limits;
    const auto place = [&](double value) { return high == low ? 0.5 : (value - low) / (high - low); };
    for (const double value : values)
        colors.atoms.push_back(std::isfinite(value) ? paletteColor(colors.ramp, place(value)) : kNone);
    if (!std::isfinite(low)) return colors;
    // Three significant digits of the range, with equal numbers of decimals.
    const double range = std::max(std::abs(high - low), 1e-12);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(range))), 0, 9);
    for (int stop = 0; stop < kStops; ++stop) {
        const double share = stop / (kStops - 1.0);
        std::ostringstream text;
        text << std::fixed << std::setprecision(decimals) << low + (high - low) * share;
        colors.legend.push_back({text.str(), paletteColor(colors.ramp, share)});
    }
    return colors;
}

void checkCount(const Colors& colors, std::size_t atoms) {
    if (colors.atoms.size() != atoms)
        throw app::UsageError("color has " + std::to_string(colors.atoms.size()) + " entries for " +
                              std::to_string(atoms) + " atoms");
}

void paint(const Colors& colors, Representation& scene) {
    const auto give = [&](std::uint32_t& color, std::uint32_t atom) {
        color = withSurfaceFrom(colors.atoms[atom - 1], color);
    };
    for (SphereLook& look : scene.sphereLooks) give(look.color, look.atom);
    for (SphereLook& look : scene.meshLooks) give(look.color, look.atom);
    for (CylinderLook& look : scene.cylinderLooks) {
        give(look.colorA, look.atomA);
        give(look.colorB, look.atomB);
    }
    scene.legends.clear();
    if (!colors.legend.empty())
        scene.legends.push_back({"all", "values", colors.legend, colors.ramp, colors.legend.size()});
}

}  // namespace nacre::python
