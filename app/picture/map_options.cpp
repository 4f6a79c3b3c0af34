#include "app/picture/map_options.h"

#include <algorithm>
#include <stdexcept>

#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "engine/molecule/text.h"
#include "engine/scene/build/volume.h"
#include "engine/scene/color/palettes.h"

namespace nacre::app {
namespace {

constexpr std::array<const char*, 5> kMapStyles{"auto", "mesh", "surface", "dots", "volume"};
constexpr std::array<const char*, 3> kAxes{"a", "b", "c"};
constexpr const char* kFocus = "focus";
constexpr double kUsualPotential = 5;  // kT/e
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

std::optional<double> parseMapOpacity(std::string_view text) {
    if (text == "auto") return std::nullopt;
    return app::parseNumber(text, kLeastOpacity, 1);
}
std::string mapOpacityText(const std::optional<double>& opacity) { return opacity ? numberText(*opacity) : "auto"; }

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

ValueMap parseValueMap(std::string_view text) {
    ValueMap map;
    if (text.empty() || text == "none") return map;
    while (true) {
        const std::size_t colon = text.rfind(':');
        if (colon == std::string_view::npos) break;
        const std::string_view part = text.substr(colon + 1);
        const auto range = parseColorRange(part);
        const auto palette = paletteFromName(lowerCase(part));
        if (!range && !palette) break;  // belongs to a name such as emdb:3001
        if (palette && !isRamp(*palette))
            throw std::invalid_argument("expected a palette of numbers, one of " + paletteNames(true) + ", not '" +
                                        std::string(part) + "'");
        if (range) map.range = range;
        if (palette) map.palette = *palette;
        text = text.substr(0, colon);
    }
    map.file = fileName(text);
    return map;
}

std::string valueMapText(const ValueMap& map) {
    std::string text = map.file;
    if (text.empty() || text == kElectrostatics) return "none";
    if (map.range) text += ":" + exactText(map.range->first) + ".." + exactText(map.range->last);
    if (map.palette != Palette::automatic) text += ":" + paletteName(map.palette);
    return text;
}

ValueMap parseElectrostatics(std::string_view text) {
    if (text == "off") return {};
    ValueMap map{kElectrostatics, ColorRange{-kUsualPotential, kUsualPotential}, Palette::redWhiteBlue};
    if (text == "on") return map;
    map.range = parseColorRange(text);
    if (!map.range) refuse(text, "on, off or a range in kT/e as -5..5");
    return map;
}

std::string electrostaticsText(const ValueMap& map) {
    if (map.file != kElectrostatics) return "off";
    if (map == parseElectrostatics("on")) return "on";
    return exactText(map.range->first) + ".." + exactText(map.range->last);
}

MapSliceOption parseMapSlice(std::string_view text) {
    MapSliceOption slice;
    if (text == "none") return slice;
    const std::size_t comma = text.find(',');
    const auto axis = std::find(std::begin(kAxes), std::end(kAxes), text.substr(0, comma));
    if (axis == std::end(kAxes)) refuse(text, "none, a, b, c, or an axis and a place as c,0.5");
    slice.axis = static_cast<int>(axis - std::begin(kAxes));
    if (comma != std::string_view::npos) slice.place = app::parseNumber(text.substr(comma + 1), 0, 1);
    return slice;
}

std::string mapSliceText(const MapSliceOption& slice) {
    if (slice.axis < 0) return "none";
    const std::string axis = kAxes[static_cast<std::size_t>(slice.axis)];
    return slice.place == MapSliceOption().place ? axis : axis + "," + exactText(slice.place);
}

MapTransfer parseMapTransfer(std::string_view text) {
    MapTransfer transfer;
    if (text == "auto") return transfer;
    constexpr std::size_t kFewest = 2;
    while (true) {
        const std::string_view item = trim(text.substr(0, text.find(',')));
        const std::size_t equals = item.find('='), at = item.rfind('@');
        if (equals == std::string_view::npos || at == std::string_view::npos || at < equals)
            refuse(item, "LEVEL=COLOR@OPACITY such as 1.5sigma=blue@0.1");
        MapTransferLevel level{parseMapLevel(item.substr(0, equals)),
                               parseColor(item.substr(equals + 1, at - equals - 1)),
                               app::parseNumber(item.substr(at + 1), 0, 1)};
        if (level.level.unit == MapLevel::Unit::automatic) refuse("auto", "a level such as 1.5sigma, 0.03 or top1%");
        if (level.color[3] < 1) throw std::invalid_argument("expected an opaque colour (the opacity follows @)");
        transfer.push_back(level);
        if (text.find(',') == std::string_view::npos) break;
        text = text.substr(text.find(',') + 1);
    }
    if (transfer.size() < kFewest || transfer.size() > kMostVolumeLevels)
        throw std::invalid_argument("expected 2 to " + std::to_string(kMostVolumeLevels) + " levels, not " +
                                    std::to_string(transfer.size()));
    return transfer;
}

std::string mapTransferText(const MapTransfer& transfer) {
    std::string text;
    for (const MapTransferLevel& level : transfer)
        text += (text.empty() ? "" : ",") + mapLevelText(level.level) + "=" + backgroundText(level.color) + "@" +
                numberText(level.opacity);
    return text.empty() ? "auto" : text;
}

std::vector<std::string> mapFiles(const MapOptions& maps) {
    std::vector<std::string> files;
    MapOptions all = maps;
    changeMapFiles(all, [&](const std::string& file) {
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
        return file;
    });
    return files;
}

void parseMapAround(std::string_view text, MapOptions& maps) {
    maps.around.reset();
    maps.aroundFocus = false;
    maps.reach.reset();
    if (text.empty()) return;
    const std::size_t comma = text.find_last_of(',');
    if (comma != std::string_view::npos && nacre::parseNumber(text.substr(comma + 1))) {
        maps.reach = app::parseNumber(text.substr(comma + 1), 0.1, kFarthestReach);
        text = text.substr(0, comma);
    }
    if (startsWith(text, "focus,"))
        throw std::invalid_argument("expected focus or focus,RADIUS, not '" + printable(text) + "'");
    maps.aroundFocus = text == kFocus;
    if (!maps.aroundFocus) maps.around = parseSelection(text);
}

std::string mapAroundText(const MapOptions& maps) {
    if (!maps.around && !maps.aroundFocus) return "";
    return (maps.around ? maps.around->text : kFocus) + (maps.reach ? "," + numberText(*maps.reach) : "");
}

}  // namespace nacre::app
