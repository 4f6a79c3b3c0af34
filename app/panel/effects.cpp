// Light, lines, fog and the planes that cut, as sliders.

#include <cmath>

#include "app/panel/panel_state.h"

namespace nacre::app {
namespace {

/// A slider of a number that a saved view writes: in hundredths, so that it reads well there.
/// @returns whether it moved
bool slide(const char* label, double& value, double low, double high, const char* format, int flags = 0) {
    auto at = static_cast<float>(value);
    if (!ImGui::SliderFloat(label, &at, static_cast<float>(low), static_cast<float>(high), format,
                            flags | ImGuiSliderFlags_AlwaysClamp))
        return false;
    value = std::round(static_cast<double>(at) * 100) / 100;
    return true;
}

void slideLines(Effects& e) {
    slide("##contours", e.contours.width, 0, 8, e.contours.width > 0 ? "lines %.1f px" : "no lines");
    if (e.contours.width <= 0) return;
    slide("##contour-depth", e.contours.depth, 0.1, 20, "where depth jumps %.1f A", ImGuiSliderFlags_Logarithmic);
    bool three = e.contours.weights == 3;
    if (ImGui::Checkbox("Wider between chains and residues", &three)) e.contours.weights = three ? 3 : 1;
}

void slideHalos(Halos& halos) {
    slide("##halos", halos.width, 0, 24, halos.width > 0 ? "halos %.1f px" : "no halos");
    if (halos.width <= 0) return;
    slide("##halo-strength", halos.strength, 0, 1, "halo strength %.2f");
    slide("##halo-depth", halos.depth, 0.5, 60, "densest over %.1f A", ImGuiSliderFlags_Logarithmic);
}

/// At its lower end it is off.
void slideFog(Fog& fog) {
    double share = fog.range == Fog::Range::off ? 0 : fog.strength;
    if (!slide("##fog", share, 0, 1, share > 0 ? "fog %.2f" : "no fog")) return;
    if (share <= 0) {
        fog.range = Fog::Range::off;
        fog.strength = Fog{}.strength;
        return;
    }
    if (fog.range == Fog::Range::off) fog.range = Fog::Range::automatic;
    fog.strength = share;
}

/// At their outer ends the planes are off. @param radius  of the scene, Å
void slidePlanes(Clip& clip, double radius) {
    const double reach = std::ceil(radius);
    double near = std::max(clip.near, -reach), far = std::min(clip.far, reach);
    if (slide("##near", near, -reach, reach, clip.near > -Clip::kNone ? "cut before %.1f A" : "cut nothing before"))
        clip.near = near <= -reach ? -Clip::kNone : near;
    if (slide("##far", far, -reach, reach, clip.far < Clip::kNone ? "cut behind %.1f A" : "cut nothing behind"))
        clip.far = far >= reach ? Clip::kNone : far;
    // Whichever moved, the other gives way.
    if (clip.near >= clip.far) clip.far = Clip::kNone;
}

}  // namespace

void Panel::drawEffects(SavedView& look, double radius) {
    Effects& e = look.effects;
    ImGui::PushItemWidth(-1);
    if (state_->ui.unfold("Light, lines, fog")) {
        slide("##ambient", e.light.ambient, 0, 2, "light all around %.2f");
        slide("##direct", e.light.direct, 0, 2, "light from a side %.2f");
        slide("##shadow", e.shadow.strength, 0, 1, e.shadow.strength > 0 ? "shadow %.2f" : "no shadow");
        slide("##highlight", e.light.highlight, 0, 6, "highlight %.2f");
        slide("##deepening", e.light.occlusion, 0, 1, "occlusion %.2f");
        slideLines(e);
        slideHalos(e.halos);
        slideFog(e.fog);
    }
    if (state_->ui.unfold("Cut open")) {
        slidePlanes(e.clip, radius);
        constexpr const char* kCaps[] = {"plain", "dark", "hatched"};
        std::string cap = kCaps[static_cast<std::size_t>(e.clip.cap)];
        if (state_->ui.choose("Cap", kCaps, cap))
            for (std::size_t i = 0; i < std::size(kCaps); ++i)
                if (cap == kCaps[i]) e.clip.cap = static_cast<Clip::Cap>(i);
    }
    ImGui::PopItemWidth();
}

}  // namespace nacre::app
