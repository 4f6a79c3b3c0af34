// Saved views, looks, inputs and how they are read.

#include "app/picture/input_names.h"
#include "app/picture/looks.h"
#include "app/picture/rows.h"
#include "app/picture/saved_view.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using T = std::string_view;
using enum Option::Kind;
using enum Option::Save;

std::vector<std::string> lookNames() {
    std::vector<std::string> names;
    for (const Look& look : looks()) names.push_back(look.name);
    return names;
}

void takeThumbnail(T text, P& d) {
    const auto side = static_cast<std::uint32_t>(parseInteger(text, 16, 4096));
    d.size = {side, side};
    d.occlusion.detail = 12;  // so few pixels show no finer detail, and no more directions
    d.occlusion.directions = 64;
    d.aim.principal = d.view.empty();
}

/// Options that set several others go first, so that explicit options override them.
std::string printInputs(const P& d) {
    std::string text = d.input.name + "=" + d.input.path;
    for (const FurtherInput& further : d.input.further) text += "\n" + further.name + "=" + further.path;
    return text;
}

/// Precede the options that override values of a saved view.
std::vector<Option> positional() {
    std::vector<Option> rows{
        {.key = "input",
         .help =
             "A structure file (" + formatTitles() +
             ";\neach also compressed), - for standard input, sample:dna, sample:glucose, sample:buckyball, or a "
             "download:\npdb:1BNA, pubchem:CID|NAME, afdb:UNIPROT. Several form one picture: NAME=INPUT names one "
             "for\nselections, /NAME; without a name the file's name is used. A saved view is drawn as --view draws it",
         .value = {[](T text, P& d) { addInput(d.input, std::string(text)); }, printInputs},
         .kind = list,
         .positional = true},
    };
    return under(Topic::input, Facet::input, std::move(rows));
}

std::vector<Option> severalAtOnce() {
    return {
        {.key = "view",
         .syntax = "FILE",
         .standard = "none",
         .help = "A saved view: camera and all visible settings; options override it. A file of --stats gives the\n"
                 "camera of its picture",
         .topic = Topic::view,
         .value = {[](T text, P& d) { applySavedView(fileName(text), d); }}},
        {.key = "allow-download",
         .help = "Download the molecules that a saved view names; otherwise only the cache is used",
         .topic = Topic::view,
         .facet = Facet::input,
         .value = flagOf<&P::input, &InputOptions::allowDownload>(),
         .kind = flag},
        {.key = "look",
         .syntax = "NAME|FILE",
         .standard = "default",
         .help = "A named look (light, outlines, fog, colours), one of `nacre looks`, or a JSON file of such\n"
                 "options; options override it",
         .topic = Topic::look,
         .value = {[](T text, P& d) { applyLook(readLook(std::string(text)), d); }},
         .choices = lookNames()},
        {.key = "thumbnail",
         .syntax = "N",
         .standard = "none",
         .help = "A picture for lists of structures, N pixels per side, 16 to 4096: --size NxN --orient principal\n"
                 "--occlusion-detail 12 --occlusion 64; options override it, and so does the camera of --view",
         .topic = Topic::thumbnail,
         .value = {takeThumbnail}},
        {.key = "pocket",
         .syntax = "SEL",
         .standard = "none",
         .help = "A ligand in its pocket: it and the residues within 4 Å as sticks, interactions, labels, a faint "
                 "cartoon,\nseen from the open side; options override it",
         .topic = Topic::look,
         .value = {applyPocket}},
        {.key = "interface",
         .syntax = "A,B",
         .standard = "none",
         .help = "The interface of two chains or selections: residues within 4 Å of the other side as sticks,\n"
                 "interactions between them, faint cartoons, seen from the side; options override it",
         .topic = Topic::look,
         .value = {applyInterface}},
    };
}

std::string parseInputName(T text) {
    std::string name(text);
    if (!isInputName(name))
        throw std::invalid_argument("'" + name + "' is not a valid name: use letters, digits, - and _");
    return name;
}

