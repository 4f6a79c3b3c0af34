// Light, outlines, halos, fog and clipping planes.

#include <algorithm>
#include <cmath>

#include "app/panel/panel_state.h"
#include "app/picture/options.h"

namespace nacre::app {
namespace {

void chooseColor(PanelFrame& f, std::string_view key, std::array<float, 3>& color) {
    const char* label = option(key).control.label;
    f.ui.chooseColor(label, color);
    ImGui::SameLine();
    f.ui.name(label);
}

void slideOutlines(PanelFrame& f) {
    if (!slideOption(f, "contours")) return;
    slideOption(f, "contour-depth", true);
    toggleOption(f, "contour-weights");
    chooseColor(f, "contour-color", f.look.effects.contours.color);
}

void slideHalos(PanelFrame& f) {
    if (!slideOption(f, "halos")) return;
    slideOption(f, "halo-strength");
    slideOption(f, "halo-depth", true);
    chooseColor(f, "halo-color", f.look.effects.halos.color);
}

/// A slider for a number that is not a separate option. @returns whether it moved
bool slideValue(Widgets& ui, const char* name, double& value, double low, double high, const char* format) {
    auto at = static_cast<float>(value);
    if (!ui.slide(name, at, static_cast<float>(low), static_cast<float>(high), format)) return false;
    value = inHundredths(at);
    return true;
}

/// Off at its lower end. Until it is moved, the focus is the camera's.
void slideDepthOfField(PanelFrame& f, double radius) {
    if (!slideOption(f, "depth-of-field")) return;
    std::optional<double>& focus = f.look.effects.depthOfField.focus;
    bool automatic = !focus;
    f.ui.toggle("Focus on the middle of the view", automatic);
    if (automatic != !focus) automatic ? focus.reset() : void(focus = 0);
    const double reach = std::ceil(radius);
    double depth = focus.value_or(0);
    if (focus && slideValue(f.ui, "Focus depth", depth, -reach, reach, "Focus depth: %.1f Å")) focus = depth;
}

/// Off at its lower end. @param radius  of the scene, Å: end of the default fog range, which begins at the centre
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
    // Moving one slider pushes the other.
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
    // Moving one plane past the other turns the other off.
    if (clip.near >= clip.far) clip.far = Clip::kNone;
}

}  // namespace

void drawEffects(PanelFrame& f) {
    const double radius = f.viewer.document() ? f.viewer.document()->drawing.scene().radius : 1;
    if (f.ui.unfold("Light, outlines, fog")) {
        chooseOption(f, "material");
        for (const char* key : {"ambient", "direct", "shadow", "highlight", "occlusion-strength"}) slideOption(f, key);
        slideOutlines(f);
        slideHalos(f);
        slideFog(f, radius);
        slideDepthOfField(f, radius);
    }
    if (f.ui.unfold("Clipping planes")) {
        slidePlanes(f.ui, f.look.effects.clip, radius);
        chooseOption(f, "cap");
    }
}

}  // namespace nacre::app
