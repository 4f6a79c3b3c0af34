// The words in the picture.

#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using T = std::string_view;
using enum Option::Kind;
using enum Option::Save;

inline constexpr Words2 kDistanceOff = {"distance", "off"};
inline constexpr std::array<const char*, 2> kAllSeen{"all", "seen"};

void parseTextSize(T text, P& d) {
    d.words.size = parsePixels(text, 4, 2000);
    d.textPoints = parsePoints(text);
}

}  // namespace

std::vector<Option> wordRows() {
    std::vector<Option> rows{
        {.key = "label",
         .syntax = "SEL=TEXT",
         .help =
             "Label a selection. Fields of TEXT, {residue}, {number}, {letter}, {chain}, {atom}, {element}, ..., give\n"
             "one label per residue, chain or atom; _ lowers, ^ raises, \\alpha is a letter; repeatable",
         .value = listOf<&P::words, &Words::labels>(kMostWordOptions, parseLabel, labelText),
         .kind = list,
         .save = differing,
         .savedAs = "labels"},
        {.key = "label-color",
         .syntax = "SEL=COLOR",
         .help = "Colour of the labels of a selection's atoms; the last rule wins; repeatable",
         .value = listOf<&P::words, &Words::labelColors>(
             kMostWordOptions, parseLabelColor,
             [](const LabelColor& rule) { return rule.selection.text + "=" + opaqueText(rule.color); }),
         .kind = list,
         .save = differing,
         .needs = "label"},
        {.key = "label-offset",
         .syntax = "SEL=X,Y",
         .help =
             "Fixed place of the labels of a selection's atoms: ems to the right of the atoms' middle, and above it;\n"
             "repeatable",
         .value = listOf<&P::words, &Words::labelOffsets>(kMostWordOptions, parseLabelOffset,
                                                          [](const LabelOffset& rule) {
                                                              return rule.selection.text + "=" + exactText(rule.right) +
                                                                     "," + exactText(rule.up);
                                                          }),
         .kind = list,
         .save = differing,
         .needs = "label"},
        {.key = "measure",
         .syntax = "A,B[,C[,D]]",
         .help = "Distance, angle or torsion of atoms, each a selection or an atom's number; repeatable",
         .value = listOf<&P::words, &Words::measures>(kMostWordOptions, parseMeasure,
                                                      [](const Measure& m) { return m.text; }),
         .kind = list,
         .save = differing,
         .savedAs = "measures"},
        {.key = "title",
         .syntax = "TEXT",
         .standard = "none",
         .help =
             "Above the molecule, with the markup of labels; {frame} is the number of the frame or model, {time} its\n"
             "time in the trajectory",
         .value = valueOf<&P::words, &Words::title>(parseTitle),
         .save = differing,
         .control = {"Title"}},
        {.key = "scale-bar",
         .syntax = "angstrom|nm|off",
         .standard = "=",
         .help = "A scale bar at the lower right; in perspective, for the plane of the molecule's centre",
         .value = valueOf<&P::words, &Words::scaleBar>(parseScaleBar, scaleBarText),
         .save = differing,
         .control = {.label = "Scale bar",
                     .choices = {{"None", "off"}, {"In ångström", "angstrom"}, {"In nanometres", "nm"}}}},
        {.key = "legend",
         .syntax = "on|off",
         .standard = "=",
         .help = "Colour legend at the upper right",
         .value = switchOf<kOnOff, &P::words, &Words::legend>(),
         .save = differing,
         .bare = "on",
         .control = {.label = "Colour legend", .choices = {{"off", "off"}, {"on", "on"}}}},
        {.key = "legend-title",
         .syntax = "TEXT",
         .standard = "by the scheme",
         .help = "Heading of the legend's first scale, else of its first part, with the markup of labels",
         .value = valueOf<&P::words, &Words::legendTitle>(parseTitle),
         .save = differing,
         .needs = "legend"},
        {.key = "axes",
         .syntax = "on|off",
         .standard = "=",
         .help = "The x, y and z axes at the lower left in red, green and blue; with --cell the cell's a, b and c",
         .value = switchOf<kOnOff, &P::words, &Words::axes>(),
         .save = differing,
         .bare = "on",
         .control = {.label = "Axes", .choices = {{"off", "off"}, {"on", "on"}}}},
        {.key = "interaction-labels",
         .syntax = "distance|off",
         .standard = "=",
         .help = "Distances of the drawn interactions, in Å",
         .value = switchOf<kDistanceOff, &P::words, &Words::distances>(),
         .save = differing,
         .needs = "interactions",
         .bare = "distance"},
        {.key = "show-labels",
         .syntax = "all|seen",
         .standard = "=",
         .help = "seen: no labels of atoms hidden by other residues (less than a quarter of their near side visible)",
         .value = choiceOf<kAllSeen, &P::words, &Words::seenOnly>(),
         .save = differing,
         .control = {.label = "Show hidden labels", .choices = {{"off", "seen"}, {"on", "all"}}}},
        {.key = "text-size",
         .syntax = "PIXELS|POINTSpt",
         .standard = "1/42 of the shorter side",
         .help = "Size of letters (an em), 4 to 2000 pixels, or as 8pt at --dpi",
         .value = {parseTextSize, [](const P& d) { return d.words.size > 0 ? exactText(d.words.size) : ""; }},
         .save = differing,
         .number = Option::Number::real},
        {.key = "text-color",
         .syntax = "COLOR",
         .standard = "dark or light, in contrast to the background",
         .help = "An opaque colour as for --background; a halo keeps it readable on atoms",
         .value = valueOf<&P::words, &Words::color>(parseInk, opaqueText),
         .save = differing},
    };
    return under(Topic::words, Facet::annotation, std::move(rows));
}

}  // namespace nacre::app
