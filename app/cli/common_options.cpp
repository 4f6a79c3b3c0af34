#include "app/cli/common_options.h"

#include "app/picture/appearance_values.h"
#include "app/picture/input_names.h"
#include "app/picture/mesh_options.h"
#include "app/picture/option_values.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::size_t kMostRules = 1000;
constexpr std::int64_t kMostOcclusionMegabytes = 65536;

void showHide(CommandSpec& command, const std::string& name, bool& target, const std::string& help) {
    addValue(command, name, "show|hide", target ? "show" : "hide", help, [&](const std::string& text) {
        target = parseChoice(text, {"show", "hide"}) == 0;
    });
}

/// An option that may be given many times; the common order of all of them is kept.
void rule(CommandSpec& command, const std::string& name, const std::string& type, const std::string& help,
          std::vector<Rule>& rules, Rule (*parse)(std::string_view)) {
    addValue(command, name, type, "", help, [&rules, parse](const std::string& text) {
        if (rules.size() == kMostRules)
            throw std::invalid_argument("more than " + std::to_string(kMostRules) + " rules");
        rules.push_back(parse(text));
    }).repeatable = true;
}

void addRules(CommandSpec& command, std::vector<Rule>& rules) {
    rule(command, "--show", "SEL=STYLE", "Draw the atoms of a selection in a style; repeatable", rules, parseShow);
    rule(command, "--hide", "SEL", "Leave out the atoms of a selection; repeatable", rules, parseHide);
    rule(command, "--color-by", "SEL=SCHEME|COLOR",
         "Colour the atoms of a selection; repeatable. These three apply in the order they stand in", rules,
         parseColorBy);
}

}  // namespace

OptionSpec& addValue(CommandSpec& command, const std::string& name, const std::string& type,
                     const std::string& fallback, const std::string& help,
                     std::function<void(const std::string&)> set) {
    return command.add({name, type, fallback, help, std::move(set)});
}

void addFlag(CommandSpec& command, const std::string& name, bool& target, const std::string& help) {
    command.add({name, "", "", help, [&target](const std::string&) { target = true; }});
}

void addOnOff(CommandSpec& command, const std::string& name, bool& target, const std::string& help) {
    addValue(command, name, "on|off", "on", help, [&](const std::string& text) {
        target = parseChoice(text, {"on", "off"}) == 0;
    });
}

std::string fileName(const std::string& text) {
    if (text.empty()) throw std::invalid_argument("expected a file name");
    return text;
}

namespace {

std::string inputHelp() {
    return "A structure file (" + formatTitles() +
           ";\neach also .gz), - for standard input, sample:dna, sample:glucose, sample:buckyball, or a download:\n"
           "pdb:1BNA, pubchem:CID|NAME, afdb:UNIPROT.";
}

void addReading(CommandSpec& command, InputOptions& input) {
    addValue(command, "--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre",
             "Where downloads and occlusion are kept", [&](const std::string& text) { input.cache = fileName(text); });
    addFlag(command, "--offline", input.offline, "Take downloads from the cache alone");
    addValue(command, "--memory", "MB", "half of the machine's",
             "For the molecule, 1 to 1048576; one that takes more (700 bytes an atom, two a byte of text) is refused",
             [&](const std::string& text) { input.memoryMegabytes = parseInteger(text, 1, 1 << 20); });
    addValue(command, "--format", "NAME", "by content", "One of " + formatNames(), [&](const std::string& text) {
        input.format = formatFromName(text);
        if (!input.format) throw std::invalid_argument("expected one of " + formatNames() + ", not '" + text + "'");
    });
    addValue(command, "--model", "N|all", "1", "Model, frame or record, counted from 1; all: one over the other",
             [&](const std::string& text) { input.model = parseModel(text); });
}

}  // namespace

void addTrajectory(CommandSpec& command, TrajectoryOptions& trajectory) {
    addValue(command, "--trajectory", "FILE", "none",
             "Where INPUT's atoms are, frame by frame: DCD, XTC, TRR or AMBER NetCDF",
             [&](const std::string& text) { trajectory.path = fileName(text); });
    addValue(command, "--frame", "N", "1", "Of --trajectory, counted from 1",
             [&](const std::string& text) { trajectory.frame = parseFrame(text); });
    addFlag(command, "--whole", trajectory.whole,
            "Put together molecules that the periodic box of --trajectory cut, along their bonds");
    addValue(
        command, "--fit-frames", "SEL", "none",
        "Lay each frame of --trajectory (a movie's --models, too) onto the first by these atoms: backbone, name CA",
        [&](const std::string& text) { trajectory.fit = parseSelection(text); });
    addValue(command, "--smooth", "N", "1", "Mean of N frames of --trajectory (a movie's --models, too), odd, to 101",
             [&](const std::string& text) { trajectory.smooth = parseSmoothing(text); });
}

