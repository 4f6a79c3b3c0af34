#include "app/drawing/complete.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "app/input/input_files.h"
#include "app/input/map_input.h"
#include "app/picture/input_names.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "app/picture/usage_error.h"
#include "engine/scene/color/color_schemes.h"

namespace nacre::app {
namespace {

constexpr double kPrint = 300;  // default dots per inch for print

std::uint32_t toSide(const char* name, double pixels) {
    const double rounded = std::round(pixels);
    if (rounded < 1 || rounded > kLargestSide)
        throw UsageError(std::string(name) + ": " + std::to_string(static_cast<std::int64_t>(rounded)) +
                         " pixels; 1 to " + std::to_string(kLargestSide) + " are drawn");
    return static_cast<std::uint32_t>(rounded);
}

/// Whether a visible colouring uses such a palette.
bool takesPalette(const Representation& scene, const AnyPalette& palette) {
    const PaletteUse use = isRamp(palette) ? PaletteUse::ramp : PaletteUse::kinds;
    return std::ranges::any_of(scene.legends, [&](const Legend& legend) {
        const auto scheme = colorSchemeFromName(legend.scheme.substr(0, legend.scheme.find(':')));
        if (!scheme) return legend.ramp != Palette::automatic && use == PaletteUse::ramp;  // of a table
        return paletteUse(*scheme) == use;
    });
}

/// Converts widths on paper to radii in Å. @param perPoint  pixels
void takeThicknesses(PictureDescription& picture, double perPoint) {
    const bool any = picture.stickPoints || picture.bondPoints || picture.tubePoints;
    if (!any) return;
    if (!picture.camera.scale) throw UsageError("a stick's width in points depends on the scale: add --scale");
    const double shorter = std::min(picture.size.width, picture.size.height);
    const ViewScale& scale = *picture.camera.scale;
    const double perAngstrom =
        (scale.unit == ViewScale::Unit::pixelsPerAngstrom ? scale.value : shorter / scale.value) * picture.camera.zoom;
    const auto take = [&](const std::optional<double>& points, double& radius) {
        if (points) radius = *points * perPoint / perAngstrom / 2;
    };
    take(picture.stickPoints, picture.look.sizes.stick);
    take(picture.bondPoints, picture.look.sizes.bond);
    take(picture.tubePoints, picture.look.sizes.tube);
}

/// Checks that the file's format supports the options. @throws UsageError
void checkFormat(const PictureDescription& picture) {
    const std::string format = isStandardOutput(picture.output) ? ".png" : fileExtension(picture.output);
    if (picture.bits == 16 && format != ".png" && format != ".tif" && format != ".tiff")
        throw UsageError("--depth 16 is for PNG and TIFF, not " + picture.output);
    constexpr std::uint32_t kLargestWebp = 16383;  // the format's own limit
    if (format == ".webp" && std::max(picture.size.width, picture.size.height) > kLargestWebp)
        throw UsageError("WebP holds at most " + std::to_string(kLargestWebp) + " pixels per side");
}

}  // namespace

bool takeInput(PictureDescription& picture) {
    InputOptions& input = picture.input;
    input.alone = picture.look.ownFrame;
    if (!input.trajectory.namedBy.empty()) input.trajectory.path = resolveTrajectoryPath(input);
    return !input.path.empty();
}

void takeMap(PictureDescription& picture) {
    InputOptions& input = picture.input;
    std::vector<std::string> found;
    if (isMap(input)) found.push_back(mapName(input));
    std::erase_if(input.further, [&](const FurtherInput& further) {
        const InputOptions each = furtherInput(input, further);
        if (each.opened || !isMap(each)) return false;
        found.push_back(mapName(each));
        return true;
    });
    std::vector<std::string>& files = picture.maps.files;
    std::erase_if(found, [&](const std::string& name) { return std::ranges::find(files, name) != files.end(); });
    if (found.empty()) return;
    files.insert(files.begin(), found.begin(), found.end());
    picture.mapsChanged();
}

void takeSeveral(PictureDescription& picture) {
    const InputOptions& input = picture.input;
    if (!input.several()) {
        if (input.conformations && !input.trajectory.path.empty())
            throw UsageError("--conformations and --trajectory exclude each other");
        if (!input.further.empty() && (!input.fits.empty() || !input.alignments.empty()))
            throw UsageError("--conformations superposes the INPUTs: leave out --fit and --align");
        if (!input.fits.empty()) throw UsageError("--fit superposes one INPUT on another: name two");
        if (!input.alignments.empty()) throw UsageError("--align superposes one INPUT on another: name two");
        return;
    }
    if (!picture.look.assembly.empty()) throw UsageError("--assembly is for one INPUT");
    const auto standardInputs = std::count_if(input.further.begin(), input.further.end(),
                                              [](const FurtherInput& further) { return further.path == "-"; });
    if (standardInputs + (input.path == "-" ? 1 : 0) > 1) throw UsageError("only one INPUT can be standard input");
    const std::vector<std::string> names = inputNames(input);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const std::string& given = i == 0 ? input.name : input.further[i - 1].name;
            !given.empty() && given != names[i])
            throw UsageError("two INPUTs have the name '" + given + "'");
    nameInputs(picture);
    // A view of several inputs keeps its saved colours.
    if (input.namedBy.empty()) colorApart(names, picture.look);
}

