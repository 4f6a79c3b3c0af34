// Files, size and quality of a picture, and the device that draws it.

#include "app/files/output_file.h"
#include "app/picture/picture_names.h"
#include "app/picture/rows.h"

namespace nacre::app {
namespace {

using P = PictureDescription;
using T = std::string_view;

inline constexpr std::array<const char*, 6> kPaths{"auto", "encoded", "fragdepth", "deferred", "raster-order", "tiles"};
inline constexpr Visibility kPathValues[] = {Visibility::automatic, Visibility::encoded,     Visibility::fragdepth,
                                             Visibility::deferred,  Visibility::rasterOrder, Visibility::tiles};
inline constexpr std::array<const char*, 3> kMsaa{"auto", "off", "4"};  // as Multisampling
inline constexpr std::array<const char*, 6> kRungs{"auto", "r32f", "rgba16f", "rg16f", "a2b10g10r10", "rgba8"};
inline constexpr EncodedDepth kRungValues[] = {EncodedDepth::automatic,   EncodedDepth::r32f,
                                               EncodedDepth::rgba16f,     EncodedDepth::rg16f,
                                               EncodedDepth::a2b10g10r10, EncodedDepth::rgba8};

/// Maps between two lists of equal length: the value at a name's index.
template <const auto& names, const auto& values, auto... members>
Option::Access listed() {
    return valueOf<members...>(
        [](T text) { return values[parseChoice(text, names)]; },
        [](auto value) { return names[static_cast<std::size_t>(std::ranges::find(values, value) - values)]; });
}

T parseOutput(T text) {
    if (!isPictureName(std::string(text))) refuseEnding(text, pictureEndings());
    return text;
}
/// A file with one extension, or standard output.
std::string parseEnding(T text, const char* ending) {
    const std::string path(text);
    if (!isStandardOutput(path) && fileExtension(path) != ending)
        throw std::invalid_argument(std::string("expected a name that ends in ") + ending + ", not '" + path + "'");
    return path;
}

std::string lengthText(const Length& length) { return exactText(length.value) + (length.inches ? "in" : "px"); }

std::string debugNames() {
    std::string names;
    for (const char* name : debugViewNames()) names += names.empty() ? name : std::string(", ") + name;
    return names;
}

std::string samplesText(std::uint32_t samples) {
    return samples == RenderSettings::kEdges ? "auto" : std::to_string(samples);
}
std::vector<Option> sizeRows() {
    return {
        {.key = "occlusion-detail",
         .syntax = "N",
         .standard = "=",
         .help = "Maximum texels of occlusion across an atom's patch, 4 to 32; 12 are enough for thumbnails and\n"
                 "take a quarter of the time",
         .topic = Topic::detail,
         .facet = Facet::occlusion,
         .value = valueOf<&P::occlusion, &OcclusionOptions::detail>(
             [](T text) { return static_cast<std::uint32_t>(parseInteger(text, 4, 32)); })},
        {.key = "size",
         .syntax = "WxH",
         .standard = "=",
         .help = "Pixels, each side 1 to 32768",
         .topic = Topic::size,
         .facet = Facet::view,
         .value = valueOf<&P::size>(
             parseSize, [](Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); })},
        {.key = "supersample",
         .syntax = "auto|N",
         .standard = "=",
         .help = "N x N samples per pixel, 1 to 8; auto: up to 16 where a pixel shows an edge, one elsewhere",
         .topic = Topic::samples,
         .facet = Facet::shading,
         .value = valueOf<&P::supersample>(parseSupersample, samplesText)},
        {.key = "mesh-error",
         .syntax = "SHARE",
         .standard = "=",
         .help = "Allowed error of outlines of cartoons and surfaces, 0 to 4 sample distances (with --supersample\n"
                 "auto a quarter of a pixel); small meshes then take fewer triangles; 0: always all",
         .topic = Topic::levels,
         .facet = Facet::shading,
         .value = numberOf<&P::meshError>(0, kLargestMeshError)},
        {.key = "width",
         .syntax = "LENGTH",
         .standard = "from --size",
         .help = "85mm, 8.5cm, 3.3in, at --dpi; or 1200px. Without --height, keeps the aspect ratio of --size",
         .topic = Topic::paper,
         .facet = Facet::view,
         .value = valueOf<&P::width>(parseLength, lengthText)},
        {.key = "height",
         .syntax = "LENGTH",
         .standard = "from --size",
         .help = "Height, as --width",
         .topic = Topic::paper,
         .facet = Facet::view,
         .value = valueOf<&P::height>(parseLength, lengthText)},
        {.key = "dpi",
         .syntax = "N",
         .standard = "300 with lengths on paper",
         .help = "Dots per inch, 1 to 10000; stored in PNG, TIFF and JPEG",
         .topic = Topic::paper,
         .facet = Facet::view,
         .value = exactOf<&P::dpi>(1, 10000)},
        {.key = "depth",
         .syntax = "8|16",
         .standard = "=",
         .help = "Bits per channel, 16 in PNG and TIFF",
         .topic = Topic::paper,
         .value = valueOf<&P::bits>([](T text) {
             return parseChoice(text, {"8", "16"}) == 0 ? 8 : 16;
         })},
    };
}

T parseDevice(T text) {
    if (text.empty()) throw std::invalid_argument("expected a device's number or part of its name");
    return text;
}

std::vector<Option> drawingRows() {
    return {
        {.key = "debug",
         .syntax = "VIEW",
         .standard = "none",
         .help = "Show an intermediate image of the frame instead: " + debugNames(),
         .topic = Topic::debug,
         .facet = Facet::shading,
         .value = valueOf<&P::debug>([](T text) { return static_cast<DebugView>(parseChoice(text, debugViewNames())); },
                                     [](DebugView view) { return debugViewNames()[static_cast<std::size_t>(view)]; })},
        {.key = "device",
         .syntax = "N|NAME",
         .standard = "the best one",
         .help = "Number or part of the name, as `nacre devices` lists them",
         .topic = Topic::device,
         .value = valueOf<&P::device, &DeviceOptions::device>(parseDevice)},
        {.key = "visibility",
         .syntax = "PATH",
         .standard = "auto",
         .help = "auto, encoded, fragdepth, deferred, raster-order or tiles",
         .topic = Topic::path,
         .value = listed<kPaths, kPathValues, &P::device, &DeviceOptions::visibility>()},
        {.key = "msaa",
         .syntax = "auto|off|4",
         .standard = "auto",
         .help = "Samples per pixel of a window in motion, averaged on the tile; auto: 4 where the device makes them "
                 "cheap;\n"
                 "4: also in pictures with --supersample 1. A window at rest always has 16",
         .topic = Topic::path,
         .value = choiceOf<kMsaa, &P::device, &DeviceOptions::multisampling>()},
        {.key = "encoded-format",
         .syntax = "FORMAT",
         .standard = "auto",
         .help = "Format of encoded depth: auto, r32f, rgba16f, rg16f, a2b10g10r10 or rgba8",
         .topic = Topic::path,
         .value = listed<kRungs, kRungValues, &P::device, &DeviceOptions::encoded>()},
        {.key = "prepass",
         .syntax = "on|off",
         .standard = "on",
         .help = "Opaque plates that reject hidden work; never changes the picture",
         .topic = Topic::frame,
         .value = valueOf<&P::tuning, &FrameTuning::plates>(
             [](T text) { return parseChoice(text, kOnOff) == 0 ? PlateShape::automatic : PlateShape::none; },
             [](PlateShape shape) { return shape == PlateShape::none ? "off" : "on"; })},
        {.key = "transient",
         .syntax = "on|off",
         .standard = "on",
         .help = "off: every attachment has memory and is stored; never changes the picture",
         .topic = Topic::frame,
         .value = switchOf<kOnOff, &P::tuning, &FrameTuning::transient>()},
        {.key = "merge",
         .syntax = "on|off",
         .standard = "on",
         .help = "Passes as subpasses of one render pass; never changes the picture",
         .topic = Topic::frame,
         .value = switchOf<kOnOff, &P::tuning, &FrameTuning::merge>()},
        {.key = "validate",
         .help = "Run under the Vulkan validation layer; any message is an error",
         .topic = Topic::validation,
         .value = flagOf<&P::device, &DeviceOptions::validate>(),
         .kind = Option::Kind::flag},
    };
}

}  // namespace

