#pragma once
// The words that stand in a picture beside the molecule: labels, measurements, title, scale bar, legend. As options
// ask for them; app/annotation/ places and paints them.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/selection/selection.h"

namespace nacre::app {

/// "SELECTION=TEXT". The text has fields in braces ({residue}{number}); the finest of them says what a label is for:
/// each atom, each residue, each chain; without any, the selection as a whole.
struct Label {
    Selection selection;
    std::string text;
    friend bool operator==(const Label&, const Label&) = default;
};

/// Distance, angle or torsion of two to four selections of one atom each.
struct Measure {
    std::vector<Selection> points;
    std::string text;  ///< as it was written
    friend bool operator==(const Measure&, const Measure&) = default;
};

enum class ScaleBar { off, angstrom, nanometre };

struct Words {
    std::vector<Label> labels;
    std::vector<Measure> measures;
    std::string title;
    ScaleBar scaleBar = ScaleBar::off;
    bool legend = false;
    bool distances = false;                     ///< of interactions that are drawn
    bool seenOnly = false;                      ///< no labels of what lies behind other atoms
    double size = 0;                            ///< pixels of an em; 0: a 42nd of the shorter side
    std::optional<std::array<float, 3>> color;  ///< sRGB-coded; empty: dark or light, against the background

    bool any() const {
        return !labels.empty() || !measures.empty() || !title.empty() || scaleBar != ScaleBar::off || legend ||
               distances;
    }
    friend bool operator==(const Words&, const Words&) = default;
};

/// "SELECTION=TEXT", divided at the first '=' before which a selection stands.
/// @throws std::invalid_argument for a field that there is not, markup that is not closed, no text; Error for the
/// selection
Label parseLabel(std::string_view text);
/// Two to four selections with commas between them; lists in them take '+'. A number alone is that of an atom.
Measure parseMeasure(std::string_view text);
/// "off", "angstrom" or "A" or "Å", "nm".
ScaleBar parseScaleBar(std::string_view text);
const char* scaleBarText(ScaleBar bar);
/// Checks the markup of a title. @throws std::invalid_argument
std::string parseTitle(std::string_view text);
/// An opaque colour as parseColor() takes it. @throws std::invalid_argument
std::array<float, 3> parseInk(std::string_view text);
/// "SELECTION=TEXT" as parseLabel() takes it.
std::string labelText(const Label& label);

constexpr std::size_t kMostLabels = 400, kMostWordOptions = 1000;
constexpr std::size_t kMostPlacedLabels = 10'000;  ///< with those of primitives

/// A piece of a text in one size.
struct TextRun {
    std::string text;  ///< UTF-8
    int level = 0;     ///< 1: raised, -1: lowered, both smaller
    friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// Markup as in TeX: _x and _{xyz} lower, ^x and ^{xyz} raise, \alpha to \Omega and \AA are letters, \ before another
/// sign is that sign. Fields are not known here. @throws std::invalid_argument
std::vector<TextRun> runsOf(std::string_view text);

}  // namespace nacre::app
