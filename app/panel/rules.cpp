// Rules for parts of the molecule, last wins: each can be switched off, edited, moved or removed. Colours are clickable
// fields.

#include <functional>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/panel/widgets.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"

namespace nacre::app {
namespace {

/// A rule in words: "Hide chain B".
std::string ruleWords(const Rule& rule) {
    const std::string what = selectionWords(rule.selection.text);
    switch (rule.action) {
        case Rule::Action::hide:
            return "Hide " + what;
        case Rule::Action::color:
            return what + ": " + colorWord(rule.coloring);
        case Rule::Action::show:
            return what + ": " + choiceLabel("style", styleName(rule.style));
    }
    return what;
}

/// Edits a rule's atoms, and their style or colour.
void drawRuleEditor(PanelFrame& f, Rule& rule) {
    if (f.ui.typable()) {
        f.ui.field("Atoms of the rule", "chain A and resi 10-20", f.s.ruleAtoms);
        // While the text is invalid, the rule keeps its previous selection.
        if (f.ui.edited()) f.s.take([&] { rule.selection = parseSelection(f.s.ruleAtoms); });
    }
    if (rule.action == Rule::Action::show) {
        std::optional<Style> style = rule.style;
        if (chooseStyle(f.ui, "Style of the rule", nullptr, style)) rule.style = *style;
    }
    if (rule.action != Rule::Action::color) return;
    std::string scheme = coloringText(rule.coloring);
    if (chooseValue(f.ui, "Colours of the rule", "color", scheme)) rule.coloring = parseColoring(scheme);
    const bool own = rule.coloring.scheme == ColorScheme::uniform;
    const auto ownColor = own ? std::optional<ImU32>(rule.coloring.color) : std::nullopt;
    if (const auto color = f.ui.swatches(ownColor, f.ui.forFingers() ? 6 : 8))
        rule.coloring = Coloring::uniform(*color);
}

}  // namespace

void drawRules(PanelFrame& f) {
    std::vector<Rule>& rules = f.look.look.rules;
    if (f.s.rule >= static_cast<int>(rules.size())) f.s.rule = -1;
    if (rules.empty()) return;
    f.ui.heading("Rules: the last one applies");
    std::function<void()> then;  // rules are moved after drawing
    for (std::size_t i = 0; i < rules.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        Rule& rule = rules[i];
        const std::string words = ruleWords(rule);
        const bool open = f.s.rule == static_cast<int>(i);
        if (f.ui.sign(rule.on ? Icon::eye : Icon::eyeOff, ((rule.on ? "Switch off: " : "Switch on: ") + words).c_str()))
            rule.on = !rule.on;
        ImGui::SameLine(0, f.ui.px(4));
        if (f.ui.row(open ? Icon::up : Icon::down, words, -1, !rule.on)) {
            f.s.rule = open ? -1 : static_cast<int>(i);
            f.s.ruleAtoms = rule.selection.text;
        }
        f.ui.controls.back().value = std::string(rule.on ? "on" : "off") + (open ? ", open" : "");
        if (open) {
            drawRuleEditor(f, rule);
            const auto move = [&](std::size_t to) {
                then = [&rules, &f, i, to] {
                    std::swap(rules[i], rules[to]);
                    f.s.rule = static_cast<int>(to);
                };
            };
            if (f.ui.button(Icon::up, "Earlier", 0, false, i > 0)) move(i - 1);
            f.ui.wrapLine(f.ui.buttonWidth("Later") + f.ui.px(23));
            if (f.ui.button(Icon::down, "Later", 0, false, i + 1 < rules.size())) move(i + 1);
            if (f.ui.word("Remove", true, Icon::close))
                then = [&rules, &f, i] {
                    rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(i));
                    f.s.rule = -1;
                };
        }
        ImGui::PopID();
    }
    if (then) then();
    if (rules.size() > 1 && f.ui.button(Icon::none, "Remove all rules")) rules.clear();
}

std::optional<ImU32> Widgets::swatches(std::optional<ImU32> chosen, std::size_t perLine) {
    std::optional<ImU32> taken;
    std::size_t placed = 0;
    for (const NamedColor& color : nacre::app::swatches()) {
        if (placed++ % perLine != 0) ImGui::SameLine(0, px(4));
        const bool is = chosen && (*chosen | IM_COL32_A_MASK) == color.packed();
        if (swatch(color.name, color.packed(), is)) taken = color.packed();
    }
    return taken;
}

std::optional<ImU32> Widgets::pickColor(const char* name, std::optional<ImU32> chosen) {
    std::optional<ImU32> taken = swatches(chosen, 6);
    ImVec4 picked = ImGui::ColorConvertU32ToFloat4(chosen.value_or(IM_COL32(86, 180, 233, 255)));
    ImGui::SetNextItemWidth(px(200));
    if (ImGui::ColorPicker3("##picker", &picked.x,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoLabel))
        taken = ImGui::ColorConvertFloat4ToU32(ImVec4(picked.x, picked.y, picked.z, 1));
    note("colour", name);
    return taken;
}

void Widgets::showManyColors(ImVec2 corner, float side) const {
    if (side <= 0) side = rowHeight();
    const float in = px(7), cell = (side - 2 * in) / 2;
    for (std::size_t i = 0; i < 4; ++i) {
        const NamedColor& color = app::swatches()[i == 2 ? 4 : i == 3 ? 5 : i];
        const ImVec2 low(corner.x + in + static_cast<float>(i % 2) * cell,
                         corner.y + in + static_cast<float>(i / 2) * cell);
        ImGui::GetWindowDrawList()->AddRectFilled(low, ImVec2(low.x + cell, low.y + cell), color.packed());
    }
}

bool Widgets::chooseColor(const char* name, std::array<float, 3>& color, float side, bool many) {
    const ImU32 packed = ImGui::ColorConvertFloat4ToU32(ImVec4(color[0], color[1], color[2], 1));
    ImGui::PushID(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (swatch(name, many ? ImGui::GetColorU32(theme_->field) : packed, false, side)) ImGui::OpenPopup("Colour");
    if (many) showManyColors(at, side);
    bool taken = false;
    if (ImGui::BeginPopup("Colour")) {
        if (const auto other = pickColor((name + std::string(", any")).c_str(), packed)) {
            // Rounded as in a saved view.
            for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<float>(*other >> 8 * i & 255) / 255.0f;
            taken = true;
        }
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return taken;
}

}  // namespace nacre::app
