#pragma once
// Density maps in a picture. Lists are in the order of the maps: the first level is the first map's.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/selection/selection.h"
#include "engine/scene/build/map_style.h"
#include "engine/scene/color/color_schemes.h"

namespace nacre::app {

struct MapLevel {
    enum class Unit : std::uint8_t {
        automatic,  ///< 1.5 sigma for a crystal, 3 for a difference map, otherwise the highest 1 %
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

/// Instead of a file: the potential of the picture's atoms.
constexpr const char* kElectrostatics = "electrostatics:";

/// A map whose values determine colours.
struct ValueMap {
    std::string file;  ///< empty: none; or kElectrostatics
    std::optional<ColorRange> range = {};
    AnyPalette palette = {};
    friend bool operator==(const ValueMap&, const ValueMap&) = default;
};

/// A plane of the grid that is drawn instead of a contour.
struct MapSliceOption {
    int axis = -1;       ///< 0, 1, 2: across a, b, c; -1: none
    double place = 0.5;  ///< 0..1 of the drawn part of the map
    friend bool operator==(const MapSliceOption&, const MapSliceOption&) = default;
};

/// Colour and opacity at one value of a volume.
struct MapTransferLevel {
    MapLevel level;
    std::array<float, 4> color{};  ///< sRGB-coded, opaque
    double opacity = 0;            ///< share of light that 1 Å hides
    friend bool operator==(const MapTransferLevel&, const MapTransferLevel&) = default;
};
using MapTransfer = std::vector<MapTransferLevel>;  ///< empty: by level, colour and opacity of the map

constexpr double kMapReach = 2, kMapReachOfFocus = 10, kMapReachOfAll = 4;  ///< Å

struct MapOptions {
    std::vector<std::string> files;
    std::vector<MapLevel> levels;
    std::vector<MapStyle> styles;
    std::vector<MapColors> colors;
    std::vector<ValueMap> values;  ///< colours of contours and slices
    std::vector<MapSliceOption> slices;
    std::vector<MapTransfer> transfers;            ///< of volumes
    ValueMap surface;                              ///< colours of the molecule's surfaces
    std::vector<std::optional<double>> opacities;  ///< of surfaces and volumes; empty: 0.5, of slices 1
    double width = 1.5;                            ///< of lines and dots, pixels
    std::optional<Selection> around;               ///< empty: for a crystal all drawn atoms, else everything
    bool aroundFocus = false;                      ///< around the camera's focus, without a selection
    std::optional<double> reach;                   ///< Å from there; empty: usualReach()

    double usualReach() const { return around ? kMapReach : aroundFocus ? kMapReachOfFocus : kMapReachOfAll; }
};

constexpr double kWidestWire = 10;  ///< pixels
constexpr std::size_t kMostMaps = 16;

/// "auto", "1.5sigma", "0.03" or "top1%". @throws std::invalid_argument
MapLevel parseMapLevel(std::string_view text);
std::string mapLevelText(const MapLevel& level);
/// "auto", or 0.01 to 1.
std::optional<double> parseMapOpacity(std::string_view text);
std::string mapOpacityText(const std::optional<double>& opacity);
MapStyle parseMapStyle(std::string_view text);
std::string mapStyleText(MapStyle style);
/// "auto", one colour, or two separated by a comma.
MapColors parseMapColors(std::string_view text);
std::string mapColorsText(const MapColors& colors);
/// "none", or "FILE" followed by ":LOW..HIGH" and ":PALETTE", in any order. @throws std::invalid_argument
ValueMap parseValueMap(std::string_view text);
std::string valueMapText(const ValueMap& map);
/// "on", "off" or "LOW..HIGH", in kT/e. @throws std::invalid_argument
ValueMap parseElectrostatics(std::string_view text);
std::string electrostaticsText(const ValueMap& map);
/// "none", or "a", "b" or "c", optionally followed by ",PLACE". @throws std::invalid_argument
MapSliceOption parseMapSlice(std::string_view text);
std::string mapSliceText(const MapSliceOption& slice);
/// "auto", or 2 to 8 of "LEVEL=COLOR@OPACITY", separated by commas. @throws std::invalid_argument
MapTransfer parseMapTransfer(std::string_view text);
std::string mapTransferText(const MapTransfer& transfer);
/// All files that a picture reads for --map and for colours by maps, each once.
std::vector<std::string> mapFiles(const MapOptions& maps);
/// Applies a change to each of them, for example to make a view's paths absolute.
template <typename Change>
void changeMapFiles(MapOptions& maps, const Change& change) {
    for (std::string& file : maps.files) file = change(file);
    for (ValueMap& map : maps.values)
        if (!map.file.empty()) map.file = change(map.file);
    if (!maps.surface.file.empty() && maps.surface.file != kElectrostatics)
        maps.surface.file = change(maps.surface.file);
}
/// Parses "SEL" or "focus", optionally followed by ",RADIUS", into `around`, `aroundFocus` and `reach`.
void parseMapAround(std::string_view text, MapOptions& maps);
std::string mapAroundText(const MapOptions& maps);

}  // namespace nacre::app
