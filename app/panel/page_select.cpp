// Selection by text or clicks, actions for it, and the resulting rules.

#include <utility>

#include "app/panel/panel_state.h"
#include "app/picture/appearance_values.h"
#include "app/picture/options.h"

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

std::string selectedText(std::size_t atoms) {
    return std::to_string(atoms) + (atoms == 1 ? " atom selected" : " atoms selected");
}

void drawSelectionActions(PanelFrame& f, const std::string& selection) {
    std::vector<Rule>& rules = f.look.look.rules;
    const auto add = [&](Rule rule) {
        rules.push_back(std::move(rule));
        f.s.ruleError.clear();
    };
    const auto aim = [&](std::optional<Selection> Aim::*which) {
        f.s.aim.emplace();
        (*f.s.aim).*which = parseSelection(selection);
    };
    if (f.ui.word("Zoom to", false)) aim(&Aim::zoomTo);
    if (f.ui.word("Turn to front")) aim(&Aim::lookAt);
    drawContactActions(f, selection);
    if (f.ui.word("Label")) f.look.words.labels.push_back(parseLabel(selection + "={residue} {number}"));
    if (f.ui.word("Hide")) add(parseHide(selection));
    if (f.ui.word("Show only these")) add(parseHide("not (" + selection + ")"));
    f.ui.heading("Style");
    bool more = false;
    for (const auto& style : option("style").control.choices)
        if (style.value != "auto" && f.ui.word(style.label, std::exchange(more, true)))
            add(parseShow(selection + "=" + style.value));
    f.ui.heading("Colour");
    if (const auto color = f.ui.swatches(std::nullopt, f.ui.forFingers() ? 6 : 8)) {
        Rule rule;
        rule.action = Rule::Action::color;
        rule.selection = parseSelection(selection);
        rule.coloring = Coloring::uniform(*color);
        add(rule);
    }
}

void drawSelectPage(PanelFrame& f) {
    const Document* document = f.viewer.document();
    Picking& picking = f.viewer.picking();
    PanelState& s = f.s;
    // The field shows clicked atoms as text.
    if (s.selected != picking.selection().text) s.selection = s.selected = picking.selection().text;
    f.ui.caption(f.ui.forFingers() ? "Tap the molecule, choose below, or type."
                                   : "Click on the molecule, choose below, or type.");
    bool changed = false, goesOn = false;
    const auto take = [&](const std::string& text) {
        s.selection = text;
        changed = true;
    };
    if (f.ui.typable()) {
        // A click into the field after a click on the molecule starts a new text.
        constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue;
        const bool entered = f.ui.field("Selection", "chain A and resi 10-20", s.selection, -1, kFlags);
        changed = f.ui.edited();
        // The next text replaces this one. Without the focus its keys would be shortcuts.
        if (entered) ImGui::SetKeyboardFocusHere(-1);
        // Completions.
        if (document && !s.selection.empty())
            for (const std::string& text : completions(s.selection, *document->molecule, 4)) {
                const std::size_t end = text.find_last_not_of(' ');
                const std::size_t space = text.find_last_of(' ', end);
                const std::string word = text.substr(space == std::string::npos ? 0 : space + 1, end - space);
                if (f.ui.word(word.c_str(), std::exchange(goesOn, true))) take(text);
            }
    }
    bool more = false;
    for (const auto& [word, text] : kSelections)
        if (f.ui.word(word, std::exchange(more, true))) take(text);
    if (changed) {
        s.selected = s.selection;
        picking.select(s.selection);
        s.ruleError.clear();
    }
    const SelectedAtoms& selection = picking.selection();
    if (const std::string meant =
            selection.error.empty() || !document ? "" : meantSelection(s.selection, *document->molecule);
        !meant.empty()) {
        if (f.ui.button(Icon::none, ("Did you mean " + meant + "?").c_str())) {
            s.selection = s.selected = meant;
            picking.select(meant);
        }
    } else if (!selection.error.empty() && goesOn)
        f.ui.caption("Not complete: possible continuations are above.");
    else if (!selection.error.empty())
        f.ui.warning(selection.error);
    else if (selection.any() && selection.count == 0)
        f.ui.caption("No atoms match.");
    else if (selection.any())
        f.ui.caption(selectedText(selection.count));
    else
        f.ui.caption("Nothing selected.");
    if (selection.any() && selection.count > 0) {
        f.ui.heading("Actions");
        drawSelectionActions(f, selection.text);
    }
    if (!f.s.ruleError.empty()) f.ui.warning(f.s.ruleError);
    drawContactList(f);
    drawRules(f);
}

}  // namespace nacre::app
