#pragma once
// Picked atoms and their measurements, the selection, and the atom under a resting pointer.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/frames.h"

namespace nacre::app {

/// Overlay data for a shell, in points from the window's top left.
struct Annotations {
    std::vector<glm::dvec2> atoms;       ///< picked, in order; lines connect them
    std::vector<glm::dvec2> otherAtoms;  ///< likewise for the right eye, beside or below the left one
    std::string atom;                    ///< description of the last one
    std::string measurement;             ///< their measurement, or the number of atoms still needed
    std::string message;                 ///< of the last command, or an error
    std::string error;                   ///< an error, until it is dismissed (ViewerOptions::errorsStay)
    std::string hover;                   ///< under the pointer
    std::string coarse;                  ///< notice of reduced resolution during motion
};

/// The selection: typed text, or clicked atoms.
struct SelectedAtoms {
    std::string text;
    std::string error;      ///< why the text is invalid
    std::size_t count = 0;  ///< selected atoms
    bool any() const { return !text.empty() && error.empty(); }
};

/// Measurement by clicks. One atom more than needed starts again.
enum class Measuring { off, distance, angle, torsion };
constexpr const char* kMeasurings[] = {"off", "distance", "angle", "torsion"};

class Picking {
public:
    Picking(Stage& stage, Frames& frames) : stage_(stage), frames_(frames) {}

    // Positions in points
    void tap(glm::dvec2 at, double now);
    /// Call if its first tap picked nothing. @returns the residue to aim at; empty: the whole molecule
    std::optional<Selection> doubleTap(glm::dvec2 at, double now);
    /// Selects the residue there, and requests a menu of actions from the shell.
    void ask(glm::dvec2 at, double now);
    /// Position of a menu requested since the last call; empty: none.
    std::optional<glm::dvec2> takeAsked() { return std::exchange(asked_, std::nullopt); }
    void pointerMoved(glm::dvec2 at, double now) { pointer_ = Pointer{at, now}; }
    /// The pointer left the picture.
    void pointerLeft();

    void measure(Measuring what);
    Measuring measuring() const { return measuring_; }
    /// Maximum of picked atoms: one without measuring.
    std::size_t mostPicks() const { return static_cast<std::size_t>(measuring_) + 1; }

    /// Picked atoms, from 0, in order.
    const std::vector<std::uint32_t>& picks() const { return picks_; }
    /// Selects by text; an empty text clears the selection.
    void select(const std::string& text);
    const SelectedAtoms& selection() const { return selected_; }
    /// Clears the picked atoms.
    void drop() { picks_.clear(); }
    /// Call when the same atoms moved, or the style changed.
    void placeSelection();

    /// @returns when something is due; infinity: never
    double advance(double now);
    Annotations annotations() const;
    /// The wanted view with the current measurement, for pictures.
    PictureDescription measuredView() const;
    /// As above with an absolute camera, for files.
    PictureDescription savedView() const { return stage_.placed(measuredView()); }

private:
    struct Pointer {
        glm::dvec2 at;
        double since;
        bool asked = false;  ///< the atom under it was looked up
    };
    std::vector<bool> markedAtoms(const std::vector<bool>& chosen) const;
    void mark();
    bool hovers() const { return hovered_ > 0 && seen_ == stage_.changes(); }

    std::string measurement(const std::vector<glm::dvec3>& places) const;

    Stage& stage_;
    Frames& frames_;
    Measuring measuring_ = Measuring::off;
    std::vector<std::uint32_t> picks_, picksBefore_;  // atoms, from 0
    SelectedAtoms selected_;
    std::vector<bool> marked_;         // atoms, from 0; empty: none is selected
    std::optional<Pointer> pointer_;   // over the molecule
    std::optional<glm::dvec2> asked_;  // points
    std::uint32_t hovered_ = 0;        // atom, from 1
    std::uint64_t seen_ = 0;           // Stage::changes() at that time
};

}  // namespace nacre::app
