#include "app/cli/picture_options.h"

#include <algorithm>

#include "app/cli/common_options.h"
#include "app/cli/movie_options.h"
#include "app/cli/paper_options.h"
#include "app/cli/saved_options.h"
#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "app/input/input_files.h"
#include "app/movie/movie_file.h"
#include "app/picture/appearance_values.h"
#include "app/picture/effect_options.h"
#include "app/picture/looks.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

void addCamera(CommandSpec& command, RenderOptions& options) {
    addValue(command, "--orient", "principal|file", "file, or that of the saved view",
             "principal: the longest axis across the longer side, the shortest towards the viewer,\nas large as fits; "
             "file: as "
             "the coordinates stand. --rotate turns it further",
             [&](const std::string& text) {
                 options.aim.principal = parseChoice(text, {"principal", "file"}) == 0;
                 if (!options.aim.principal) options.camera.orientation = glm::dquat(1, 0, 0, 0);
             });
    addValue(command, "--look-at", "SEL", "none", "Turn to the viewer the side from which a selection is hidden least",
             [&](const std::string& text) { options.aim.lookAt = parseSelection(text); });
    addValue(command, "--zoom-to", "SEL", "none: the whole molecule",
             "Close in on a selection, with 3 Å around it, and leave out what hides it (unless --clip or\n--uncover is "
             "given); --zoom scales that",
             [&](const std::string& text) { options.aim.zoomTo = parseSelection(text); });
    addValue(command, "--uncover", "SEL|off", "what --zoom-to names", "Leave out what hides a selection in this view",
             [&](const std::string& text) {
                 options.aim.uncovers = false;
                 options.aim.uncover = text == "off" ? std::nullopt : std::optional(parseSelection(text));
             });
    addCameraValues(command, options.camera, "Degrees, right-handed, about the view axes, X first");
}

void addShading(CommandSpec& command, RenderOptions& options) {
    addOcclusion(command, options.occlusion);
    addValue(command, "--background", "COLOR", "white",
             "transparent, a colour's name as CSS has it (navy, lightgray), #rgb, #rrggbb or #rrggbbaa\n(JPEG has no "
             "transparency: over white)",
             [&](const std::string& text) { options.background = parseColor(text); });
    command
        .add({"--transparent", "", "", "The same as --background transparent",
              [&](const std::string&) { options.background = parseColor("transparent"); }})
        .excludes = "--background";
    addOnOff(command, "--lighting", options.lighting, "off: base colour times occlusion, nothing else");
    addEffects(command, options);
}

void addPixels(CommandSpec& command, RenderOptions& options) {
    addValue(
        command, "--occlusion-detail", "N", "32",
        "Texels of occlusion across an atom's patch, at most, 4 to 32; 12 do for thumbnails, in a quarter of the time",
        [&](const std::string& text) {
            options.occlusion.detail = static_cast<std::uint32_t>(parseInteger(text, 4, 32));
        });
    addSize(command, "1024x1024", options.size);
    addSupersample(command, "auto", options.supersample);
    addMeshError(command, "0.25", options.meshError);
}

std::vector<std::string> lookNames() {
    std::vector<std::string> names;
    for (const Look& look : looks()) names.push_back(look.name);
    return names;
}

/// Goes before the options that it stands for, so that those prevail.
void addThumbnail(CommandSpec& command, RenderOptions& options) {
    addValue(command, "--thumbnail", "N", "none",
             "A picture for lists of structures, N pixels a side, 16 to 4096: --size NxN --orient principal\n"
             "--occlusion-detail 12; options prevail, and so does where a --view looks from",
             [&](const std::string& text) {
                 const auto side = static_cast<std::uint32_t>(parseInteger(text, 16, 4096));
                 options.size = {side, side};
                 options.occlusion.detail = 12;
                 options.aim.principal = options.view.empty();
             });
}

