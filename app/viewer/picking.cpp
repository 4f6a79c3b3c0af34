#include "app/viewer/picking.h"

#include <algorithm>

#include "app/annotation/measurement.h"
#include "app/picture/input_names.h"
#include "app/viewer/parts.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/scene/build/scene_layers.h"

namespace nacre::app {
namespace {

/// An atom's name in the format of words, after a scene file's tooltip.
std::string hoverText(const Molecule& molecule, std::uint32_t atom) {
    const std::string tip = molecule.guide ? joinTooltips(*molecule.guide, atom) : std::string();
    return tip + (tip.empty() ? "" : "; ") + atomText(molecule, atom);
}

constexpr double kFingerPoints = 12;    // tolerance of a pick
constexpr double kHoverPoints = 2;      // likewise for a resting pointer
constexpr double kHoverSeconds = 0.08;  // time at rest before the atom under it is looked up

/// A typed selection: `/name` is one of several molecules. @throws std::invalid_argument
Selection resolveSelection(const std::string& text, const PictureDescription& view) {
    Selection selection = parseSelection(text);
    if (view.input.several()) nameInputs(inputNames(makeInput(view)), selection);
    return selection;
}

/// For each atom of the file, whether a drawn primitive belongs to it.
std::vector<bool> seenAtoms(const Representation& scene, std::size_t atoms) {
    std::vector<bool> seen(atoms + 1);  // numbers begin at 1
    const auto see = [&](std::uint32_t atom) {
        if (atom <= atoms) seen[atom] = true;
    };
    for (const SphereLook& look : scene.sphereLooks) see(look.atom);
    for (const CylinderLook& look : scene.cylinderLooks) see(look.atomA), see(look.atomB);
    for (const SphereLook& look : scene.meshLooks) see(look.atom);
    seen.erase(seen.begin());
    return seen;
}

/// The residue of an atom as a selection; the atom if the residue is the whole molecule.
std::string residueText(const Document& document, std::uint32_t atom) {
    const Molecule& molecule = *document.molecule;
    const std::uint32_t number = molecule.atoms[atom].residue;
    const Residue& residue = molecule.residues[number];
    if (residue.atomCount == molecule.atoms.size() || residue.name.view().empty())
        return "id " + std::to_string(atom + 1);
    std::string input;
    if (molecule.modelsAreInputs && !document.view.input.further.empty())  // a scene names no structures
        input =
            inputNames(makeInput(document.view))[static_cast<std::size_t>(molecule.chains[residue.chain].model - 1)];
    return residuesText(molecule, number, number, input);
}

/// Both residues of a contact.
std::string residuesText(const DrawnContact& contact) {
    return "byres (id " + std::to_string(contact.interaction.a.atoms.front() + 1) + "+" +
           std::to_string(contact.interaction.b.atoms.front() + 1) + ")";
}

}  // namespace

void Picking::tap(glm::dvec2 at, double now) {
    picksBefore_ = picks_;
    const std::optional<std::uint32_t> atom = frames_.atomAt(at, kFingerPoints, now);
    if (!atom) return;
    stage_.schedule.overlayChanged();
    stage_.messages.clear();
    pointerLeft();
    if (*atom == 0 || stage_.document.drawing.scene().noteNumber(*atom) > 0) {
        picks_.clear();
        select("");
        return;
    }
    if (const DrawnContact* contact = stage_.document.drawing.scene().findContact(*atom)) {
        picks_.clear();
        select(residuesText(*contact));
        return;
    }
    if (measuring_ == Measuring::off) select(residueText(stage_.document, *atom - 1));
    if (!picks_.empty() && picks_.back() == *atom - 1) return;
    if (picks_.size() >= mostPicks()) picks_.clear();
    picks_.push_back(*atom - 1);
}

void Picking::ask(glm::dvec2 at, double now) {
    if (!stage_.shown()) return;
    tap(at, now);
    asked_ = at;
    stage_.schedule.overlayChanged();
}

void Picking::measure(Measuring what) {
    measuring_ = what;
    if (picks_.size() > mostPicks() || what == Measuring::off) picks_.clear();
    stage_.schedule.overlayChanged();
}

/// Off the molecule, or if one residue is everything, aims at the whole; on a dash, at the residues that it joins.
std::optional<Selection> Picking::doubleTap(glm::dvec2 at, double now) {
    picks_ = picksBefore_;
    stage_.schedule.overlayChanged();
    std::uint32_t atom = frames_.atomAt(at, kFingerPoints, now).value_or(0);
    if (stage_.document.drawing.scene().noteNumber(atom) > 0) atom = 0;
    if (const DrawnContact* contact = stage_.document.drawing.scene().findContact(atom))
        return parseSelection(residuesText(*contact));
    if (atom == 0 || stage_.document.molecule->residues.size() < 2) return std::nullopt;
    return parseSelection(residueText(stage_.document, atom - 1));
}

void Picking::pointerLeft() {
    pointer_.reset();
    if (std::exchange(hovered_, 0) == 0) return;
    stage_.schedule.overlayChanged();
    mark();
}

/// The picture may have changed under the pointer: hides the old name, and looks up the atom when both are at rest.
double Picking::advance(double now) {
    if (std::exchange(seen_, stage_.changes()) != stage_.changes()) {
        hovered_ = 0;
        mark();
        if (pointer_) pointer_->asked = false;
    }
    if (!pointer_ || pointer_->asked) return std::numeric_limits<double>::infinity();
    const double due = std::max(pointer_->since, stage_.changedAt()) + kHoverSeconds;
    if (now < due) return due;
    pointer_->asked = true;
    if (!stage_.motion.moving())
        if (const std::uint32_t atom = frames_.atomAt(pointer_->at, kHoverPoints, now).value_or(0);
            std::exchange(hovered_, atom) != atom) {
            stage_.schedule.overlayChanged();
            mark();
        }
    return std::numeric_limits<double>::infinity();
}

// --- the selection

void Picking::select(const std::string& text) {
    if (text != selected_.text) stage_.schedule.overlayChanged();
    selected_ = {};
    selected_.text = text;
    placeSelection();
}

/// The atoms to mark for a selection: those that are drawn. For a residue drawn only as a ribbon or a surface, marks
/// the atoms that carry it.
std::vector<bool> Picking::markedAtoms(const std::vector<bool>& chosen) const {
    const Molecule& m = *stage_.document.molecule;
    const std::vector<bool> seen = seenAtoms(stage_.document.drawing.scene(), m.atoms.size());
    std::vector<bool> marked(m.atoms.size());
    for (const std::uint32_t atom : drawnAtoms(m, stage_.view().drawn)) {
        if (!chosen[atom]) continue;
        const Residue& residue = m.residues[m.atoms[atom].residue];
        std::uint32_t at = seen[atom] ? atom : residue.firstAtom;
        while (at < residue.firstAtom + residue.atomCount && !seen[at]) ++at;
        if (at < residue.firstAtom + residue.atomCount) marked[at] = true;
    }
    return marked;
}

/// Marks the selected atoms in the current scene, and those that a click would select.
void Picking::placeSelection() {
    selected_.error.clear();
    selected_.count = 0;
    marked_.clear();
    if (!selected_.text.empty() && stage_.shown()) try {
            const Document& document = stage_.document;
            const std::vector<bool> chosen =
                selectAtoms(*document.placed, resolveSelection(selected_.text, document.view));
            selected_.count = static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true));
            if (selected_.count > 0) marked_ = markedAtoms(chosen);
        } catch (const std::exception& error) {
            selected_.error = error.what();
        }
    mark();
}

