// The page of parts: models, assemblies, and rows of chains, ligands, ions and water.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "app/drawing/scenes.h"
#include "app/panel/panel_state.h"
#include "app/panel/words.h"
#include "app/picture/input_names.h"
#include "app/viewer/picture_words.h"
#include "engine/molecule/chemistry/drawn_orders.h"
#include "engine/molecule/matched_atoms.h"
#include "engine/molecule/text.h"
#include "engine/scene/color/colors.h"

namespace nacre::app {
namespace {

std::string formatCount(const Part& part) {
    switch (part.kind) {
        case Part::Kind::chain:
            return std::to_string(part.residues) + (part.residues == 1 ? " residue" : " residues");
        case Part::Kind::all:
            return std::to_string(part.atoms) + " atoms";
        default:
            return "× " + std::to_string(part.residues);
    }
}

/// Title, organism, method and resolution of a file.
void drawTitle(PanelFrame& f, const FileSummary& file) {
    if (!file.title.empty()) f.ui.paragraph(file.title);
    if (const std::string origin = originText(file); !origin.empty()) f.ui.caption(origin);
}

/// A row for a molecule superposed on the first of several.
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

/// Quality of each molecule's fit on the first: "812 pairs of atoms, RMSD 0.41 Å"; empty: not fitted.
std::vector<std::string> fitTexts(const ResidueFacts& facts, const InputOptions& input) {
    const Molecule& m = facts.molecule();
    std::vector<std::string> texts(input.further.size() + 1);
    for (const FitOptions& fit : input.fits) {
        const std::vector<bool> moving = selectAtoms(m, fit.moving);
        const auto first = std::find(moving.begin(), moving.end(), true) - moving.begin();
        if (static_cast<std::size_t>(first) == moving.size()) continue;
        const AtomPairs pairs = matchAtoms(facts, moving, selectAtoms(m, fit.fixed));
        double squares = 0;
        for (std::size_t i = 0; i < pairs.first.size(); ++i) {
            const glm::dvec3 apart =
                glm::dvec3(m.atoms[pairs.first[i]].position) - glm::dvec3(m.atoms[pairs.second[i]].position);
            squares += glm::dot(apart, apart);
        }
        const double count = static_cast<double>(std::max<std::size_t>(pairs.first.size(), 1));
        const bool unlike = 10 * pairs.sameResidues < 3 * pairs.residues;
        const int model = m.chains[m.residues[m.atoms[static_cast<std::size_t>(first)].residue].chain].model;
        texts.at(static_cast<std::size_t>(model - 1)) =
            formatted("%zu pairs of atoms, RMSD %.2f Å%s", pairs.first.size(), std::sqrt(squares / count),
                      unlike ? "; the sequences differ" : "");
    }
    return texts;
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

}  // namespace

std::vector<std::uint32_t> drawnColors(const Molecule& m, const Representation& scene) {
    constexpr int kCarbon = 6;
    std::vector<std::uint32_t> colors(m.atoms.size());
    std::vector<bool> hasCarbon(m.residues.size());
    const auto take = [&](std::uint32_t atom, std::uint32_t color, bool mesh) {
        if (atom == 0 || atom > m.atoms.size() || isCopyTint(color)) return;
        const bool carbon = m.atoms[atom - 1].element == kCarbon;
        if (mesh || carbon) colors[atom - 1] = color | 0xff000000u;
        if (carbon) hasCarbon[m.atoms[atom - 1].residue] = true;
    };
    for (const SphereLook& look : scene.meshLooks) take(look.atom, look.color, true);
    for (const SphereLook& look : scene.sphereLooks) take(look.atom, look.color, false);
    for (const CylinderLook& look : scene.cylinderLooks)
        take(look.atomA, look.colorA, false), take(look.atomB, look.colorB, false);
    for (std::size_t i = 0; i < colors.size(); ++i)
        if (m.atoms[i].element != kCarbon && hasCarbon[m.atoms[i].residue]) colors[i] = 0;
    return colors;
}

namespace {

/// Finds the colour of each part in the scene; empty: several colours, or not drawn.
void findPartColors(PanelFrame& f) {
    PanelState& s = f.s;
    const Drawing& drawing = f.viewer.document()->drawing;
    if (s.colorsScene == drawing.sceneNumber() && s.partColors.size() == s.parts.size()) return;
    s.colorsScene = drawing.sceneNumber();
    s.partColors.assign(s.parts.size(), std::nullopt);
    std::vector<bool> several(s.parts.size());
    const Molecule& m = *s.molecule;
    const std::vector<std::uint32_t> colors = drawnColors(m, drawing.scene());
    for (std::size_t atom = 0; atom < colors.size(); ++atom) {
        const std::uint32_t part = s.partOfResidue[m.atoms[atom].residue];
        if (colors[atom] == 0 || part == kNoPart) continue;
        std::optional<std::uint32_t>& color = s.partColors[part];
        several[part] = several[part] || (color && *color != colors[atom]);
        color = colors[atom];
    }
    for (std::size_t i = 0; i < several.size(); ++i)
        if (several[i]) s.partColors[i].reset();
}

void drawStyleChoice(PanelFrame& f, const Part& part, float width) {
    PartLook of = findLook(f.look, part);
    if (chooseStyle(f.ui, ("Style of " + part.name).c_str(), "Default", of.style, width)) setPartLook(f.look, part, of);
}

/// A field of the drawn colour, which opens swatches, schemes and a picker.
void drawColorChoice(PanelFrame& f, const Part& part, std::size_t number) {
    PartLook of = findLook(f.look, part);
    std::optional<std::uint32_t> drawn;
    if (number < f.s.partColors.size()) drawn = f.s.partColors[number];
    if (of.coloring && of.coloring->scheme == ColorScheme::uniform) drawn = of.coloring->color;
    const bool own = drawn.has_value();
    const ImU32 shown = own ? *drawn | 0xff000000u : ImGui::GetColorU32(f.ui.theme().field);
    const std::string name = "Colour of " + part.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (f.ui.swatch(name.c_str(), shown, false)) ImGui::OpenPopup("Colour");
    f.ui.controls.back().value = of.coloring ? coloringText(*of.coloring) : "same as molecule";
    if (!own) f.ui.showManyColors(at);
    if (!ImGui::BeginPopup("Colour")) return;
    const auto take = [&](std::optional<Coloring> coloring) {
        of.coloring = coloring;
        setPartLook(f.look, part, of);
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
    PartLook of = findLook(f.look, part);
    const float x = ImGui::GetCursorPosX(), side = f.ui.rowHeight(), room = ImGui::GetContentRegionAvail().x;
    const bool tight = f.ui.forFingers() || room < f.ui.px(240);
    const float styles = tight ? 0 : f.ui.px(61) + side, gap = f.ui.px(4);
    const std::string eye = (of.seen ? "Hide " : "Show ") + part.name;
    if (f.ui.sign(of.seen ? Icon::eye : Icon::eyeOff, eye.c_str())) {
        of.seen = !of.seen;
        setPartLook(f.look, part, of);
    }
    ImGui::SameLine(x + side + gap);
    const float nameWidth = room - 2 * side - styles - 4 * gap;
    const bool open = f.s.sequence.part == part.selection;
    if (part.kind == Part::Kind::chain || tight) {
        if (f.ui.row(open ? Icon::up : Icon::down, part.name, nameWidth, false, part.label)) {
            f.s.sequence.part = open ? "" : part.selection;
            f.s.sequence.residues.clear();
            if (part.kind == Part::Kind::chain) f.s.sequence.residues = findSequence(*f.s.facts, part.chain);
            f.s.sequence.input = part.input;
            f.s.sequence.dragFrom = f.s.sequence.dragTo = -1;
        }
        f.ui.controls.back().value = formatCount(part) + (open ? ", open" : "");
    } else {
        const bool structure = part.kind == Part::Kind::all && !part.input.empty();
        f.ui.name(structure ? part.name : part.name + " " + formatCount(part), nameWidth);
    }
    if (!tight) {
        ImGui::SameLine(x + side + nameWidth + 2 * gap);
        drawStyleChoice(f, part, styles);
    }
    ImGui::SameLine(x + room - side);
    drawColorChoice(f, part, number);
    if (tight && open) drawStyleChoice(f, part, -1);
    ImGui::PopID();
}

/// One of several structures as a whole: its row, a button that removes it, and its fit on the first.
void drawStructure(PanelFrame& f, const std::string& input, std::size_t number) {
    constexpr std::size_t kFirstRow = 100'000;  // beyond those of parts
    f.ui.heading(input.c_str());
    if (number < f.s.molecule->inputFiles.size()) drawTitle(f, f.s.molecule->inputFiles[number]);
    Part whole{Part::Kind::all, input, "/" + input};
    whole.input = whole.label = input;
    for (const Part& part : f.s.parts)
        if (part.input == input) whole.atoms += part.atoms;
    drawPart(f, whole, kFirstRow + number);
    if (number > 0) drawFit(f, input, f.s.parts.front().input);
    if (number < f.s.fits.size() && !f.s.fits[number].empty()) f.ui.caption(f.s.fits[number]);
    if (f.s.renamed == input) {
        const bool entered =
            f.ui.field(("Name of " + input).c_str(), "a name", f.s.newName, -1, ImGuiInputTextFlags_EnterReturnsTrue);
        if (entered) {
            f.s.take([&] { renameInput(f.s.wanted.emplace(f.look), number, f.s.newName); });
            if (!f.s.ruleError.empty()) f.s.wanted.reset();
            if (f.s.ruleError.empty()) f.s.renamed.clear(), f.viewer.picking().select("");
        }
        if (!f.s.ruleError.empty()) f.ui.warning(f.s.ruleError);
    } else if (f.ui.typable() && f.ui.word(("Rename " + input).c_str(), false)) {
        f.s.renamed = f.s.newName = input;
        f.s.ruleError.clear();
    }
    if (f.ui.word(("Remove " + input).c_str(), f.s.renamed != input && f.ui.typable())) {
        removeInput(f.s.wanted.emplace(f.look), number);
        f.viewer.picking().select("");
    }
}

/// Switches between all models of a file at once and one after another.
void drawEnsemble(PanelFrame& f) {
    const Document& document = *f.viewer.document();
    const bool several = f.viewer.playback().models() > 1 && !f.viewer.playback().hasTrajectory();
    if (!several || document.molecule->modelsAreInputs || f.look.input.conformations) return;
    bool all = f.look.input.model == kAllModels;
    if (!f.ui.toggle("All models together", all)) return;
    f.s.wanted.emplace(f.look).input.model = all ? kAllModels : 1;
}

/// Switches between several molecules and the conformations of one, which can be played.
void drawConformations(PanelFrame& f) {
    bool conformations = f.look.input.conformations;
    if (f.look.input.further.empty() || !f.ui.toggle("Conformations of one molecule", conformations)) return;
    setConformations(f.s.wanted.emplace(f.look), conformations);
    f.viewer.picking().select("");
}

/// "In the file: 327 atoms, 1 chain", "Guessed: 334 bonds (from residue templates)", and what was left out.
std::vector<std::string> readingTexts(const ReadNotes& notes) {
    std::vector<std::string> texts;
    for (const auto& [action, heading] : {std::pair(ReadAction::read, "In the file"),
                                          {ReadAction::guessed, "Guessed"},
                                          {ReadAction::leftOut, "Left out"}}) {
        std::string text;
        for (const ReadNote& note : notes) {
            if (note.action != action) continue;
            ReadNote counted = note;
            counted.why.clear();
            text += (text.empty() ? std::string(heading) + ": " : ", ") +
                    describeNote(counted).substr(readActionName(action).size() + 1) +
                    (note.why.empty() ? "" : " (" + note.why + ")");
        }
        if (!text.empty()) texts.push_back(text);
    }
    return texts;
}

}  // namespace

void drawPartsPage(PanelFrame& f) {
    const Document* document = f.viewer.document();
    if (!document) return f.ui.caption("No molecule is open.");
    if (f.s.molecule != document->molecule) {
        f.s.molecule = document->molecule;
        f.s.facts = ResidueFacts(*f.s.molecule);
        const bool several = document->molecule->modelsAreInputs && !document->view.input.further.empty();
        f.s.parts = listParts(*f.s.facts, several ? inputNames(makeInput(document->view)) : std::vector<std::string>(),
                              &f.s.partOfResidue);
        f.s.sequence.part.clear();
        f.s.sequence.colors.clear();
        f.s.fits = several ? fitTexts(*f.s.facts, document->view.input) : std::vector<std::string>();
        f.s.reading = readingTexts(listReadNotes(*f.s.molecule, drawnOrders(*f.s.facts)));
    }
    if (!document->molecule->modelsAreInputs) drawTitle(f, document->molecule->file);
    f.ui.heading("What am I seeing?");
    f.ui.paragraph(f.viewer.explanation());
    drawAssemblies(f, *document->molecule);
    Part::Kind last = Part::Kind::all;
    std::string input;
    std::size_t number = 0, structure = 0;
    drawEnsemble(f);
    drawConformations(f);
    findPartColors(f);
    for (const Part& part : f.s.parts) {
        const bool another = part.input != input;
        if (another && !part.input.empty()) drawStructure(f, part.input, structure++);
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
