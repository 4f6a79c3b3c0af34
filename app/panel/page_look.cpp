// Style, colours, looks and light of the whole molecule.

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/color_values.h"
#include "app/picture/looks.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "app/viewer/presets.h"
#include "engine/molecule/crystal.h"

namespace nacre::app {
namespace {

constexpr float kTwoColumnPoints = 256;  // width of two style names side by side

bool shows(Style style, const RepresentationOptions& look) {
    return look.style == style || std::any_of(look.rules.begin(), look.rules.end(), [style](const Rule& rule) {
               return rule.on && rule.action == Rule::Action::show && rule.style == style && !rule.opacity;
           });
}

/// Takes effect on release: each value builds a scene. @param steps  per unit
void slideOnRelease(Widgets& ui, std::string_view key, double steps, double& value) {
    const Option::Control& control = option(key).control;
    float& held = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(control.label), -1);
    float at = held < 0 ? static_cast<float>(value) : held;
    if (ui.slide(control.label, at, static_cast<float>(control.low), static_cast<float>(control.high), control.shown))
        held = at;
    if (held < 0 || ImGui::IsAnyItemActive()) return;
    value = std::round(static_cast<double>(held) * steps) / steps;
    held = -1;
}

void drawStyles(PanelFrame& f) {
    RepresentationOptions& look = f.look.look;
    const float room = ImGui::GetContentRegionAvail().x;
    const bool narrow = room < f.ui.px(kTwoColumnPoints);
    const float half = narrow ? room : (room - ImGui::GetStyle().ItemSpacing.x) / 2;
    const Option& row = option("style");
    const auto& choices = row.control.choices;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i % 2 && !narrow) ImGui::SameLine();
        if (f.ui.button(Icon::none, choices[i].label, half, chosen(row, f.look) == i))
            row.value.parse(choices[i].value, f.look);
        f.ui.controls.back().role = "choice";
        f.ui.controls.back().value = chosen(row, f.look) == i ? "on" : "off";
    }
    if (!look.style && f.viewer.document())
        f.ui.caption("Automatic: " + choiceLabel("style", styleName(f.viewer.document()->drawing.scene().style)));
    if (shows(Style::cartoon, look)) slideOnRelease(f.ui, "cartoon-opacity", 100, look.cartoonOpacity);
    if (shows(Style::surface, look)) slideOnRelease(f.ui, "surface-opacity", 100, look.surfaceOpacity);
    if (shows(Style::ellipsoids, look)) {
        slideOnRelease(f.ui, "probability", 1, look.sizes.probability);
        chooseOption(f, "ellipsoids");
    }
    if (f.viewer.document() && !f.viewer.document()->drawing.scene().spheres.empty())
        slideOnRelease(f.ui, "atom-opacity", 100, look.atomOpacity);
}

}  // namespace

void drawLookPage(PanelFrame& f) {
    PictureDescription& look = f.look;
    f.ui.heading("Style");
    drawStyles(f);
    f.ui.heading("Colours");
    chooseOption(f, "color");
    f.ui.heading("Presets");
    std::vector<const char*> names;
    for (const Look& named : looks()) names.push_back(named.name.c_str());
    std::string name = "Looks";
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (f.ui.choose("Look preset", names, name, f.ui.forFingers() ? -1 : half)) applyLook(readLook(name), look);
    names.clear();
    for (const Preset& preset : presets()) names.push_back(preset.name);
    name = "Styles";
    if (!f.ui.forFingers()) ImGui::SameLine();
    if (f.ui.choose("Style preset", names, name, -1))
        for (const Preset& preset : presets())
            if (name == preset.name) applyPreset(preset, look);
    if (look.aim.zoomTo) f.s.aim.emplace(std::exchange(look.aim, f.viewer.view().aim));
    f.ui.heading("Background");
    const float side = f.ui.forFingers() ? f.ui.px(kFingerPoints) : f.ui.rowHeight();
    bool named = false;
    for (const auto& choice : option("background").control.choices) {
        const std::array<float, 4> rgba = parseColor(choice.value);
        const ImU32 packed = ImGui::ColorConvertFloat4ToU32(ImVec4(rgba[0], rgba[1], rgba[2], 1));
        named |= look.background == rgba;
        if (f.ui.swatch(choice.label, packed, look.background == rgba, side)) look.background = rgba;
        f.ui.wrapLine(side);
    }
    std::array<float, 3> own{look.background[0], look.background[1], look.background[2]};
    if (f.ui.chooseColor("Custom background", own, side, named)) look.background = {own[0], own[1], own[2], 1};
    f.ui.heading("Light");
    for (const char* key : {"lighting", "occlusion", "bounce", "projection"}) toggleOption(f, key);
    if (f.viewer.document() && cellEdges(f.viewer.document()->molecule->file)) toggleOption(f, "cell");
    chooseOption(f, "stereo");
    drawMaps(f);
    drawEffects(f);
}

}  // namespace nacre::app