void checkFrames(const PictureDescription& picture, bool throughModels) {
    const TrajectoryOptions& frames = picture.input.trajectory;
    if (frames.path.empty() && (frames.frame != 1 || frames.whole))
        throw UsageError("--frame and --whole are for the frames of --trajectory");
    if (frames.path.empty() && !throughModels && frames.smooth != 1)
        throw UsageError("--smooth is for the frames of --trajectory, or of a movie through --models");
}

void checkDebug(const PictureDescription& picture) {
    const std::string view = debugViewNames()[static_cast<std::size_t>(picture.debug)];
    if (needsOcclusion(picture.debug) && picture.occlusion.directions == 0)
        throw UsageError("--debug " + view + " shows nothing with --occlusion off");
    if (picture.debug != DebugView::none && picture.supersample > 1)
        throw UsageError("--debug " + view + " takes one sample per pixel: leave out --supersample");
}

void checkSize(const PictureDescription& picture, std::uint64_t most) {
    if (picture.device.multisampling == Multisampling::four && picture.supersample != 1)
        throw UsageError("--msaa 4 is for pictures of one sample per pixel: add --supersample 1");
    try {
        checkSamples(picture.size, picture.supersample, most);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

void checkFiles(const PictureDescription& picture, std::vector<NamedFile> further) {
    std::vector<NamedFile> files{{"INPUT", resolveInputPath(picture.input)}, {"--view", picture.view},
                                 {"--output", picture.output, true},         {"--layers", picture.layers, true},
                                 {"--stats", picture.stats, true},           {"--capture", picture.capture, true},
                                 {"--save-view", picture.saveView, true}};
    files.push_back({"--trajectory", picture.input.trajectory.path});
    for (const FurtherInput& input : picture.input.further) files.push_back({"INPUT", input.path});
    std::move(further.begin(), further.end(), std::back_inserter(files));
    try {
        checkApart(files);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

void takePaper(PictureDescription& picture) {
    if ((picture.width && picture.width->inches) || (picture.height && picture.height->inches))
        picture.dpi = picture.dpi.value_or(kPrint);
    const double dpi = picture.dpi.value_or(kScreenDpi);
    Size& size = picture.size;
    const double shape = static_cast<double>(size.height) / size.width;
    const double width = picture.width ? picture.width->pixels(dpi) : 0;
    const double height = picture.height ? picture.height->pixels(dpi) : 0;
    if (picture.width) size.width = toSide("--width", width);
    if (picture.height) size.height = toSide("--height", height);
    if (picture.width && !picture.height) size.height = toSide("--width", width * shape);
    if (picture.height && !picture.width) size.width = toSide("--height", height / shape);
    constexpr double kPointsPerInch = 72;
    if (picture.linePoints) picture.look.lineWidth = std::min(*picture.linePoints * dpi / kPointsPerInch, kWidestWire);
    takeThicknesses(picture, dpi / kPointsPerInch);
    if (picture.textPoints) picture.words.size = *picture.textPoints * dpi / kPointsPerInch;
}

void completePicture(PictureDescription& picture) {
    completeUnwritten(picture);
    checkFiles(picture);
}

void completeUnwritten(PictureDescription& picture) {
    if (!takeInput(picture)) throw UsageError("INPUT is required: a file, pdb:1BNA, or sample:dna");
    takeMap(picture);
    checkFrames(picture);
    takeSeveral(picture);
    checkDebug(picture);
    takePaper(picture);
    checkFormat(picture);
    checkSize(picture);
}

PictureDescription withWholePaths(PictureDescription picture) {
    const InputOptions each = picture.input;
    picture.input.path = resolveInputPath(each);
    for (FurtherInput& further : picture.input.further) further.path = resolveInputPath(furtherInput(each, further));
    std::string& trajectory = picture.input.trajectory.path;
    if (!trajectory.empty()) trajectory = std::filesystem::absolute(trajectory).lexically_normal().string();
    return picture;
}

std::vector<std::string> idleOptions(const PictureDescription& options, const Representation& scene,
                                     const Effects& effects, double reach) {
    std::vector<std::string> said;
    PictureDescription drawn = options;
    drawn.effects = effects;
    for (const std::string& key : options.given) {
        const std::string needs(option(key).needs);
        if (needs.empty()) continue;
        if (const std::string on = option(needs).value.print(drawn); on.empty() || on == "off")
            said.push_back("--" + key + " changes nothing without --" + needs);
    }
    if (const AnyPalette& palette = options.look.palette;
        palette != Palette::automatic && !takesPalette(scene, palette))
        said.push_back("--palette " + paletteName(palette) + " changes nothing: nothing is coloured by " +
                       (isRamp(palette) ? "numbers" : "categories"));
    if (options.occlusion.bounce && !scene.copies.colors.empty())
        said.push_back("--bounce changes nothing where copies have their own colours (--color copy)");
    if (options.words.seenOnly && options.words.labels.empty())
        said.push_back("--show-labels changes nothing without --label");
    if (effects.clip.near >= reach || effects.clip.far <= -reach)
        said.push_back("the clipping planes remove everything: the molecule reaches " + numberText(std::ceil(reach)) +
                       " A from its centre");
    return said;
}

}  // namespace nacre::app