std::vector<Option> fileRows() {
    std::vector<Option> rows{
        {.key = "output",
         .syntax = "FILE",
         .help = "The picture: .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr; - is PNG to standard output",
         .value = valueOf<&P::output>(parseOutput),
         .letter = "o",
         .required = true},
        {.key = "layers",
         .syntax = "FILE.exr",
         .standard = "none",
         .help = "Colour, depth, normal, atom and occlusion of every pixel; - for standard output",
         .value = valueOf<&P::layers>([](T text) { return parseEnding(text, ".exr"); })},
        {.key = "stats",
         .syntax = "FILE.json",
         .standard = "none",
         .help = "View, counts, times and memory as JSON; - for standard output",
         .value = fileOf<&P::stats>()},
        {.key = "save-view",
         .syntax = "FILE.json",
         .standard = "none",
         .help = "The picture's camera and all visible settings, for --view; - for standard output",
         .value = valueOf<&P::saveView>([](T text) { return parseEnding(text, ".json"); })},
        {.key = "capture",
         .syntax = "FILE.rdc",
         .standard = "none",
         .help = "The frame and its occlusion bake for RenderDoc, which must be installed and listens on this machine "
                 "only;\n- for standard output",
         .value = {[](T text, P& d) {
                       d.capture = parseEnding(text, ".rdc");
                       d.device.capture = true;
                   },
                   [](const P& d) { return d.capture; }}},
    };
    return under(Topic::files, Facet::file, std::move(rows));
}

std::vector<Option> deviceRows() {
    std::vector<Option> rows = drawingRows();
    for (Option& option : rows)
        if (option.key != "debug") option.facet = Facet::device;
    return joined({sizeRows(), rows});
}

}  // namespace nacre::app