void Picking::mark() {
    Highlights marks{marked_};
    if (hovers() && hovered_ <= stage_.document.molecule->atoms.size()) {
        const Molecule& m = *stage_.document.molecule;
        const Residue& residue = m.residues[m.atoms[hovered_ - 1].residue];
        const bool one = measuring_ != Measuring::off || residue.atomCount == m.atoms.size();
        marks.firstHovered = one ? hovered_ - 1 : residue.firstAtom;
        marks.hovered = one ? 1 : residue.atomCount;
    }
    frames_.setMarks(std::move(marks));
}

// --- texts

Annotations Picking::annotations() const {
    Annotations a;
    a.message = stage_.messages.message();
    a.error = stage_.messages.failure();
    a.coarse = frames_.coarseness();
    if (!stage_.shown()) return a;
    const Document& document = stage_.document;
    if (const DrawnContact* contact = hovers() ? document.drawing.scene().findContact(hovered_) : nullptr)
        a.hover = contactText(*document.molecule, contact->interaction);
    else if (const std::uint32_t note = hovers() ? document.drawing.scene().noteNumber(hovered_) : 0; note > 0)
        a.hover = note <= document.drawing.maps().notes.size() ? document.drawing.maps().notes[note - 1] : "";
    else if (hovers() && hovered_ <= document.molecule->atoms.size())
        a.hover = hoverText(*document.molecule, hovered_ - 1);
    std::vector<glm::dvec3> places;
    for (const std::uint32_t pick : picks_) {
        const glm::dvec3 place = document.placed->atoms[pick].position;
        places.push_back(place);
    }
    const std::vector<FreePart> parts = frames_.freeParts();
    for (const FreePart& part : parts)
        for (const glm::dvec3& place : places)
            (&part == &parts[0] ? a.atoms : a.otherAtoms)
                .push_back(frames_.projectPoint(place - document.drawing.scene().center, part.view) +
                           part.corner / frames_.pixelsPerPoint());
    if (!picks_.empty()) a.atom = atomText(*document.molecule, picks_.back());
    a.measurement = measurement(places);
    return a;
}

/// @param places  of the picked atoms, Å
std::string Picking::measurement(const std::vector<glm::dvec3>& places) const {
    std::string text = measurementText(places);
    const std::size_t left = mostPicks() - places.size();
    if (measuring_ == Measuring::off || left == 0) return text;
    text += (text.empty() ? "" : "; ") + std::string(kMeasurings[static_cast<std::size_t>(measuring_)]) + ": ";
    text += (places.empty() ? "pick " : "") + std::to_string(left) + (places.empty() ? "" : " more");
    return text + (left == 1 ? " atom" : " atoms");
}

PictureDescription Picking::measuredView() const {
    PictureDescription view = stage_.view();
    if (picks_.size() < 2) return view;
    std::string atoms;
    for (const std::uint32_t pick : picks_) atoms += (atoms.empty() ? "" : ",") + std::to_string(pick + 1);
    const Measure measure = parseMeasure(atoms);
    std::vector<Measure>& kept = view.words.measures;
    if (std::find(kept.begin(), kept.end(), measure) == kept.end()) kept.push_back(measure);
    return view;
}

}  // namespace nacre::app
