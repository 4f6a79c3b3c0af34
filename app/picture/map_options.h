#pragma once
// Density maps in a picture. Lists are in the order of the maps: the first level is the first map's.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/selection/selection.h"
#include "engine/scene/map_style.h"

namespace nacre::app {

struct MapLevel {
    enum class Unit : std::uint8_t {
        automatic,  ///< 1.5 sigma for a crystal, 3 for a difference map, else the highest 1 %
        value,      ///< in the file's unit
        sigma,      ///< above the mean, in root mean square deviations
        top         ///< percentage of values above it
    };
    Unit unit = Unit::automatic;
    double value = 0;
    friend bool operator==(const MapLevel&, const MapLevel&) = default;
};

/// sRGB-coded 0..1, straight alpha.
struct MapColors {
    std::array<float, 4> high{}, low{};  ///< of a difference map's two contours; other maps use the first
    bool automatic = true;
    friend bool operator==(const MapColors&, const MapColors&) = default;
};

struct MapOptions {
    std::vector<std::string> files;
    std::vector<MapLevel> levels;
    std::vector<MapStyle> styles;
    std::vector<MapColors> colors;
    std::optional<double> opacity;    ///< of surfaces; empty: 1, or 0.5 beside a molecule
    double width = 1.5;               ///< of lines and dots, pixels
    std::optional<Selection> around;  ///< empty: of a crystal all drawn atoms, else everything
    std::optional<double> reach;      ///< Å from there; empty: kMapReach, or kMapReachOfAll without `around`
};

constexpr double kMapReach = 2, kMapReachOfAll = 4;  ///< Å
constexpr double kWidestWire = 10;                   ///< pixels
constexpr std::size_t kMostMaps = 16;

/// "auto", "1.5sigma", "0.03" or "top1%". @throws std::invalid_argument
MapLevel parseMapLevel(std::string_view text);
std::string mapLevelText(const MapLevel& level);
MapStyle parseMapStyle(std::string_view text);
std::string mapStyleText(MapStyle style);
/// "auto", a colour, or two separated by a comma.
MapColors parseMapColors(std::string_view text);
std::string mapColorsText(const MapColors& colors);
/// "SEL" or "SEL,RADIUS", into `around` and `reach`.
void parseMapAround(std::string_view text, MapOptions& maps);
std::string mapAroundText(const MapOptions& maps);

}  // namespace nacre::app
