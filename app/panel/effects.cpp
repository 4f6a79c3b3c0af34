// Light, outlines, halos, fog and clipping planes. Labels and ranges are those of the options' table.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/panel/panel_state.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

/// In hundredths, so that a saved view reads well.
double inHundredths(float value) { return std::round(static_cast<double>(value) * 100) / 100; }

/// A slider of an option that is a number, or "off" at its lower end. @returns whether it is on
bool slide(PanelFrame& f, std::string_view key, bool byRatio = false) {
    const Option& row = option(key);
    const Option::Control& control = row.control;
    const std::string text = row.print(f.look), off = std::string(control.label) + ": off";
    auto at = static_cast<float>(text == "off" ? 0 : std::strtod(text.c_str(), nullptr));
    if (f.ui.slide(control.label, at, static_cast<float>(control.low), static_cast<float>(control.high),
                   text == "off" ? off.c_str() : control.shown, byRatio)) {
        const double value = inHundredths(at);
        const bool canBeOff = row.syntax.ends_with("|off");
        row.parse(canBeOff && value < 0.1 ? "off" : numberText(value), f.look);
    }
    return text != "off";
}

void chooseColor(PanelFrame& f, std::string_view key, std::array<float, 3>& color) {
    const char* label = option(key).control.label;
    f.ui.chooseColor(label, color);
    ImGui::SameLine();
    f.ui.name(label);
}

void slideOutlines(PanelFrame& f) {
    Contours& lines = f.look.effects.contours;
    if (!slide(f, "contours")) return;
    slide(f, "contour-depth", true);
    bool three = lines.weights == 3;
    if (f.ui.toggle(option("contour-weights").control.label, three)) lines.weights = three ? 3 : 1;
    chooseColor(f, "contour-color", lines.color);
}

void slideHalos(PanelFrame& f) {
    if (!slide(f, "halos")) return;
    slide(f, "halo-strength");
    slide(f, "halo-depth", true);
    chooseColor(f, "halo-color", f.look.effects.halos.color);
}

/// A slider of a number that no option has by itself. @returns whether it moved
bool slideValue(Widgets& ui, const char* name, double& value, double low, double high, const char* format) {
    auto at = static_cast<float>(value);
    if (!ui.slide(name, at, static_cast<float>(low), static_cast<float>(high), format)) return false;
    value = inHundredths(at);
    return true;
}

/// At its lower end it is off. @param radius  of the scene, Å: by itself fog is from the centre to it
void slideFog(PanelFrame& f, double radius) {
    Fog& fog = f.look.effects.fog;
    Widgets& ui = f.ui;
    const Option::Control& control = option("fog").control;
    double share = fog.range == Fog::Range::off ? 0 : fog.strength;
    if (slideValue(ui, control.label, share, control.low, control.high, share > 0 ? control.shown : "Fog: off")) {
        const bool off = share <= 0;
        fog.strength = off ? Fog{}.strength : share;
        if (off || fog.range == Fog::Range::off) fog.range = off ? Fog::Range::off : Fog::Range::automatic;
    }
    if (fog.range == Fog::Range::off) return;
    const double reach = std::ceil(radius);
    bool fits = fog.range == Fog::Range::automatic;
    double start = fits ? 0 : fog.start, end = fits ? reach : fog.end;
    const bool was = fits;
    ui.toggle("Fog from the centre to the far end", fits);
    const bool startMoved = slideValue(ui, "Start of fog", start, -2 * reach, 2 * reach, "Fog begins at %.1f Å");
    const bool endMoved = slideValue(ui, "End of fog", end, -2 * reach, 2 * reach, "Fog is full at %.1f Å");
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
    if (slideValue(ui, "Front clipping plane", near, -reach, reach,
                   clip.near > -Clip::kNone ? "Front clipping plane: %.1f Å" : "Front clipping plane: off"))
        clip.near = near <= -reach ? -Clip::kNone : near;
    if (slideValue(ui, "Back clipping plane", far, -reach, reach,
                   clip.far < Clip::kNone ? "Back clipping plane: %.1f Å" : "Back clipping plane: off"))
        clip.far = far >= reach ? Clip::kNone : far;
    // Whichever moved, the other gives way.
    if (clip.near >= clip.far) clip.far = Clip::kNone;
}

}  // namespace

void drawEffects(PanelFrame& f) {
    const double radius = f.viewer.document() ? f.viewer.document()->scene.radius : 1;
    if (f.ui.unfold("Light, outlines, fog")) {
        for (const char* key : {"ambient", "direct", "shadow", "highlight", "occlusion-strength"}) slide(f, key);
        slideOutlines(f);
        slideHalos(f);
        slideFog(f, radius);
    }
    if (f.ui.unfold("Clipping planes")) {
        slidePlanes(f.ui, f.look.effects.clip, radius);
        constexpr const char* kCaps[] = {"Cap style: plain", "Cap style: dark", "Cap style: hatched"};
        f.ui.choose("Cap style", kCaps, f.look.effects.clip.cap);
    }
}

}  // namespace nacre::app
