// Atoms that are chosen by words or clicks, what to do with them, and the rules that came of it.

#include <cstdio>
#include <cstring>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/appearance_values.h"
#include "app/picture/option_text.h"

namespace nacre::app {
namespace {

constexpr std::pair<const char*, const char*> kSelections[] = {{"Ligands", "ligand"},
                                                               {"Protein", "protein"},
                                                               {"Nucleic acid", "nucleic"},
                                                               {"Ions", "ion"},
                                                               {"Backbone", "backbone"},
                                                               {"Side chains", "sidechain"},
                                                               {"Near the ligand", "byres within 5 of (ligand)"}};

}  // namespace

void Panel::drawSelectPage(SavedView& look, Viewer& viewer) {
    Widgets& ui = state_->ui;
    const Document* document = viewer.document();
    // What was clicked is what stands in the field.
    if (state_->selected != viewer.selection().text) {
        state_->selected = viewer.selection().text;
        std::snprintf(state_->selection, sizeof state_->selection, "%s", state_->selected.c_str());
    }
    ui.caption(forFingers() ? "Tap the molecule, choose below, or type."
                            : "Click on the molecule, choose below, or type.");
    bool changed = false, goesOn = false;
    if (ui.typable()) {
        // Who clicks into it after clicking on the molecule means to write something else.
        ui.field("Selection", "chain A and resi 10-20", state_->selection, sizeof state_->selection, -1,
                 ImGuiInputTextFlags_AutoSelectAll);
        changed = ui.edited();
        // How it may go on.
        const std::string typed = state_->selection;
        std::size_t offered = 0;
        if (document && !typed.empty())
            for (const std::string& text : completions(typed, *document->molecule, 4)) {
                const std::size_t end = text.find_last_not_of(' ');
                const std::size_t space = text.find_last_of(' ', end);
                const std::string word = text.substr(space == std::string::npos ? 0 : space + 1, end - space);
                goesOn = true;
                if (offered++ > 0) ui.wrapLine(ui.buttonWidth(word.c_str()));
                if (!ui.button(Icon::none, word.c_str())) continue;
                std::snprintf(state_->selection, sizeof state_->selection, "%s", text.c_str());
                changed = true;
            }
    }
    std::size_t placed = 0;
    for (const auto& [word, text] : kSelections) {
        if (placed++ > 0) ui.wrapLine(ui.buttonWidth(word));
        if (ui.button(Icon::none, word)) {
            std::snprintf(state_->selection, sizeof state_->selection, "%s", text);
            changed = true;
        }
    }
    if (changed) {
        state_->selected = state_->selection;
        viewer.select(state_->selection);
        ruleError_.clear();
    }
    const SelectedAtoms& selection = viewer.selection();
    if (!selection.error.empty() && goesOn)
        ui.caption("Not yet a selection: it may go on as above.");
    else if (!selection.error.empty())
        ui.warning(selection.error);
    else if (selection.any() && selection.count == 0)
        ui.caption("There are no such atoms.");
    else if (selection.any())
        ui.caption(std::to_string(selection.count) + (selection.count == 1 ? " atom is chosen" : " atoms are chosen"));
    else
        ui.caption("Nothing is chosen.");
    if (selection.any() && selection.count > 0) drawSelectionActions(look, selection.text);
    if (!ruleError_.empty()) ui.warning(ruleError_);
    drawRules(look);
}

void Panel::drawSelectionActions(SavedView& look, const std::string& selection) {
    Widgets& ui = state_->ui;
    std::vector<Rule>& rules = look.look.rules;
    const auto add = [&](Rule rule) {
        rules.push_back(std::move(rule));
        ruleError_.clear();
    };
    const auto aim = [&](std::optional<Selection> Aim::*which) {
        aim_.emplace();
        (*aim_).*which = parseSelection(selection);
    };
    ui.heading("Do with them");
    if (ui.button(Icon::fit, "Zoom to")) aim(&Aim::zoomTo);
    ui.wrapLine(ui.buttonWidth("Face me"));
    if (ui.button(Icon::none, "Face me")) aim(&Aim::lookAt);
    ui.wrapLine(ui.buttonWidth("Label"));
    if (ui.button(Icon::none, "Label")) look.words.labels.push_back(parseLabel(selection + "={residue} {number}"));
    ui.wrapLine(ui.buttonWidth("Hide"));
    if (ui.button(Icon::none, "Hide")) add(parseHide(selection));
    ui.wrapLine(ui.buttonWidth("Only these"));
    if (ui.button(Icon::none, "Only these")) add(parseHide("not (" + selection + ")"));
    for (const StyleWord& word : styleWords()) {
        if (!word.style) continue;
        ui.wrapLine(ui.buttonWidth(word.word));
        if (ui.button(Icon::none, word.word)) add(parseShow(selection + "=" + styleName(*word.style)));
    }
    if (const auto color = ui.swatches(std::nullopt, forFingers() ? 6 : 8)) {
        Rule rule;
        rule.action = Rule::Action::color;
        rule.selection = parseSelection(selection);
        rule.coloring = Coloring::uniform(*color);
        add(rule);
    }
}

}  // namespace nacre::app
