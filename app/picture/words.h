#pragma once
// Words in a picture, as options: labels, measurements, title, scale bar, legend. app/annotation/ places and paints
// them.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/selection/selection.h"

namespace nacre::app {

/// "SELECTION=TEXT". The text has fields in braces ({residue}{number}); the finest field decides the unit of a label:
/// each atom, each residue or each chain; without fields, the whole selection.
struct Label {
    Selection selection;
    std::string text;
    friend bool operator==(const Label&, const Label&) = default;
};

/// Colour of the labels of a selection's atoms; the last rule wins.
struct LabelColor {
    Selection selection;
    std::array<float, 3> color{};  ///< sRGB-coded
    friend bool operator==(const LabelColor&, const LabelColor&) = default;
};

/// Position of the labels of a selection's atoms: from their usual anchor, in em, to the right and up.
struct LabelOffset {
    Selection selection;
    double right = 0, up = 0;
    friend bool operator==(const LabelOffset&, const LabelOffset&) = default;
};

/// Distance, angle or torsion of two to four selections of one atom each.
struct Measure {
    std::vector<Selection> points;
    std::string text;  ///< as written
    friend bool operator==(const Measure&, const Measure&) = default;
};

enum class ScaleBar { off, angstrom, nanometre };

struct Words {
    std::vector<Label> labels;
    std::vector<LabelColor> labelColors;
    std::vector<LabelOffset> labelOffsets;
    std::vector<Measure> measures;
    std::string title;
    ScaleBar scaleBar = ScaleBar::off;
    bool legend = false;
    bool axes = false;                          ///< a cross of x, y, z; of a, b, c with the unit cell
    std::string legendTitle;                    ///< of the first scale, else of the first legend
    bool distances = false;                     ///< values of drawn interactions
    bool seenOnly = false;                      ///< hide labels behind other atoms
    double size = 0;                            ///< em size, pixels; 0: 1/42 of the shorter side
    std::optional<std::array<float, 3>> color;  ///< sRGB-coded; empty: dark or light, in contrast to the background

    bool any() const {
        return !labels.empty() || !measures.empty() || !title.empty() || scaleBar != ScaleBar::off || legend || axes ||
               distances;
    }
    friend bool operator==(const Words&, const Words&) = default;
};

/// "SELECTION=TEXT", split at the first '=' after a valid selection.
/// @throws std::invalid_argument for an unknown field, unclosed markup or empty text; Error for the selection
Label parseLabel(std::string_view text);
/// "SELECTION=COLOR" and "SELECTION=X,Y", split at the last '='. @throws std::invalid_argument, Error for the selection
LabelColor parseLabelColor(std::string_view text);
LabelOffset parseLabelOffset(std::string_view text);
/// Two to four selections separated by commas; lists inside use '+'. A plain number is an atom's.
Measure parseMeasure(std::string_view text);
/// "off", "angstrom" or "A" or "Å", "nm".
ScaleBar parseScaleBar(std::string_view text);
const char* scaleBarText(ScaleBar bar);
/// Checks the markup of a title. @throws std::invalid_argument
std::string parseTitle(std::string_view text);
/// Number and time of a frame or model, for titles.
struct Moment {
    std::int64_t frame = 1;               ///< counted from 1
    std::optional<double> picoseconds{};  ///< empty: the file states no time
};
/// A title with its fields {frame} and {time} filled in: "12", "3.5 ns".
std::string filledTitle(const std::string& title, const Moment& moment);
/// Whether a title has such a field.
bool titleMoves(const std::string& title);
/// An opaque colour as for parseColor(). @throws std::invalid_argument
std::array<float, 3> parseInk(std::string_view text);
/// "SELECTION=TEXT" for parseLabel().
std::string labelText(const Label& label);

constexpr std::size_t kMostLabels = 400, kMostWordOptions = 1000;
constexpr std::size_t kMostPlacedLabels = 10'000;  ///< with those of primitives

/// A piece of a text in one size.
struct TextRun {
    std::string text;  ///< UTF-8
    int level = 0;     ///< 1: raised, -1: lowered, both smaller
    friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// Markup as in TeX: _x and _{xyz} lower, ^x and ^{xyz} raise, \alpha to \Omega and \AA are letters, \ before any other
/// character gives that character. Fields are not resolved here. @throws std::invalid_argument
std::vector<TextRun> parseMarkup(std::string_view text);

}  // namespace nacre::app
