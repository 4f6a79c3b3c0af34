// What holds of parts of the molecule, the last prevailing: each can be switched off, edited, moved, taken away.

#include <cstdio>
#include <exception>
#include <utility>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"

namespace nacre::app {
namespace {

/// A rule in words: "Hide chain B".
std::string ruleWords(const Rule& rule) {
    const std::string& what = rule.selection.text;
    switch (rule.action) {
        case Rule::Action::hide:
            return "Hide " + what;
        case Rule::Action::color:
            return what + ": " + colorWord(rule.coloring);
        case Rule::Action::show:
            break;
    }
    for (const StyleWord& word : styleWords())
        if (word.style == rule.style) return what + ": " + word.word;
    return what;
}

}  // namespace

void Panel::drawRules(SavedView& look) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    std::vector<Rule>& rules = look.look.rules;
    if (s.rule >= static_cast<int>(rules.size())) s.rule = -1;
    if (rules.empty()) return;
    ui.heading("Rules, the last prevails");
    std::function<void()> then;  // rules are not moved while they are drawn
    for (std::size_t i = 0; i < rules.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        Rule& rule = rules[i];
        const std::string words = ruleWords(rule);
        const bool open = s.rule == static_cast<int>(i);
        if (ui.sign(rule.on ? Icon::eye : Icon::eyeOff, ((rule.on ? "Switch off: " : "Switch on: ") + words).c_str()))
            rule.on = !rule.on;
        ImGui::SameLine(0, ui.px(4));
        if (ui.row(open ? Icon::up : Icon::down, words, -1, !rule.on)) {
            s.rule = open ? -1 : static_cast<int>(i);
            std::snprintf(s.ruleAtoms, sizeof s.ruleAtoms, "%s", rule.selection.text.c_str());
        }
        ui.controls.back().value = std::string(rule.on ? "on" : "off") + (open ? ", open" : "");
        if (open) {
            drawRuleEditor(rule);
            const auto move = [&](std::size_t to) {
                then = [&rules, &s, i, to] {
                    std::swap(rules[i], rules[to]);
                    s.rule = static_cast<int>(to);
                };
            };
            if (ui.button(Icon::up, "Earlier", 0, false, i > 0)) move(i - 1);
            ui.wrapLine(ui.buttonWidth("Later") + ui.px(23));
            if (ui.button(Icon::down, "Later", 0, false, i + 1 < rules.size())) move(i + 1);
            ui.wrapLine(ui.buttonWidth("Remove") + ui.px(23));
            if (ui.button(Icon::close, "Remove"))
                then = [&rules, &s, i] {
                    rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(i));
                    s.rule = -1;
                };
        }
        ImGui::PopID();
    }
    if (then) then();
    if (rules.size() > 1 && ui.button(Icon::none, "Remove all rules")) rules.clear();
}

/// Which atoms a rule is about, and the style or colour that it gives them.
void Panel::drawRuleEditor(Rule& rule) {
    Widgets& ui = state_->ui;
    State& s = *state_;
    if (ui.typable()) {
        ui.field("Atoms of the rule", "chain A and resi 10-20", s.ruleAtoms, sizeof s.ruleAtoms);
        if (ui.edited()) {
            try {
                rule.selection = parseSelection(s.ruleAtoms);
                ruleError_.clear();
            } catch (const std::exception& error) {
                ruleError_ = error.what();  // until it is one, the rule is about what it was about
            }
        }
    }
    if (rule.action == Rule::Action::show) {
        std::vector<const char*> names;
        std::string chosen;
        for (const StyleWord& word : styleWords()) {
            if (!word.style) continue;
            names.push_back(word.word);
            if (word.style == rule.style) chosen = word.word;
        }
        if (ui.choose("Style of the rule", names, chosen))
            for (const StyleWord& word : styleWords())
                if (chosen == word.word) rule.style = *word.style;
    }
    if (rule.action != Rule::Action::color) return;
    std::vector<const char*> names;
    for (const ColorWord& word : colorWords()) names.push_back(word.word);
    std::string chosen = colorWord(rule.coloring);
    if (ui.choose("Colours of the rule", names, chosen))
        for (const ColorWord& word : colorWords())
            if (chosen == word.word) rule.coloring = parseColoring(word.option);
    const bool own = rule.coloring.scheme == ColorScheme::uniform;
    const auto ownColor = own ? std::optional<ImU32>(rule.coloring.color) : std::nullopt;
    if (const auto color = ui.swatches(ownColor, forFingers() ? 6 : 8)) rule.coloring = Coloring::uniform(*color);
}

}  // namespace nacre::app