void addWords(CommandSpec& command, RenderOptions& options) {
    Words& words = options.words;
    addValue(
        command, "--label", "SEL=TEXT", "",
        "Label a selection; {residue}, {number}, {letter}, {chain}, {atom}, {element}, ... in the text, one label\n"
        "for each of what they name; _ lowers, ^ raises, \\alpha is a letter; repeatable",
        [&](const std::string& text) {
            if (words.labels.size() == kMostWordOptions) throw std::invalid_argument("more than 1000 of them");
            words.labels.push_back(parseLabel(text));
        })
        .repeatable = true;
    addValue(command, "--show-labels", "all|seen", "all",
             "seen: none of what lies behind other residues (less than a quarter of its near side shows)",
             [&](const std::string& text) {
                 words.seenOnly = parseChoice(text, {"all", "seen"}) == 1;
             });
    addValue(command, "--measure", "A,B[,C[,D]]", "",
             "Distance, angle or torsion of atoms, each a selection or an atom's number; repeatable",
             [&](const std::string& text) {
                 if (words.measures.size() == kMostWordOptions) throw std::invalid_argument("more than 1000 of them");
                 words.measures.push_back(parseMeasure(text));
             })
        .repeatable = true;
    addValue(command, "--title", "TEXT", "none", "Above the molecule; marked up as a label's text is",
             [&](const std::string& text) { words.title = parseTitle(text); });
    addValue(command, "--scale-bar", "angstrom|nm|off", "off",
             "A length at the lower right; in perspective, on the plane of the molecule's centre",
             [&](const std::string& text) { words.scaleBar = parseScaleBar(text); });
    addValue(command, "--legend", "on|off", "off", "What the colours mean, at the upper right",
             [&](const std::string& text) {
                 words.legend = parseChoice(text, {"on", "off"}) == 0;
             })
        .bare = "on";
    addValue(command, "--text-size", "PIXELS|POINTSpt", "a 42nd of the shorter side",
             "Size of letters (an em), 4 to 2000 pixels, or as 8pt at --dpi", [&](const std::string& text) {
                 words.size = parsePixels(text, 4, 2000);
                 options.textPoints = pointsOf(text);
             });
    addValue(command, "--text-color", "COLOR", "dark or light, against the background",
             "An opaque colour as for --background; a halo keeps it readable on atoms",
             [&](const std::string& text) { words.color = parseInk(text); });
}

/// Goes before the options that it stands for, so that those prevail.
void addSavedView(CommandSpec& command, RenderOptions& options) {
    addValue(command, "--view", "FILE", "none",
             "A view that `nacre view` saved: what is seen, and how; options prevail", [&](const std::string& text) {
                 options.view = fileName(text);
                 applySavedView(readSavedView(text), options);
             });
    addFlag(command, "--allow-download", options.input.allowDownload,
            "Download what a saved view names; otherwise it is taken from the cache alone");
}

OptionSpec& addOutput(CommandSpec& command, RenderOptions& options) {
    return addValue(
        command, "-o,--output", "FILE", "",
        "The picture: .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr; - is PNG to standard output",
        [&](const std::string& text) {
            if (!isPictureName(text))
                throw std::invalid_argument(
                    "expected a name that ends in .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr, not '" + text + "'");
            options.output = text;
        });
}

void addFiles(CommandSpec& command, RenderOptions& options) {
    addOutput(command, options).required = true;
    addValue(command, "--layers", "FILE.exr", "none",
             "Colour, depth, normal, atom and occlusion of every pixel; - for standard output",
             [&](const std::string& text) {
                 if (!isStandardOutput(text) && extensionOf(text) != ".exr")
                     throw std::invalid_argument("expected a name that ends in .exr, not '" + text + "'");
                 options.layers = text;
             });
    addValue(command, "--stats", "FILE.json", "none", "View, counts, times and memory as JSON; - for standard output",
             [&](const std::string& text) { options.stats = fileName(text); });
    addValue(command, "--capture", "FILE.rdc", "none",
             "The frame and its occlusion bake, for RenderDoc, which has to be installed and listens on this machine "
             "alone;\n- for standard output",
             [&](const std::string& text) {
                 if (!isStandardOutput(text) && extensionOf(text) != ".rdc")
                     throw std::invalid_argument("expected a name that ends in .rdc, not '" + text + "'");
                 options.capture = text;
                 options.device.capture = true;
             });
}

void addDebug(CommandSpec& command, RenderOptions& options) {
    std::string names;
    for (const char* name : debugViewNames()) names += names.empty() ? name : std::string(", ") + name;
    addValue(
        command, "--debug", "VIEW", "none", "What the frame works with, as the picture: " + names,
        [&](const std::string& text) { options.debug = static_cast<DebugView>(parseChoice(text, debugViewNames())); });
}

void addDevice(CommandSpec& command, RenderOptions& options) {
    addDeviceName(command, options.device);
    addVisibility(command, options.device);
    addValue(
        command, "--prepass", "on|off", "on", "Opaque plates that reject hidden work; never changes the picture",
        [&](const std::string& text) {
            options.tuning.plates = parseChoice(text, {"on", "off"}) == 0 ? PlateShape::automatic : PlateShape::none;
        });
    addOnOff(command, "--transient", options.tuning.transient,
             "off: every attachment has memory and is stored; never changes the picture");
    addOnOff(command, "--merge", options.tuning.merge,
             "Passes as subpasses of one render pass; never changes the picture");
    addFlag(command, "--validate", options.device.validate,
            "Run under the Vulkan validation layer; any message is an error");
}

}  // namespace