std::string fitText(const FitOptions& fit) { return fit.moving.text + "\t" + fit.fixed.text; }

FitOptions parseFit(T pair) {
    const std::size_t end = pair.find('\n');
    return FitOptions{parseSelection(pair.substr(0, end)), parseSelection(pair.substr(end + 1))};
}

std::vector<Option> named() {
    std::vector<Option> rows{
        {.key = "input", .value = fileOf<&P::input, &InputOptions::path>(), .save = differing},
        {.key = "hash", .value = textOf<&P::input, &InputOptions::hash>(), .save = differing},
        {.key = "name", .value = valueOf<&P::input, &InputOptions::name>(parseInputName), .save = differing},
        {.key = "further-inputs", .value = {{}, printInputs}, .kind = inputs, .save = differing},
        {.key = "conformations",
         .help = "Take the INPUTs after the first for its conformations: models of one molecule, superposed, of which\n"
                 "--model shows one and a movie all",
         .topic = Topic::fit,
         .value = flagOf<&P::input, &InputOptions::conformations>(),
         .kind = flag,
         .save = differing},
        {.key = "fit",
         .syntax = "SEL SEL",
         .standard = "none",
         .help = "Superpose one INPUT on another: the atoms that move, then the atoms they move to,\n"
                 "paired by chain, sequence and name; polymers alone, if both have some; without the outliers beyond\n"
                 "twice the RMSD, which is reported with and without them; repeatable",
         .topic = Topic::fit,
         .value = listOf<&P::input, &InputOptions::fits>(kMostInputs, parseFit, fitText),
         .kind = pair,
         .save = differing,
         .savedAs = "fits"},
        {.key = "align",
         .syntax = "SEL SEL",
         .standard = "none",
         .help = "As --fit, by structure alone (TM-align), for chains whose sequences differ: the longest protein\n"
                 "chain of either selection. Reports the pairs, their RMSD and the TM-score; repeatable",
         .topic = Topic::fit,
         .value = listOf<&P::input, &InputOptions::alignments>(kMostInputs, parseFit, fitText),
         .kind = pair,
         .save = differing,
         .savedAs = "alignments"},
    };
    return under(Topic::input, Facet::input, std::move(rows));
}

std::optional<Format> parseFormatName(T text) {
    if (const std::optional<Format> format = formatFromName(text)) return format;
    refuse(text, "one of " + formatNames(), allFormatNames());
}

/// An address may contain '=': the last one divides.
SceneMap parseSceneMap(T map) {
    const std::size_t end = map.rfind('=');
    if (end == T::npos || end == 0 || end + 1 == map.size())
        throw std::invalid_argument("'" + std::string(map) + "' is no URL=PATH");
    return {std::string(map.substr(0, end)), std::string(map.substr(end + 1))};
}
std::vector<Option> cache() {
    return {{.key = "cache",
             .syntax = "DIR|off",
             .standard = "NACRE_CACHE, else ~/.cache/nacre",
             .help = "Folder for downloads and ambient occlusion",
             .topic = Topic::reading,
             .value = valueOf<&P::input, &InputOptions::cache>(fileName)}};
}

