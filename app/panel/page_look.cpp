// Style, colours, looks and light of the whole molecule.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/looks.h"
#include "app/picture/mesh_options.h"
#include "app/picture/option_text.h"
#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

constexpr float kTwoColumnPoints = 256;  // that two names of styles take beside each other

bool shows(Style style, const RepresentationOptions& look) {
    return look.style == style || std::any_of(look.rules.begin(), look.rules.end(), [style](const Rule& rule) {
               return rule.on && rule.action == Rule::Action::show && rule.style == style && !rule.opacity;
           });
}

/// It counts when it is let go: each value is a scene of its own.
void slideOpacity(Widgets& ui, const char* name, const char* format, double& opacity) {
    float& held = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(name), -1);
    float at = held < 0 ? static_cast<float>(opacity) : held;
    if (ui.slide(name, at, 0.1f, 1, format)) held = at;
    if (held < 0 || ImGui::IsAnyItemActive()) return;
    opacity = std::round(static_cast<double>(held) * 100) / 100;
    held = -1;
}

}  // namespace

void Panel::drawLookPage(SavedView& look, const Viewer& viewer) {
    Widgets& ui = state_->ui;
    ui.heading("Drawn as");
    drawStyles(look);
    ui.heading("Colours");
    drawColors(look);
    ui.heading("Ready-made");
    std::vector<const char*> names{"Looks"};
    for (const Look& named : looks()) names.push_back(named.name.c_str());
    std::string chosen = names[0];
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (ui.choose("Ready-made look", names, chosen, forFingers() ? -1 : half) && chosen != names[0])
        applyLook(lookOf(chosen), look);
    names.assign({"Views"});
    for (const Preset& preset : presets()) names.push_back(preset.name);
    chosen = names[0];
    if (!forFingers()) ImGui::SameLine();
    if (ui.choose("Ready-made view", names, chosen, -1))
        for (const Preset& preset : presets())
            if (chosen == preset.name) applyPreset(preset, look);
    ui.heading("Background");
    const float side = forFingers() ? ui.px(kFingerPoints) : ui.rowHeight();
    bool named = false;
    for (const NamedColor& color : backgrounds()) {
        const std::array<float, 4> rgba = parseColor([&] {
            char text[16];
            std::snprintf(text, sizeof text, "#%06x", color.rgb);
            return std::string(text);
        }());
        const ImU32 packed = IM_COL32(color.rgb >> 16 & 255, color.rgb >> 8 & 255, color.rgb & 255, 255);
        named |= look.background == rgba;
        if (ui.swatch(color.name, packed, look.background == rgba, side)) look.background = rgba;
        ui.wrapLine(side);
    }
    std::array<float, 3> own{look.background[0], look.background[1], look.background[2]};
    if (ui.chooseColor("Own background", own, side, named)) look.background = {own[0], own[1], own[2], 1};
    ui.heading("Light");
    ui.toggle("Light and shade", look.lighting);
    bool occlusion = look.occlusionDirections > 0;
    if (ui.toggle("Soft shadows", occlusion))
        look.occlusionDirections = occlusion ? SavedView{}.occlusionDirections : 0;
    bool perspective = look.camera.projection == Projection::perspective;
    if (ui.toggle("Perspective", perspective))
        look.camera.projection = perspective ? Projection::perspective : Projection::orthographic;
    drawEffects(look, viewer.document() ? viewer.document()->scene.radius : 1);
}

void Panel::drawStyles(SavedView& look) {
    Widgets& ui = state_->ui;
    const float room = ImGui::GetContentRegionAvail().x;
    const bool narrow = room < ui.px(kTwoColumnPoints);
    const float half = narrow ? room : (room - ImGui::GetStyle().ItemSpacing.x) / 2;
    bool second = false;
    for (const StyleWord& word : styleWords()) {
        if (second && !narrow) ImGui::SameLine();
        if (ui.button(Icon::none, word.word, half, look.look.style == word.style)) {
            look.look.style.reset();
            if (word.style) setStyle(*word.style, look.look);
        }
        ui.controls.back().role = "choice";
        ui.controls.back().value = look.look.style == word.style ? "on" : "off";
        second = !second;
    }
    if (shows(Style::cartoon, look.look))
        slideOpacity(ui, "Opacity of ribbons", "Ribbons: opacity %.2f", look.look.cartoonOpacity);
    if (shows(Style::surface, look.look))
        slideOpacity(ui, "Opacity of the surface", "Surface: opacity %.2f", look.look.surfaceOpacity);
}

void Panel::drawColors(SavedView& look) {
    Widgets& ui = state_->ui;
    std::vector<const char*> names;
    for (const ColorWord& word : colorWords()) names.push_back(word.word);
    std::string chosen = colorWord(look.look.color);
    if (ui.choose("Colours", names, chosen))
        for (const ColorWord& word : colorWords())
            if (chosen == word.word) look.look.color = parseColoring(word.option);
}

}  // namespace nacre::app