void addInput(CommandSpec& command, InputOptions& input, bool required) {
    OptionSpec& option =
        command.add({"INPUT", "", "",
                     inputHelp() + " Several are one picture: NAME=INPUT names one for\nselections, /NAME; else its "
                                   "file's name does",
                     [&](const std::string& text) { addInput(input, text); }});
    option.required = required;
    option.repeatable = true;
    addReading(command, input);
}

void addInputs(CommandSpec& command, std::vector<std::string>& paths, InputOptions& input) {
    OptionSpec& option = command.add({"INPUT", "", "", inputHelp() + " Several are taken one after the other",
                                      [&](const std::string& text) { paths.push_back(text); }});
    option.required = option.repeatable = true;
    addReading(command, input);
}

void addSize(CommandSpec& command, const std::string& fallback, Size& size) {
    addValue(command, "--size", "WxH", fallback, "Pixels, each side 1 to 32768",
             [&](const std::string& text) { size = parseSize(text); });
}

OptionSpec& addDeviceName(CommandSpec& command, DeviceOptions& device) {
    return addValue(command, "--device", "N|NAME", "the best there is",
                    "Number or part of the name, as `nacre devices` lists them", [&](const std::string& text) {
                        if (text.empty()) throw std::invalid_argument("expected a device's number or part of its name");
                        device.device = text;
                    });
}

void addCameraValues(CommandSpec& command, Camera& camera, const char* rotateHelp) {
    addValue(command, "--rotate", "X,Y,Z", "0,0,0", rotateHelp,
             [&](const std::string& text) { camera.rotationDegrees = parseRotation(text); });
    addValue(command, "--zoom", "F", "1", "Scales the picture, 0.0001 to 10000",
             [&](const std::string& text) { camera.zoom = parseNumber(text, kSmallestZoom, kLargestZoom); });
    addValue(command, "--projection", "NAME", "ortho", "ortho or perspective", [&](const std::string& text) {
        camera.projection =
            parseChoice(text, {"ortho", "perspective"}) == 0 ? Projection::orthographic : Projection::perspective;
    });
    addValue(command, "--fov", "DEGREES", "30", "Perspective: angle across the shorter side, 1 to 120",
             [&](const std::string& text) { camera.fovDegrees = parseNumber(text, kSmallestFov, kLargestFov); });
}

void addSupersample(CommandSpec& command, const std::string& fallback, std::uint32_t& supersample) {
    addValue(command, "--supersample", "auto|N", fallback,
             "N x N samples a pixel, 1 to 8; auto: 16 where a pixel shows an edge, one elsewhere",
             [&](const std::string& text) { supersample = parseSupersample(text); });
}

void addMeshError(CommandSpec& command, const std::string& fallback, double& share) {
    addValue(command, "--mesh-error", "SHARE", fallback,
             "How far outlines of cartoons and surfaces may be off, of the distance between samples (of auto's edges a "
             "quarter of a pixel), 0 to 4: where they are small, fewer triangles do; 0: all of them",
             [&](const std::string& text) { share = parseNumber(text, 0, kLargestMeshError); });
}

void addContent(CommandSpec& command, InputOptions& input, bool required, DrawnAtomsOptions& drawn,
                RepresentationOptions& look) {
    addInput(command, input, required);
    addTrajectory(command, input.trajectory);
    addValue(command, "--fit", "SEL SEL", "none",
             "Lay one INPUT onto another: atoms of the one that moves, then those they go to,\n"
             "paired by sequence and name; says the RMSD; repeatable",
             [&](const std::string& text) {
                 const std::size_t end = text.find('\n');
                 input.fits.push_back({parseSelection(text.substr(0, end)), parseSelection(text.substr(end + 1))});
             })
        .pair = true;
    addAppearance(command, drawn, look);
}