void addLook(CommandSpec& command, RenderOptions& options) {
    addValue(command, "--look", "NAME|FILE", "default",
             "Light, lines, fog and colours that go together, as `nacre looks` lists them, or a JSON file of\nsuch "
             "options; options prevail",
             [&](const std::string& text) { takeLook(lookOf(text), options); })
        .choices = lookNames();
}

void addEffects(CommandSpec& command, RenderOptions& options) {
    for (const EffectOption& option : effectOptions())
        addValue(command, std::string("--") + option.name, option.type, option.fallback, option.help,
                 [&](const std::string& text) {
                     option.set(text, options.effects);
                     options.givenEffects.insert(option.name);
                     if (option.name == std::string_view("clip")) options.aim.uncovers = false;
                     if (option.name == std::string_view("contours")) options.contourPoints = pointsOf(text);
                     if (option.name == std::string_view("halos")) options.haloPoints = pointsOf(text);
                 });
    addValue(command, "--slab", "A", "none", "Cuts away what is farther than half of this from the plane of the centre",
             [&](const std::string& text) {
                 setSlab(text, options.effects);
                 options.aim.uncovers = false;
             })
        .excludes = "--clip";
}

void addRender(CommandSpec& command, RenderOptions& options) {
    addSavedView(command, options);
    addLook(command, options);
    addThumbnail(command, options);
    addContent(command, options.input, false, options.drawn, options.look);
    addFiles(command, options);
    addCamera(command, options);
    addShading(command, options);
    addWords(command, options);
    addPixels(command, options);
    addPaper(command, options);
    addDebug(command, options);
    addDevice(command, options);
}

void addMoviePicture(CommandSpec& command, RenderOptions& options) {
    addSavedView(command, options);
    addLook(command, options);
    addContent(command, options.input, false, options.drawn, options.look);
    addCamera(command, options);
    addShading(command, options);
    addWords(command, options);
    addPixels(command, options);
    addDevice(command, options);
}

void addMovie(CommandSpec& command, MovieOptions& options) {
    RenderOptions& picture = options.picture;
    addValue(command, "-o,--output", "FILE|FOLDER/", "",
             "The movie: .mp4, .webm (both by ffmpeg), .gif, .png (animated); or a folder of PNG frames;\n"
             "- is an animated PNG to standard output",
             [&](const std::string& text) {
                 if (!isMovieName(text))
                     throw std::invalid_argument(
                         "expected a name that ends in .mp4, .webm, .gif or .png, or a folder, not '" + text + "'");
                 picture.output = text;
             })
        .required = true;
    addMotion(command, options);
    CommandSpec seen{"movie", "", ""};
    addMoviePicture(seen, picture);
    for (const OptionSpec& option : seen.options) command.add(recorded(option, options.given));
}

void addWindow(CommandSpec& command, RenderOptions& first) {
    first.size = {1280, 800};
    addSavedView(command, first);
    addLook(command, first);
    addContent(command, first.input, false, first.drawn, first.look);
    addCamera(command, first);
    addSize(command, "1280x800", first.size);
    addShading(command, first);
    addWords(command, first);
    addDebug(command, first);
    addValue(command, "--stats", "FILE", "none",
             "What the window drew, as JSON, when it is closed; - for standard output",
             [&](const std::string& text) { first.stats = fileName(text); });
    addDevice(command, first);
    addFlag(command, "--capture", first.device.capture,
            "Load RenderDoc, so that F12 captures a frame; it listens on this machine alone");
}

void addLooks(CommandSpec& command, LooksOptions& options) {
    RenderOptions& picture = options.picture;
    picture.size = {384, 384};
    addContent(command, picture.input, false, picture.drawn, picture.look);
    addOutput(command, picture).required = false;
    addCamera(command, picture);
    addOcclusion(command, picture.occlusion);
    addSize(command, "384x384", picture.size);
    addSupersample(command, "auto", picture.supersample);
    addValue(command, "--columns", "N", "4", "Looks in a row of the sheet, 1 to 16",
             [&](const std::string& text) { options.columns = static_cast<int>(parseInteger(text, 1, 16)); });
    addFlag(command, "--json", options.json, "All looks as one JSON object; each of them is what --look FILE takes");
    addDevice(command, picture);
}

}  // namespace nacre::app
