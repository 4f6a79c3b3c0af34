// The pages of parts (models, assemblies, and rows of chains, ligands, ions and water), of words in the picture
// (labels, measurements, title, scale and legend, all saved with it), and of what else there is: motion, the window
// itself, developer tools.

#include <algorithm>
#include <string>

#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/input_names.h"
#include "app/picture/option_values.h"
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
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < molecule.assemblies.size(); ++i)
        if (molecule.assemblies[i].id == f.look.look.assembly) chosen = i + 1;
    if (f.ui.choose("Assembly", names, chosen))
        f.look.look.assembly = chosen == 0 ? "" : molecule.assemblies[chosen - 1].id;
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

/// A measurement's atoms and value; while the atoms are not drawn, its text as written.
std::string rowText(const Measure& measure, const PlacedWords& placed) {
    for (const PlacedMeasure& at : placed.measures)
        if (at.of == measure.text) return at.text + ", " + at.atoms;
    return "Atoms " + measure.text;
}

/// A row each, with a sign that removes it. @param id  of the first row
template <typename Word, typename TextOf>
void listWords(PanelFrame& f, int id, std::vector<Word>& words, TextOf textOf) {
    const float side = f.ui.rowHeight();
    std::erase_if(words, [&](const Word& word) {
        ImGui::PushID(id++);
        const float x = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
        f.ui.name(textOf(word), room - side - f.ui.px(8));
        ImGui::SameLine(x + room - side);
        const bool gone = f.ui.sign(Icon::close, "Remove");
        ImGui::PopID();
        return gone;
    });
}

void drawForDevelopers(PanelFrame& f) {
    f.ui.heading("Debug views");
    const auto names = debugViewNames();
    const std::vector<const char*> choices(names.begin(), names.end());
    DebugView debug = f.viewer.frames().debugView();
    if (f.ui.choose("Debug view", choices, debug)) f.viewer.frames().setDebugView(debug, f.now);
    if (f.host.captures && f.ui.button(Icon::none, "Capture a frame (F12)", -1))
        f.host.run(ViewerCommand::captureFrame);
    if (f.host.copyReport && f.ui.button(Icon::none, "Copy report", -1)) f.host.copyReport();
    if (f.host.statistics) f.ui.caption(f.host.statistics());
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
}

void drawLabelsPage(PanelFrame& f) {
    Words& words = f.look.words;
    f.ui.caption("Included in saved images and views.");
    f.ui.heading("Title");
    if (!f.s.typingTitle) f.s.title = words.title;
    f.ui.field("Title", "None", f.s.title);
    f.s.typingTitle = ImGui::IsItemActive();
    if (f.ui.edited()) f.s.take([&] { words.title = parseTitle(f.s.title); });
    if (!f.s.ruleError.empty()) f.ui.warning(f.s.ruleError);
    toggleOption(f, "legend");
    f.ui.heading("Scale bar");
    chooseOption(f, "scale-bar");
    f.ui.heading("Measurements");
    Picking& picking = f.viewer.picking();
    constexpr const char* kModes[] = {"Measure nothing", "Measure distances", "Measure angles", "Measure torsions"};
    Measuring measuring = picking.measuring();
    if (f.ui.choose("Measure", kModes, measuring)) picking.measure(measuring);
    if (measuring != Measuring::off)
        f.ui.caption((f.ui.forFingers() ? "Tap " : "Click ") + std::to_string(picking.mostPicks()) +
                     " atoms. One more starts again.");
    if (picking.picks().size() > 1) {
        f.ui.paragraph(picking.annotations().measurement);
        if (f.ui.button(Icon::none, "Pin measurement")) f.host.run(ViewerCommand::keepMeasurement);
    }
    listWords(f, 0, words.measures,
              [&](const Measure& measure) { return rowText(measure, f.viewer.words().placed()); });
    f.ui.heading("Labels");
    if (words.labels.empty())
        f.ui.caption("Choose atoms under \"Select\", then \"Label\".");
    else
        toggleOption(f, "show-labels");
    listWords(f, 1000, words.labels, [](const Label& label) { return label.selection.text; });
}

void drawMorePage(PanelFrame& f) {
    f.ui.heading("Motion");
    bool spinning = f.viewer.motion().autoRotation(), rocking = f.viewer.motion().rocking();
    if (f.ui.toggle("Spin", spinning)) f.host.run(ViewerCommand::autoRotate);
    if (f.ui.toggle("Rock", rocking)) f.host.run(ViewerCommand::rock);
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (f.ui.button(Icon::none, "Align axes", half)) f.host.run(ViewerCommand::orient);
    ImGui::SameLine();
    if (f.ui.button(Icon::none, "Reset view", half)) f.host.run(ViewerCommand::reset);
    f.ui.heading("View");
    if (f.ui.button(Icon::save, "Save this view", -1)) f.host.run(ViewerCommand::saveView);
    if (f.host.savesScenes && f.ui.button(Icon::save, "Save as MolViewSpec", -1)) f.host.run(ViewerCommand::saveScene);
    if (f.host.record) {
        if (f.ui.button(Icon::eye, "Add keyframe", -1)) f.host.run(ViewerCommand::keepView);
        if (f.ui.button(Icon::record, "Record movie", -1)) f.host.run(ViewerCommand::record);
    }
    f.ui.heading("Panel");
    constexpr const char* kBrightness[] = {"Theme: system", "Theme: dark", "Theme: light"};
    if (f.ui.choose("Brightness", kBrightness, f.s.brightness)) f.s.setBrightness(f.s.brightness);
    ImGui::Spacing();
    if (f.ui.button(f.s.developers ? Icon::up : Icon::down, "For developers", -1)) f.s.developers = !f.s.developers;
    if (f.s.developers) drawForDevelopers(f);
}

}  // namespace nacre::app
