#include "app/picture/map_options.h"

#include <stdexcept>

#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

constexpr std::array<const char*, 4> kMapStyles{"auto", "mesh", "surface", "dots"};
constexpr double kHighestLevel = 1e30, kMostSigma = 1000, kFarthestReach = 1000;

}  // namespace

MapLevel parseMapLevel(std::string_view text) {
    using Unit = MapLevel::Unit;
    if (text == "auto") return {};
    const auto value = [&](std::string_view number, double low, double high) {
        try {
            return app::parseNumber(number, low, high);
        } catch (const std::invalid_argument&) {
            throw std::invalid_argument("expected a level such as 1.5sigma, 0.03 or top1%, not \"" + printable(text) +
                                        "\"");
        }
    };
    if (text.ends_with("sigma")) return {Unit::sigma, value(text.substr(0, text.size() - 5), -kMostSigma, kMostSigma)};
    if (startsWith(text, "top") && text.ends_with("%"))
        return {Unit::top, value(text.substr(3, text.size() - 4), 0.0001, 100)};
    return {Unit::value, value(text, -kHighestLevel, kHighestLevel)};
}

std::string mapLevelText(const MapLevel& level) {
    switch (level.unit) {
        case MapLevel::Unit::value:
            return exactText(level.value);
        case MapLevel::Unit::sigma:
            return exactText(level.value) + "sigma";
        case MapLevel::Unit::top:
            return "top" + exactText(level.value) + "%";
        case MapLevel::Unit::automatic:
            break;
    }
    return "auto";
}

MapStyle parseMapStyle(std::string_view text) { return static_cast<MapStyle>(parseChoice(text, kMapStyles)); }
std::string mapStyleText(MapStyle style) { return kMapStyles[static_cast<std::size_t>(style)]; }

MapColors parseMapColors(std::string_view text) {
    if (text == "auto") return {};
    const std::size_t comma = text.find(',');
    MapColors colors;
    colors.automatic = false;
    colors.high = colors.low = parseColor(text.substr(0, comma));
    if (comma != std::string_view::npos) colors.low = parseColor(text.substr(comma + 1));
    if (colors.high[3] < 1 || colors.low[3] < 1)
        throw std::invalid_argument("expected an opaque colour (--map-opacity makes surfaces translucent)");
    return colors;
}

std::string mapColorsText(const MapColors& colors) {
    if (colors.automatic) return "auto";
    const std::string high = backgroundText(colors.high);
    return colors.low == colors.high ? high : high + "," + backgroundText(colors.low);
}

void parseMapAround(std::string_view text, MapOptions& maps) {
    maps.around.reset();
    maps.reach.reset();
    if (text.empty()) return;
    const std::size_t comma = text.find_last_of(',');
    if (comma != std::string_view::npos && nacre::parseNumber(text.substr(comma + 1))) {
        maps.reach = app::parseNumber(text.substr(comma + 1), 0.1, kFarthestReach);
        text = text.substr(0, comma);
    }
    maps.around = parseSelection(text);
}

std::string mapAroundText(const MapOptions& maps) {
    if (!maps.around) return "";
    return maps.around->text + (maps.reach ? "," + numberText(*maps.reach) : "");
}

}  // namespace nacre::app
