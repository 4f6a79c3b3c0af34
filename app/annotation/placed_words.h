#pragma once
// Words of a molecule and its scene. layout.h places them in a picture.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/label_sight.h"
#include "app/picture/words.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/build/primitives.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// A text with its position: Å from the scene's centre.
struct PlacedLabel {
    glm::dvec3 at{};
    std::string text;                ///< with markup
    bool ofAtom = false;             ///< placed beside an atom, not on top
    double radius = 0;               ///< of that atom, Å
    LabelSight::Named named{};       ///< its atoms, and those that do not hide it, if labels may be hidden
    double size = 0;                 ///< Å per em: has a size in space, and covers what lies there; 0: as all labels
    std::uint32_t color = 0;         ///< packed; 0: as all labels
    Primitives::LabelPlate plate{};  ///< of a label with a size in space
    /// From its anchor to its centre, em, to the right and up; empty: where it fits.
    std::optional<glm::dvec2> offset{};
};
struct PlacedMeasure {
    std::vector<glm::dvec3> points;
    std::string text;
    std::string of = {};     ///< Measure::text
    std::string atoms = {};  ///< by name: "HIS 87 NE2 to HEM 142 FE"
};

/// An arrow of the axes cross.
struct PlacedAxis {
    glm::dvec3 way{};  ///< a unit vector in the scene
    std::string name;
    std::uint32_t color = 0;  ///< packed
};
/// The x, y and z axes, or those of the unit cell: a, b and c.
std::vector<PlacedAxis> makeAxes(const std::optional<std::array<glm::dvec3, 3>>& cell);
/// Packed colours of x, y, z and of a, b, c.
constexpr std::uint32_t kAxisColors[] = {packedColor(0xc8322d), packedColor(0x2d8a3c), packedColor(0x2f5fc4)};

/// The words of a scene.
struct PlacedWords {
    std::vector<PlacedLabel> labels;
    std::vector<PlacedMeasure> measures;
    std::string title;
    ScaleBar scaleBar = ScaleBar::off;
    std::vector<Legend> legends;
    std::vector<PlacedAxis> axes;             ///< empty: no cross
    std::shared_ptr<const LabelSight> sight;  ///< null: labels are never hidden
    std::vector<std::string> leftOut;         ///< selections of labels and measurements without drawn atoms

    bool any() const { return !labels.empty() || !measures.empty() || hasBlocks(); }
    /// Title, scale bar, legends or axes.
    bool hasBlocks() const { return !title.empty() || scaleBar != ScaleBar::off || !legends.empty() || !axes.empty(); }
};

/// Treatment of words about atoms that exist but are not drawn.
enum class WordsOfHidden { refused, leftOut };

/// In an assembly, words belong to the first copy. @throws Error if a label's selection has no drawn atom, a
/// measurement's selection has not exactly one, or there are too many labels
PlacedWords placeWords(const Words& words, const ResidueFacts& facts, const Representation& scene,
                       WordsOfHidden hidden = WordsOfHidden::refused);

/// Adds labels at points. @param center  of the scene, Å in the file's frame
void addLabels(const std::vector<Primitives::Label>& labels, const glm::dvec3& center, PlacedWords& words);

}  // namespace nacre::app
