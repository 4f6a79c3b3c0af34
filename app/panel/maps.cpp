// Density maps: level, style, colour, and region.

#include <cmath>

#include "app/panel/panel_state.h"
#include "app/picture/map_options.h"
#include "app/picture/option_values.h"

namespace nacre::app {
namespace {

constexpr float kHighestSigma = 6;
constexpr double kFarthest = 10, kFarthestOfFocus = 40;  // Å, of the slider

/// The i-th element of a list that may be shorter.
template <typename Value>
Value& entry(std::vector<Value>& list, std::size_t i) {
    if (list.size() <= i) list.resize(i + 1);
    return list[i];
}

/// @returns whether it is a slice
bool drawStyle(PanelFrame& f, std::size_t i, const std::string& name) {
    enum class Shown : std::uint8_t { automatic, mesh, surface, dots, volume, slice };
    constexpr const char* kShown[] = {"Style: default", "Mesh", "Surface", "Dots", "Volume", "Slice"};
    MapOptions& maps = f.look.maps;
    const MapSliceOption before = i < maps.slices.size() ? maps.slices[i] : MapSliceOption{};
    Shown shown = before.axis >= 0         ? Shown::slice
                  : i < maps.styles.size() ? static_cast<Shown>(maps.styles[i])
                                           : Shown::automatic;
    if (f.ui.choose(("Style of " + name).c_str(), kShown, shown)) {
        const bool slice = shown == Shown::slice;
        if (slice || before.axis >= 0) entry(maps.slices, i).axis = slice ? 2 : -1;
        if (!slice) entry(maps.styles, i) = static_cast<MapStyle>(shown);
    }
    if (shown != Shown::slice) return false;
    constexpr const char* kAxes[] = {"Across a", "Across b", "Across c"};
    enum class Axis : std::uint8_t { a, b, c };
    MapSliceOption& slice = entry(maps.slices, i);
    auto axis = static_cast<Axis>(slice.axis);
    if (f.ui.choose(("Axis of " + name).c_str(), kAxes, axis)) slice.axis = static_cast<int>(axis);
    auto place = static_cast<float>(slice.place);
    if (f.ui.slide(("Place of " + name).c_str(), place, 0, 1, "Place: %.2f"))
        slice.place = std::round(static_cast<double>(place) * 100) / 100;
    return true;
}

void drawMap(PanelFrame& f, std::size_t i) {
    MapOptions& maps = f.look.maps;
    const std::string file = maps.files[i], name = shortName(file);
    ImGui::PushID(static_cast<int>(i));
    const float side = f.ui.rowHeight(), room = ImGui::GetContentRegionAvail().x, x = ImGui::GetCursorPosX();
    f.ui.name(name, room - 2 * side - f.ui.px(8));
    ImGui::SameLine(x + room - 2 * side - f.ui.px(4));
    const bool own = i < maps.colors.size() && !maps.colors[i].automatic;
    std::array<float, 3> color{0.2f, 0.36f, 0.8f};
    if (own) color = {maps.colors[i].high[0], maps.colors[i].high[1], maps.colors[i].high[2]};
    if (f.ui.chooseColor(("Colour of " + name).c_str(), color, side, !own)) {
        MapColors& colors = entry(maps.colors, i);
        colors = {{color[0], color[1], color[2], 1}, own ? colors.low : colors.high, false};
        if (!own) colors.low = colors.high;
    }
    ImGui::SameLine(x + room - side);
    const bool removed = f.ui.sign(Icon::close, ("Remove " + name).c_str());
    const bool sliced = drawStyle(f, i, name);
    // The scene of a moved level is not built yet: shows the slider's own value.
    const bool slid = i < maps.levels.size() && maps.levels[i].unit == MapLevel::Unit::sigma;
    const std::vector<double> built =
        f.viewer.document() ? f.viewer.document()->drawing.maps().sigmas : std::vector<double>();
    const bool leveled = !sliced && (i >= maps.transfers.size() || maps.transfers[i].empty());
    if (leveled && (slid || i < built.size())) {
        auto sigma = static_cast<float>(slid ? maps.levels[i].value : built[i]);
        if (f.ui.slide(("Level of " + name).c_str(), sigma, -kHighestSigma, kHighestSigma, "Level: %.1f σ"))
            entry(maps.levels, i) = {MapLevel::Unit::sigma, std::round(sigma * 10) / 10};
    }
    ImGui::PopID();
    if (!removed) return;
    const auto drop = [i](auto& list) {
        if (i < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
    };
    drop(maps.files), drop(maps.levels), drop(maps.styles), drop(maps.colors), drop(maps.values), drop(maps.slices),
        drop(maps.transfers), drop(maps.opacities);
    f.look.mapsChanged();
}

/// Chooses where maps are drawn. A selection made elsewhere is also offered.
void drawAround(PanelFrame& f, MapOptions& maps) {
    enum class Place : std::uint8_t { all, ligands, focus, other };
    static const Selection ligand = parseSelection("ligand");
    const std::string other = maps.around ? "Around " + maps.around->text : "";
    const std::array<const char*, 4> shown{"Around: default", "Around ligands", "Around the centre of the view",
                                           other.c_str()};
    Place place = maps.aroundFocus        ? Place::focus
                  : !maps.around          ? Place::all
                  : maps.around == ligand ? Place::ligands
                                          : Place::other;
    if (f.ui.choose("Place of maps", std::span(shown).first(place == Place::other ? 4 : 3), place)) {
        maps.aroundFocus = place == Place::focus;
        maps.around = place == Place::ligands ? std::optional(ligand) : std::nullopt;
        maps.reach.reset();
    }
    if (place == Place::all) return;
    auto reach = static_cast<float>(maps.reach.value_or(maps.usualReach()));
    const auto farthest = static_cast<float>(place == Place::focus ? kFarthestOfFocus : kFarthest);
    if (f.ui.slide("Radius of maps", reach, 0.5f, farthest, "Radius: %.1f Å")) maps.reach = std::round(reach * 10) / 10;
}

}  // namespace

void drawMaps(PanelFrame& f) {
    MapOptions& maps = f.look.maps;
    if (maps.files.empty()) return;
    f.ui.heading("Density maps");
    for (std::size_t i = 0; i < maps.files.size(); ++i) drawMap(f, i);
    drawAround(f, maps);
}

}  // namespace nacre::app
