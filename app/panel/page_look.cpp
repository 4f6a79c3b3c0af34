// Style, colours, looks and light of the whole molecule.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/looks.h"
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

void drawStyles(PanelFrame& f) {
    RepresentationOptions& look = f.look.look;
    const float room = ImGui::GetContentRegionAvail().x;
    const bool narrow = room < f.ui.px(kTwoColumnPoints);
    const float half = narrow ? room : (room - ImGui::GetStyle().ItemSpacing.x) / 2;
    bool second = false;
    for (const StyleWord& word : styleWords()) {
        if (second && !narrow) ImGui::SameLine();
        if (f.ui.button(Icon::none, word.word, half, look.style == word.style)) {
            look.style.reset();
            if (word.style) setStyle(*word.style, look);
        }
        f.ui.controls.back().role = "choice";
        f.ui.controls.back().value = look.style == word.style ? "on" : "off";
        second = !second;
    }
    if (shows(Style::cartoon, look))
        slideOpacity(f.ui, "Cartoon opacity", "Cartoon opacity: %.2f", look.cartoonOpacity);
    if (shows(Style::surface, look))
        slideOpacity(f.ui, "Surface opacity", "Surface opacity: %.2f", look.surfaceOpacity);
}

}  // namespace

void drawLookPage(PanelFrame& f) {
    PictureDescription& look = f.look;
    f.ui.heading("Style");
    drawStyles(f);
    f.ui.heading("Colours");
    chooseColoring(f.ui, "Colours", look.look.color);
    f.ui.heading("Presets");
    std::vector<const char*> names{"Looks"};
    for (const Look& named : looks()) names.push_back(named.name.c_str());
    std::string chosen = names[0];
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (f.ui.choose("Look preset", names, chosen, f.ui.forFingers() ? -1 : half) && chosen != names[0])
        applyLook(lookOf(chosen), look);
    names.assign({"Views"});
    for (const Preset& preset : presets()) names.push_back(preset.name);
    chosen = names[0];
    if (!f.ui.forFingers()) ImGui::SameLine();
    if (f.ui.choose("Style preset", names, chosen, -1))
        for (const Preset& preset : presets())
            if (chosen == preset.name) applyPreset(preset, look);
    f.ui.heading("Background");
    const float side = f.ui.forFingers() ? f.ui.px(kFingerPoints) : f.ui.rowHeight();
    bool named = false;
    for (const NamedColor& color : backgrounds()) {
        char text[16];
        std::snprintf(text, sizeof text, "#%06x", color.rgb);
        const std::array<float, 4> rgba = parseColor(text);
        named |= look.background == rgba;
        if (f.ui.swatch(color.name, color.packed(), look.background == rgba, side)) look.background = rgba;
        f.ui.wrapLine(side);
    }
    std::array<float, 3> own{look.background[0], look.background[1], look.background[2]};
    if (f.ui.chooseColor("Own background", own, side, named)) look.background = {own[0], own[1], own[2], 1};
    f.ui.heading("Light");
    f.ui.toggle("Lighting", look.lighting);
    bool occlusion = look.occlusion.directions > 0;
    if (f.ui.toggle("Ambient occlusion", occlusion))
        look.occlusion.directions = occlusion ? PictureDescription{}.occlusion.directions : 0;
    bool perspective = look.camera.projection == Projection::perspective;
    if (f.ui.toggle("Perspective", perspective))
        look.camera.projection = perspective ? Projection::perspective : Projection::orthographic;
    drawMaps(f);
    drawEffects(f);
}

bool chooseStyle(Widgets& ui, const char* name, const char* none, std::optional<Style>& style, float width) {
    std::vector<const char*> names;
    std::vector<std::optional<Style>> styles;
    std::size_t at = 0;
    for (const StyleWord& word : styleWords()) {
        if (!word.style && !none) continue;
        if (word.style == style) at = names.size();
        names.push_back(word.style ? word.word : none);
        styles.push_back(word.style);
    }
    if (!ui.choose(name, names, at, width)) return false;
    style = styles[at];
    return true;
}

bool chooseColoring(Widgets& ui, const char* name, Coloring& coloring) {
    std::vector<const char*> names;
    for (const ColorWord& word : colorWords()) names.push_back(word.word);
    std::string chosen = colorWord(coloring);
    if (!ui.choose(name, names, chosen)) return false;
    for (const ColorWord& word : colorWords())
        if (chosen == word.word) coloring = parseColoring(word.option);
    return true;
}

}  // namespace nacre::app