void addAppearance(CommandSpec& command, DrawnAtomsOptions& drawn, RepresentationOptions& look) {
    addValue(command, "--style", "NAME", "spacefill; ball-and-stick under 100 atoms with bonds",
             "spacefill, ball-and-stick, licorice, cartoon (with ligands as licorice) or surface",
             [&](const std::string& text) { setStyle(parseStyle(text), look); });
    addValue(command, "--color", "SCHEME|COLOR", "element; chain-carbons of cartoons",
             "element, chain, chain-carbons (the rest by element), copy, copy-chain, copy-entity (of an assembly, the\n"
             "latter two in tones of its colour), entity, residue, hydrophobicity, charge, secondary-structure,\n"
             "b-factor, plddt (AlphaFold's bands), rainbow (N to C), occupancy; or a colour as for --background; "
             "element:COLOR colours the carbons alone;\n"
             "b-factor:10..60:viridis gives the ends of the colours and their palette, chain:muted a palette",
             [&](const std::string& text) { look.color = parseColoring(text); });
    addValue(
        command, "--palette", "NAME", "by the scheme",
        "Colours of kinds (chains, copies, entities): " + paletteNames(false) + ";\nof numbers: " + paletteNames(true),
        [&](const std::string& text) { look.palette = parsePalette(text); });
    addValue(command, "--assembly", "ID", "none: the file's atoms as they are",
             "Biological assembly or unit cell, of those that `nacre info` lists", [&](const std::string& text) {
                 if (text.empty()) throw std::invalid_argument("expected an assembly's identifier");
                 look.assembly = text;
             });
    addRules(command, look.rules);
    addValue(command, "--camera", "all|model", "all",
             "Of a file with several models: one camera for all of them, or each model's own",
             [&](const std::string& text) {
                 look.ownFrame = parseChoice(text, {"all", "model"}) == 1;
             });
    addValue(command, "--occlusion-models", "own|all", "own",
             "Of models drawn together: what darkens an atom, its own model or all of them",
             [&](const std::string& text) {
                 look.modelsOcclude = parseChoice(text, {"own", "all"}) == 1;
             });
    for (const MeshOption& option : meshOptions())
        addValue(command, std::string("--") + option.name, option.type, option.fallback, option.help,
                 [&look, &option](const std::string& text) { option.set(text, look); });
    showHide(command, "--water", drawn.water, "Water molecules");
    showHide(command, "--hydrogens", drawn.hydrogens, "Hydrogen atoms");
}

void addOcclusion(CommandSpec& command, OcclusionOptions& occlusion) {
    addValue(command, "--occlusion", "K|off", "128", "Ambient occlusion from K directions, 1 to 4096",
             [&](const std::string& text) { occlusion.directions = parseOcclusion(text); });
    addValue(
        command, "--occlusion-memory", "MB", "64",
        "Device memory for it, 1 to 65536; the more, the finer (says on standard error what was chosen). 64 grows with "
        "meshes of more than a million vertices",
        [&](const std::string& text) { occlusion.megabytes = parseInteger(text, 1, kMostOcclusionMegabytes); });
}

void addVisibility(CommandSpec& command, DeviceOptions& device) {
    addValue(command, "--visibility", "PATH", "auto", "auto, encoded, fragdepth, deferred, raster-order or tiles",
             [&](const std::string& text) {
                 constexpr Visibility kPaths[] = {Visibility::automatic, Visibility::encoded,     Visibility::fragdepth,
                                                  Visibility::deferred,  Visibility::rasterOrder, Visibility::tiles};
                 device.visibility =
                     kPaths[parseChoice(text, {"auto", "encoded", "fragdepth", "deferred", "raster-order", "tiles"})];
             });
    addValue(
        command, "--encoded-format", "FORMAT", "auto",
        "Of encoded depth: auto, r32f, rgba16f, rg16f, a2b10g10r10 or rgba8", [&](const std::string& text) {
            constexpr EncodedDepth kRungs[] = {EncodedDepth::automatic,   EncodedDepth::r32f,
                                               EncodedDepth::rgba16f,     EncodedDepth::rg16f,
                                               EncodedDepth::a2b10g10r10, EncodedDepth::rgba8};
            device.encoded = kRungs[parseChoice(text, {"auto", "r32f", "rgba16f", "rg16f", "a2b10g10r10", "rgba8"})];
        });
}

}  // namespace nacre::app
