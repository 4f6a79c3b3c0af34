// The page of parts: models, assemblies, and rows of chains, ligands, ions and water.

#include <algorithm>
#include <string>

#include "app/drawing/scenes.h"
#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/input_names.h"
#include "app/viewer/picture_words.h"
#include "engine/scene/color/colors.h"

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

/// A molecule superposed on the first of several.
void drawFit(PanelFrame& f, const std::string& input, const std::string& onto) {
    const auto isIt = [&](const FitOptions& fit) { return fit.moving.text == "/" + input; };
    const PictureDescription& look = f.look;
    std::vector<FitOptions> fits = look.input.fits;
    bool laid = std::any_of(fits.begin(), fits.end(), isIt);
    if (!f.ui.toggle(("Superposed on " + onto).c_str(), laid)) return;
    std::erase_if(fits, isIt);
    if (laid) fits.push_back({parseSelection("/" + input), parseSelection("/" + onto)});
    PictureDescription& view = f.s.wanted.emplace(look);
    view.input.fits = std::move(fits);
    nameInputs(view);
}

void drawAssemblies(PanelFrame& f, const Molecule& molecule) {
    if (molecule.assemblies.empty()) return;
    f.ui.heading("Assembly");
    std::vector<std::string> texts{"As in the file"};
    for (const Assembly& assembly : molecule.assemblies) {
        std::size_t copies = 0;
        for (const AssemblyPart& part : assembly.parts) copies = std::max(copies, part.transforms.size());
        texts.push_back("Assembly " + assembly.id + ", " + std::to_string(copies) +
                        (copies == 1 ? " copy" : " copies"));
    }
    std::vector<const char*> names;
    for (const std::string& text : texts) names.push_back(text.c_str());
    std::string& assembly = f.look.look.assembly;
    const std::string& shown = assembly.empty() ? molecule.file.packed : assembly;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < molecule.assemblies.size(); ++i)
        if (molecule.assemblies[i].id == shown) chosen = i + 1;
    if (!f.ui.choose("Assembly", names, chosen)) return;
    if (chosen > 0)
        assembly = molecule.assemblies[chosen - 1].id;
    else
        assembly = molecule.file.packed.empty() ? "" : kNoAssembly;
}

void drawStyleChoice(PanelFrame& f, const Part& part, float width) {
    PartLook of = lookOf(f.look, part);
    if (chooseStyle(f.ui, ("Style of " + part.name).c_str(), "Default", of.style, width)) setLookOf(f.look, part, of);
}

/// A field of colour that opens swatches, schemes and a picker.
void drawColorChoice(PanelFrame& f, const Part& part) {
    PartLook of = lookOf(f.look, part);
    const bool own = of.coloring && of.coloring->scheme == ColorScheme::uniform;
    const ImU32 shown = own ? of.coloring->color | 0xff000000u : ImGui::GetColorU32(f.ui.theme().field);
    const std::string name = "Colour of " + part.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (f.ui.swatch(name.c_str(), shown, false)) ImGui::OpenPopup("Colour");
    f.ui.controls.back().value = of.coloring ? coloringText(*of.coloring) : "same as molecule";
    if (!own) f.ui.showManyColors(at);
    if (!ImGui::BeginPopup("Colour")) return;
    const auto take = [&](std::optional<Coloring> coloring) {
        of.coloring = coloring;
        setLookOf(f.look, part, of);
    };
    f.ui.name(name);
    if (const auto color = f.ui.pickColor("Custom colour", own ? std::optional(shown) : std::nullopt))
        take(Coloring::uniform(*color));
    if (f.ui.button(Icon::none, "Default")) take(std::nullopt);
    ImGui::SameLine();
    if (f.ui.button(Icon::none, "By element")) take(Coloring(ColorScheme::element));
    ImGui::EndPopup();
}

