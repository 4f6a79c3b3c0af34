// What the molecule is made of: models, assemblies, and rows of chains, ligands, ions and water.

#include <algorithm>
#include <cstdio>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/input_names.h"
#include "app/picture/option_values.h"
#include "engine/scene/colors.h"

namespace nacre::app {
namespace {

std::string countOf(const Part& part) {
    switch (part.kind) {
        case Part::Kind::chain:
            return std::to_string(part.residues) + (part.residues == 1 ? " residue" : " residues");
        case Part::Kind::all:
            return std::to_string(part.atoms) + " atoms";
        default:
            return "× " + std::to_string(part.residues);
    }
}

}  // namespace

void Panel::drawPartsPage(SavedView& look, Viewer& viewer) {
    Widgets& ui = state_->ui;
    const Document* document = viewer.document();
    if (!document) return ui.caption("No molecule is open.");
    if (state_->molecule != document->molecule) {
        state_->molecule = document->molecule;
        const bool several = document->molecule->modelsAreInputs;
        state_->parts =
            partsOf(*document->molecule, several ? inputNames(inputOf(document->view)) : std::vector<std::string>());
        state_->unfolded.clear();
        state_->folds.clear();
        state_->residueColors.clear();
    }
    drawAssemblies(look, *document->molecule);
    Part::Kind last = Part::Kind::all;
    std::string input;
    std::size_t number = 0;
    for (const Part& part : state_->parts) {
        const bool another = part.input != input;
        if (another && !part.input.empty()) {
            ui.title(part.input);
            if (number > 0) drawFit(look, part.input, state_->parts.front().input);
        }
        input = part.input;
        if (number == 0 || another || part.kind != last) {
            constexpr const char* kHeadings[] = {"Molecule", "Chains", "Ligands", "Ions", "Water"};
            ui.heading(kHeadings[static_cast<std::size_t>(part.kind)]);
        }
        last = part.kind;
        drawPart(look, part, number++);
        if (state_->unfolded == part.selection) drawSequence(part, look, viewer);
    }
    if (state_->parts.size() >= kMostParts) ui.caption("Of more parts, the first 200 are listed.");
    ui.toggle("Hydrogens", look.drawn.hydrogens);
}

/// A molecule laid onto the first of several.
void Panel::drawFit(const SavedView& look, const std::string& input, const std::string& onto) {
    const auto isIt = [&](const FitOptions& fit) { return fit.moving.text == "/" + input; };
    std::vector<FitOptions> fits = look.fits;
    bool laid = std::any_of(fits.begin(), fits.end(), isIt);
    if (!state_->ui.toggle(("Laid onto " + onto).c_str(), laid)) return;
    std::erase_if(fits, isIt);
    if (laid) fits.push_back({parseSelection("/" + input), parseSelection("/" + onto)});
    wanted_ = look;
    wanted_->fits = std::move(fits);
    nameInputs(*wanted_);
}

void Panel::drawAssemblies(SavedView& look, const Molecule& molecule) {
    if (molecule.assemblies.empty()) return;
    Widgets& ui = state_->ui;
    ui.heading("Assembly");
    std::vector<std::string> texts{"As in the file"};
    for (const Assembly& assembly : molecule.assemblies) {
        std::size_t copies = 0;
        for (const AssemblyPart& part : assembly.parts) copies = std::max(copies, part.transforms.size());
        texts.push_back("Assembly " + assembly.id + ", " + std::to_string(copies) +
                        (copies == 1 ? " copy" : " copies"));
    }
    std::vector<const char*> names;
    for (const std::string& text : texts) names.push_back(text.c_str());
    std::string chosen = texts[0];
    for (std::size_t i = 0; i < molecule.assemblies.size(); ++i)
        if (molecule.assemblies[i].id == look.look.assembly) chosen = texts[i + 1];
    if (!ui.choose("Assembly", names, chosen)) return;
    look.look.assembly.clear();
    for (std::size_t i = 0; i < molecule.assemblies.size(); ++i)
        if (chosen == texts[i + 1]) look.look.assembly = molecule.assemblies[i].id;
}

/// A row: an eye, the name, a style and a colour. What finds no room, as for fingers, unfolds below.
void Panel::drawPart(SavedView& look, const Part& part, std::size_t number) {
    Widgets& ui = state_->ui;
    ImGui::PushID(static_cast<int>(number));
    PartLook of = lookOf(look, part);
    const float x = ImGui::GetCursorPosX(), side = ui.rowHeight(), room = ImGui::GetContentRegionAvail().x;
    const bool tight = forFingers() || room < ui.px(240);
    const float styles = tight ? 0 : ui.px(104), gap = ui.px(4);
    const std::string eye = (of.seen ? "Hide " : "Show ") + part.name;
    if (ui.sign(of.seen ? Icon::eye : Icon::eyeOff, eye.c_str())) {
        of.seen = !of.seen;
        setLookOf(look, part, of);
    }
    ImGui::SameLine(x + side + gap);
    const float nameWidth = room - 2 * side - styles - 4 * gap;
    const bool open = state_->unfolded == part.selection;
    if (part.kind == Part::Kind::chain || tight) {
        if (ui.row(open ? Icon::up : Icon::down, part.name, nameWidth)) {
            state_->unfolded = open ? "" : part.selection;
            state_->sequence.clear();
            if (part.kind == Part::Kind::chain) state_->sequence = sequenceOf(*state_->molecule, part.chain);
            state_->sequenceInput = part.input;
            state_->dragFrom = state_->dragTo = -1;
        }
        ui.controls.back().value = countOf(part) + (open ? ", open" : "");
    } else {
        ui.name(part.name + " " + countOf(part), nameWidth);
    }
    if (!tight) {
        ImGui::SameLine(x + side + nameWidth + 2 * gap);
        drawStyleChoice(look, part, styles);
    }
    ImGui::SameLine(x + room - side);
    drawColorChoice(look, part);
    if (tight && open) drawStyleChoice(look, part, -1);
    ImGui::PopID();
}

void Panel::drawStyleChoice(SavedView& look, const Part& part, float width) {
    PartLook of = lookOf(look, part);
    std::vector<const char*> names;
    std::string chosen = "As all";
    for (const StyleWord& word : styleWords()) {
        names.push_back(word.style ? word.word : "As all");
        if (of.style && word.style == of.style) chosen = word.word;
    }
    if (!state_->ui.choose(("Style of " + part.name).c_str(), names, chosen, width)) return;
    of.style.reset();
    for (const StyleWord& word : styleWords())
        if (chosen == word.word) of.style = word.style;
    setLookOf(look, part, of);
}

/// A field of colour that opens swatches, schemes and a picker.
void Panel::drawColorChoice(SavedView& look, const Part& part) {
    Widgets& ui = state_->ui;
    PartLook of = lookOf(look, part);
    const bool own = of.coloring && of.coloring->scheme == ColorScheme::uniform;
    const ImU32 shown = own ? of.coloring->color | 0xff000000u : ImGui::GetColorU32(ui.theme().field);
    const std::string name = "Colour of " + part.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ui.swatch(name.c_str(), shown, false)) ImGui::OpenPopup("Colour");
    ui.controls.back().value = of.coloring ? coloringText(*of.coloring) : "as all";
    if (!own) ui.showManyColors(at);
    if (!ImGui::BeginPopup("Colour")) return;
    const auto take = [&](std::optional<Coloring> coloring) {
        of.coloring = coloring;
        setLookOf(look, part, of);
    };
    ui.name(name);
    if (const auto color = ui.pickColor("Own colour", own ? std::optional(shown) : std::nullopt))
        take(Coloring::uniform(*color));
    if (ui.button(Icon::none, "As all")) take(std::nullopt);
    ImGui::SameLine();
    if (ui.button(Icon::none, "By element")) take(Coloring(ColorScheme::element));
    ImGui::EndPopup();
}

}  // namespace nacre::app
