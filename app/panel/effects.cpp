// Light, lines, halos, fog and the planes that cut, as sliders and colours.

#include <algorithm>
#include <cmath>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

/// A slider of a number that a saved view writes: in hundredths, so that it reads well there.
/// @returns whether it moved
bool slide(Widgets& ui, const char* name, double& value, double low, double high, const char* format,
           bool byRatio = false) {
    auto at = static_cast<float>(value);
    if (!ui.slide(name, at, static_cast<float>(low), static_cast<float>(high), format, byRatio)) return false;
    value = std::round(static_cast<double>(at) * 100) / 100;
    return true;
}

void chooseColor(Widgets& ui, const char* name, std::array<float, 3>& color) {
    ui.chooseColor(name, color);
    ImGui::SameLine();
    ui.name(name);
}

void slideLines(Widgets& ui, Contours& lines) {
    slide(ui, "Lines", lines.width, 0, 8, lines.width > 0 ? "Lines %.1f px" : "No lines");
    if (lines.width <= 0) return;
    slide(ui, "Depth of lines", lines.depth, 0.1, 20, "Where depth jumps %.1f Å", true);
    bool three = lines.weights == 3;
    if (ui.toggle("Wider between chains and residues", three)) lines.weights = three ? 3 : 1;
    chooseColor(ui, "Colour of the lines", lines.color);
}

void slideHalos(Widgets& ui, Halos& halos) {
    slide(ui, "Halos", halos.width, 0, 24, halos.width > 0 ? "Halos %.1f px" : "No halos");
    if (halos.width <= 0) return;
    slide(ui, "Strength of halos", halos.strength, 0, 1, "Halo strength %.2f");
    slide(ui, "Depth of halos", halos.depth, 0.5, 60, "Densest over %.1f Å", true);
    chooseColor(ui, "Colour of the halos", halos.color);
}

/// At its lower end it is off. @param radius  of the scene, Å: by itself fog is from the centre to it
void slideFog(Widgets& ui, Fog& fog, double radius) {
    double share = fog.range == Fog::Range::off ? 0 : fog.strength;
    if (slide(ui, "Fog", share, 0, 1, share > 0 ? "Fog %.2f" : "No fog")) {
        const bool off = share <= 0;
        fog.strength = off ? Fog{}.strength : share;
        if (off || fog.range == Fog::Range::off) fog.range = off ? Fog::Range::off : Fog::Range::automatic;
    }
    if (fog.range == Fog::Range::off) return;
    const double reach = std::ceil(radius);
    bool fits = fog.range == Fog::Range::automatic;
    double start = fits ? 0 : fog.start, end = fits ? reach : fog.end;
    const bool was = fits;
    ui.toggle("Fog from the middle to the far end", fits);
    const bool startMoved = slide(ui, "Start of fog", start, -2 * reach, 2 * reach, "Fog begins at %.1f Å");
    const bool endMoved = slide(ui, "End of fog", end, -2 * reach, 2 * reach, "Fog is full at %.1f Å");
    if (fits != was) fog.range = fits ? Fog::Range::automatic : Fog::Range::given;
    if (startMoved || endMoved) fog.range = Fog::Range::given;
    if (fog.range != Fog::Range::given) {
        fog.start = fog.end = 0;
        return;
    }
    // Whichever moved, the other gives way.
    constexpr double kLeast = 0.5;
    if (endMoved) start = std::min(start, end - kLeast);
    fog.start = start;
    fog.end = std::max(end, start + kLeast);
}

/// At their outer ends the planes are off. @param radius  of the scene, Å
void slidePlanes(Widgets& ui, Clip& clip, double radius) {
    const double reach = std::ceil(radius);
    double near = std::max(clip.near, -reach), far = std::min(clip.far, reach);
    if (slide(ui, "Cut before", near, -reach, reach,
              clip.near > -Clip::kNone ? "Cut before %.1f Å" : "Cut nothing before"))
        clip.near = near <= -reach ? -Clip::kNone : near;
    if (slide(ui, "Cut behind", far, -reach, reach,
              clip.far < Clip::kNone ? "Cut behind %.1f Å" : "Cut nothing behind"))
        clip.far = far >= reach ? Clip::kNone : far;
    // Whichever moved, the other gives way.
    if (clip.near >= clip.far) clip.far = Clip::kNone;
}

}  // namespace

void drawEffects(PanelFrame& f) {
    Widgets& ui = f.ui;
    const double radius = f.viewer.document() ? f.viewer.document()->scene.radius : 1;
    Effects& e = f.look.effects;
    if (ui.unfold("Light, lines, fog")) {
        slide(ui, "Light all around", e.light.ambient, 0, 2, "Light all around %.2f");
        slide(ui, "Light from a side", e.light.direct, 0, 2, "Light from a side %.2f");
        slide(ui, "Shadow", e.shadow.strength, 0, 1, e.shadow.strength > 0 ? "Shadow %.2f" : "No shadow");
        slide(ui, "Highlight", e.light.highlight, 0, 6, "Highlight %.2f");
        slide(ui, "Strength of soft shadows", e.light.occlusion, 0, 1, "Soft shadows %.2f");
        slideLines(ui, e.contours);
        slideHalos(ui, e.halos);
        slideFog(ui, e.fog, radius);
    }
    if (ui.unfold("Cut open")) {
        slidePlanes(ui, e.clip, radius);
        constexpr const char* kCaps[] = {"plain", "dark", "hatched"};
        ui.choose("Cap", kCaps, e.clip.cap);
    }
}

}  // namespace nacre::app
