// What the pointer and fingers point at: names, measurements, the selection.

#include <algorithm>

#include "app/annotation/measurement.h"
#include "app/picture/input_names.h"
#include "app/viewer/parts.h"
#include "app/viewer/viewer.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"

namespace nacre::app {
namespace {

constexpr double kFingerPoints = 12;      // what a pick may miss by
constexpr double kHoverPoints = 2;        // and a pointer that rests
constexpr std::size_t kMostMarks = 3000;  // of a selection: of more atoms, some

/// A selection as it is typed: `/name` is one of several molecules. @throws std::invalid_argument
Selection selectionOf(const std::string& text, const SavedView& view) {
    Selection selection = parseSelection(text);
    if (!view.further.empty()) nameInputs(inputNames(inputOf(view)), selection);
    return selection;
}

/// Of each atom of the file, whether something that is drawn is of it.
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

/// The residue of an atom, as one would type it; the atom where its residue is the whole molecule.
std::string residueText(const Document& document, std::uint32_t atom) {
    const Molecule& molecule = *document.molecule;
    const std::uint32_t number = molecule.atoms[atom].residue;
    const Residue& residue = molecule.residues[number];
    if (residue.atomCount == molecule.atoms.size() || residue.name.view().empty())
        return "id " + std::to_string(atom + 1);
    std::string input;
    if (molecule.modelsAreInputs)
        input = inputNames(inputOf(document.view))[static_cast<std::size_t>(molecule.chains[residue.chain].model - 1)];
    return residuesText(molecule, number, number, input);
}

}  // namespace

/// @returns the atom from 1, 0 for none; nothing if it could not be had
std::optional<std::uint32_t> Viewer::atomUnder(glm::dvec2 at, double reach, double now) {
    if (!document() || !sceneThere_) return std::nullopt;
    try {
        return screen_.atomAt(settings(), at.x * scale_, at.y * scale_, reach * scale_);
    } catch (const Error& error) {
        if (!noticeLoss()) say(error.what(), now);
        return std::nullopt;
    }
}

void Viewer::pick(glm::dvec2 at, double now) {
    picksBefore_ = picks_;
    const std::optional<std::uint32_t> atom = atomUnder(at, kFingerPoints, now);
    if (!atom) return;
    schedule_.overlayChanged();
    message_.clear();
    pointerLeft();
    if (*atom == 0) {
        picks_.clear();
        select("");
        return;
    }
    select(residueText(document_, *atom - 1));
    if (!picks_.empty() && picks_.back() == *atom - 1) return;
    if (picks_.size() == 4) picks_.clear();
    picks_.push_back(*atom - 1);
}

/// Zooms to what is there; beside the molecule, and where one residue is all of it, to the whole.
void Viewer::doubleTap(glm::dvec2 at, double now) {
    picks_ = picksBefore_;  // its first tap was no pick
    schedule_.overlayChanged();
    const std::uint32_t atom = atomUnder(at, kFingerPoints, now).value_or(0);
    if (atom != 0 && document_.molecule->residues.size() > 1) {
        Aim aim;
        aim.zoomTo = selectionOf(residueText(document_, atom - 1), document_.view);
        return takeAim(aim, true, now);
    }
    motion_.fit(now);
    unclip();
}

void Viewer::hover(double now) {
    hoverDue_.reset();
    if (motion_.moving() || !pointerAt_) return;
    const std::uint32_t atom = atomUnder(*pointerAt_, kHoverPoints, now).value_or(0);
    if (atom == hovered_) return;
    hovered_ = atom;
    schedule_.overlayChanged();
}

void Viewer::pointerLeft() {
    pointerAt_.reset();
    hoverDue_.reset();
    if (hovered_ == 0) return;
    hovered_ = 0;
    schedule_.overlayChanged();
}

// --- the selection

void Viewer::select(const std::string& text) {
    if (text != selected_.text) schedule_.overlayChanged();
    selected_ = {};
    selected_.text = text;
    placeSelection();
}

/// Which atoms are marked for those that are chosen: each that something is drawn of. A residue of which a ribbon or a
/// surface is drawn without them is marked once, where that is.
std::vector<std::uint32_t> Viewer::markedAtoms(const std::vector<bool>& chosen) const {
    const Molecule& m = *document_.molecule;
    const std::vector<bool> seen = seenAtoms(document_.scene, m.atoms.size());
    std::vector<bool> marked(m.atoms.size());
    std::vector<std::uint32_t> atoms;
    for (const std::uint32_t atom : drawnAtoms(m, view_.drawn)) {
        if (!chosen[atom]) continue;
        const Residue& residue = m.residues[m.atoms[atom].residue];
        std::uint32_t at = seen[atom] ? atom : residue.firstAtom;
        while (at < residue.firstAtom + residue.atomCount && !seen[at]) ++at;
        if (at == residue.firstAtom + residue.atomCount || marked[at]) continue;
        marked[at] = true;
        atoms.push_back(at);
    }
    return atoms;
}

/// Where the selection's atoms stand in the scene that is shown.
void Viewer::placeSelection() {
    selectedPlaces_.clear();
    selected_.error.clear();
    selected_.count = 0;
    if (selected_.text.empty() || !document()) return;
    try {
        const std::vector<bool> chosen = selectAtoms(*document_.placed, selectionOf(selected_.text, document_.view));
        selected_.count = static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), true));
        const std::vector<std::uint32_t> shown = markedAtoms(chosen);
        const std::size_t step = shown.size() / kMostMarks + 1;
        for (std::size_t i = 0; i < shown.size(); i += step)
            selectedPlaces_.push_back(glm::dvec3(document_.placed->atoms[shown[i]].position) - document_.scene.center);
    } catch (const std::exception& error) {
        selected_.error = error.what();
    }
}

// --- what is said of it

/// Of a place from the scene's centre.
glm::dvec2 Viewer::pointOf(const glm::dvec3& place, const View& view) const {
    const glm::dvec3 v = view.rotation * place;
    const double magnify =
        view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1.0;
    const glm::dvec2 q = (glm::dvec2(v) * magnify + view.pan) * view.pixelsPerAngstrom;
    return {(view.width / 2.0 + q.x) / scale_, (view.height / 2.0 - q.y) / scale_};
}

Annotations Viewer::annotations() const {
    Annotations a;
    a.message = message_;
    a.error = failure_;
    if (tellsScale_ && drawnScale_ < 1)
        a.coarse = "While it moves: " + std::to_string(std::lround(100 * drawnScale_)) + " % of the sharpness";
    if (!document()) return a;
    const View view = settings().view;
    for (const glm::dvec3& place : selectedPlaces_) a.selected.push_back(pointOf(place, view));
    if (hovered_ > 0 && hovered_ <= document_.molecule->atoms.size())
        a.hover = atomText(*document_.molecule, hovered_ - 1);
    if (picks_.empty()) return a;
    std::vector<glm::dvec3> places;
    for (const std::uint32_t pick : picks_) {
        const glm::dvec3 place = document_.placed->atoms[pick].position;
        places.push_back(place);
        a.atoms.push_back(pointOf(place - document_.scene.center, view));
    }
    a.atom = atomText(*document_.molecule, picks_.back());
    a.measurement = measurementText(places);
    return a;
}

}  // namespace nacre::app