std::vector<Option> reading() {
    std::vector<Option> rows{
        {.key = "offline",
         .help = "Take downloads from the cache only",
         .value = flagOf<&P::input, &InputOptions::offline>(),
         .kind = flag},
        {.key = "memory",
         .syntax = "MB",
         .standard = "half of the machine's",
         .help = "Memory limit for the molecule, 1 to 1048576; a larger one is refused (700 bytes per atom, two per "
                 "byte of text)",
         .value = integerOf<&P::input, &InputOptions::memoryMegabytes>(1, 1 << 20)},
        {.key = "format",
         .syntax = "NAME",
         .standard = "by content",
         .help = "One of " + formatNames(),
         .value = valueOf<&P::input, &InputOptions::format>(parseFormatName, formatName),
         .save = differing},
        {.key = "model",
         .syntax = "N|all",
         .standard = "1",
         .help = "Model, frame or record, counted from 1; all: superimposed",
         .facet = Facet::frame,
         .value = valueOf<&P::input, &InputOptions::model>(
             parseModel, [](int model) { return model == kAllModels ? "all" : std::to_string(model); }),
         .save = always,
         .number = Option::Number::whole},
        {.key = "snapshot",
         .syntax = "N|all",
         .standard = "1",
         .help = "Snapshot of a MolViewSpec scene, counted from 1; all: a picture of each, or a movie of them",
         .value = valueOf<&P::input, &InputOptions::snapshot>(
             [](T text) { return text == "all" ? kAllSnapshots : static_cast<int>(parseInteger(text, 1, 10'000)); },
             [](int snapshot) { return snapshot == kAllSnapshots ? "all" : std::to_string(snapshot); }),
         .save = differing,
         .number = Option::Number::whole},
        {.key = "mvs-map",
         .syntax = "URL=PATH",
         .standard = "none",
         .help = "Reads a local file or folder in place of an address in a MolViewSpec scene, or of all that begin "
                 "with it;\nrepeatable",
         .value = listOf<&P::input, &InputOptions::sceneMaps>(
             kMostInputs, parseSceneMap, [](const SceneMap& map) { return map.url + "=" + map.path; }),
         .kind = list},
        {.key = "add-hydrogens",
         .syntax = "on|off",
         .standard = "=",
         .help = "Add the hydrogens that the file lacks, at neutral pH",
         .value = switchOf<kOnOff, &P::input, &InputOptions::addHydrogens>(),
         .save = differing,
         .bare = "on"},
    };
    return under(Topic::reading, Facet::input, std::move(rows));
}

void parseTrajectory(T text, P& d) {
    d.input.trajectory.path = fileName(text);
    d.input.trajectory.namedBy.clear();
}

std::vector<Option> moving() {
    using Q = TrajectoryOptions;
    std::vector<Option> rows{
        {.key = "trajectory",
         .syntax = "FILE",
         .standard = "none",
         .help = "Positions of INPUT's atoms, frame by frame: DCD, XTC, TRR, AMBER NetCDF, H5MD or any file of\n"
                 "several models",
         .facet = Facet::input,
         .value = {parseTrajectory, [](const P& d) { return d.input.trajectory.path; }},
         .save = differing},
        {.key = "trajectory-hash",
         .facet = Facet::input,
         .value = textOf<&P::input, &InputOptions::trajectory, &Q::hash>(),
         .save = differing},
        {.key = "frame",
         .syntax = "N",
         .standard = "1",
         .help = "Frame of --trajectory, counted from 1",
         .value = valueOf<&P::input, &InputOptions::trajectory, &Q::frame>(parseFrame),
         .save = withTrajectory,
         .number = Option::Number::whole},
        {.key = "whole",
         .help = "Join molecules that the periodic box of --trajectory splits, along their bonds",
         .value = flagOf<&P::input, &InputOptions::trajectory, &Q::whole>(),
         .kind = flag,
         .save = differing},
        {.key = "fit-frames",
         .syntax = "SEL",
         .standard = "none",
         .help = "Superpose each frame of --trajectory (and of a movie's --models) on the first by these atoms: "
                 "backbone, name CA",
         .value = selectionOf<&P::input, &InputOptions::trajectory, &Q::fit>(),
         .save = differing},
        {.key = "smooth",
         .syntax = "N",
         .standard = "1",
         .help = "Average N frames of --trajectory (and of a movie's --models), odd, up to 101",
         .value = valueOf<&P::input, &InputOptions::trajectory, &Q::smooth>(parseSmoothing),
         .save = differing,
         .number = Option::Number::whole},
    };
    return under(Topic::trajectory, Facet::frame, std::move(rows));
}

}  // namespace

std::vector<Option> inputRows() {
    return joined({positional(), severalAtOnce(), named(), cache(), reading(), moving()});
}

}  // namespace nacre::app