/// A row: an eye, the name, a style and a colour. With touch, controls without room go below.
void drawPart(PanelFrame& f, const Part& part, std::size_t number) {
    ImGui::PushID(static_cast<int>(number));
    PartLook of = lookOf(f.look, part);
    const float x = ImGui::GetCursorPosX(), side = f.ui.rowHeight(), room = ImGui::GetContentRegionAvail().x;
    const bool tight = f.ui.forFingers() || room < f.ui.px(240);
    const float styles = tight ? 0 : f.ui.px(104), gap = f.ui.px(4);
    const std::string eye = (of.seen ? "Hide " : "Show ") + part.name;
    if (f.ui.sign(of.seen ? Icon::eye : Icon::eyeOff, eye.c_str())) {
        of.seen = !of.seen;
        setLookOf(f.look, part, of);
    }
    ImGui::SameLine(x + side + gap);
    const float nameWidth = room - 2 * side - styles - 4 * gap;
    const bool open = f.s.sequence.part == part.selection;
    if (part.kind == Part::Kind::chain || tight) {
        if (f.ui.row(open ? Icon::up : Icon::down, part.name, nameWidth)) {
            f.s.sequence.part = open ? "" : part.selection;
            f.s.sequence.residues.clear();
            if (part.kind == Part::Kind::chain) f.s.sequence.residues = sequenceOf(*f.s.facts, part.chain);
            f.s.sequence.input = part.input;
            f.s.sequence.dragFrom = f.s.sequence.dragTo = -1;
        }
        f.ui.controls.back().value = countOf(part) + (open ? ", open" : "");
    } else {
        f.ui.name(part.name + " " + countOf(part), nameWidth);
    }
    if (!tight) {
        ImGui::SameLine(x + side + nameWidth + 2 * gap);
        drawStyleChoice(f, part, styles);
    }
    ImGui::SameLine(x + room - side);
    drawColorChoice(f, part);
    if (tight && open) drawStyleChoice(f, part, -1);
    ImGui::PopID();
}

}  // namespace

void drawPartsPage(PanelFrame& f) {
    const Document* document = f.viewer.document();
    if (!document) return f.ui.caption("No molecule is open.");
    if (f.s.molecule != document->molecule) {
        f.s.molecule = document->molecule;
        f.s.facts = ResidueFacts(*f.s.molecule);
        const bool several = document->molecule->modelsAreInputs;
        f.s.parts = partsOf(*f.s.facts, several ? inputNames(inputOf(document->view)) : std::vector<std::string>());
        f.s.sequence.part.clear();
        f.s.sequence.colors.clear();
        f.s.reading.clear();
        for (const ReadNote& note : readingOf(*f.s.molecule)) f.s.reading.push_back(sentenceOf(note));
    }
    const FileSummary file = document->molecule->modelsAreInputs ? FileSummary() : document->molecule->file;
    if (!file.title.empty()) f.ui.paragraph(file.title);
    if (const std::string origin = originText(file); !origin.empty()) f.ui.caption(origin);
    f.ui.heading("What am I seeing?");
    f.ui.paragraph(f.viewer.explanation());
    drawAssemblies(f, *document->molecule);
    Part::Kind last = Part::Kind::all;
    std::string input;
    std::size_t number = 0;
    for (const Part& part : f.s.parts) {
        const bool another = part.input != input;
        if (another && !part.input.empty()) {
            f.ui.title(part.input);
            if (number > 0) drawFit(f, part.input, f.s.parts.front().input);
        }
        input = part.input;
        if (number == 0 || another || part.kind != last) {
            constexpr const char* kHeadings[] = {"Molecule", "Chains", "Ligands", "Ions", "Water"};
            f.ui.heading(kHeadings[static_cast<std::size_t>(part.kind)]);
        }
        last = part.kind;
        drawPart(f, part, number++);
        if (f.s.sequence.part == part.selection) drawSequence(f, part);
    }
    if (f.s.parts.size() >= kMostParts) f.ui.caption("Only the first 200 parts are listed.");
    toggleOption(f, "hydrogens");
    f.ui.heading("How the file was read");
    for (const std::string& sentence : f.s.reading) f.ui.caption(sentence);
}

}  // namespace nacre::app
