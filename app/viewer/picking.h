#pragma once
// What the pointer and fingers point at: picked atoms and what they measure, the selection, the atom under a pointer
// that rests.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/frames.h"

namespace nacre::app {

/// What a shell draws over the picture, in points from the window's top left.
struct Annotations {
    std::vector<glm::dvec2> atoms;     ///< picked, in their order; a line joins each to the next
    std::string atom;                  ///< what the last one is
    std::string measurement;           ///< what they measure, and how many atoms more that takes
    std::string message;               ///< of the last command, or of what went wrong
    std::string error;                 ///< what went wrong, until it is dismissed (ViewerOptions::errorsStay)
    std::vector<glm::dvec2> selected;  ///< atoms of the selection; of many, some
    std::string hover;                 ///< what the pointer rests on
    std::string coarse;                ///< that a moving picture is not as sharp as one at rest
};

/// What is selected: a text that is being typed, or what was clicked.
struct SelectedAtoms {
    std::string text;
    std::string error;      ///< why the text is no selection
    std::size_t count = 0;  ///< atoms of the molecule
    bool any() const { return !text.empty() && error.empty(); }
};

/// What clicks on atoms measure. One more atom than it takes starts anew.
enum class Measuring { off, distance, angle, torsion };
constexpr const char* kMeasurings[] = {"off", "distance", "angle", "torsion"};

class Picking {
public:
    Picking(Stage& stage, Frames& frames) : stage_(stage), frames_(frames) {}

    // Places in points
    void tap(glm::dvec2 at, double now);
    /// Its first tap was no pick. @returns the residue that it means; nothing: all of the molecule
    std::optional<Selection> doubleTap(glm::dvec2 at, double now);
    void pointerMoved(glm::dvec2 at, double now) { pointer_ = Pointer{at, now}; }
    /// The pointer has left the picture.
    void pointerLeft();

    void measure(Measuring what);
    Measuring measuring() const { return measuring_; }
    /// Atoms that are picked at most: one where nothing is measured.
    std::size_t mostPicks() const { return static_cast<std::size_t>(measuring_) + 1; }

    /// Picked atoms, from 0, in their order.
    const std::vector<std::uint32_t>& picks() const { return picks_; }
    /// Selects by text; an empty one selects nothing.
    void select(const std::string& text);
    const SelectedAtoms& selection() const { return selected_; }
    /// Nothing is picked.
    void drop() { picks_.clear(); }
    /// The same atoms are elsewhere, or are seen in another way.
    void placeSelection();

    /// @returns when something is due; infinity: never
    double advance(double now);
    Annotations annotations() const;
    /// The view as it is saved: what the picked atoms measure stays.
    PictureDescription savedView() const;

private:
    struct Pointer {
        glm::dvec2 at;
        double since;
        bool asked = false;  ///< what it rests on was looked for
    };
    std::vector<std::uint32_t> markedAtoms(const std::vector<bool>& chosen) const;
    bool hovers() const { return hovered_ > 0 && seen_ == stage_.changes(); }

    std::string measurement(const std::vector<glm::dvec3>& places) const;

    Stage& stage_;
    Frames& frames_;
    Measuring measuring_ = Measuring::off;
    std::vector<std::uint32_t> picks_, picksBefore_;  // atoms, from 0
    SelectedAtoms selected_;
    std::vector<glm::dvec3> selectedPlaces_;  // from the scene's centre
    std::optional<Pointer> pointer_;          // over the molecule
    std::uint32_t hovered_ = 0;               // atom, from 1
    std::uint64_t seen_ = 0;                  // Stage::changes() that it is of
};

}  // namespace nacre::app
