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

/// Maps between two lists of equal length: the name at a value's index.
template <typename Value>
std::string findName(Value value, const auto& values, const auto& names) {
    return names[static_cast<std::size_t>(std::find(std::begin(values), std::end(values), value) - std::begin(values))];
}

void parseOutput(T text, P& d) {
    if (!isPictureName(std::string(text))) refuseEnding(text, pictureEndings());
    d.output = text;
}

/// A file with one extension, or standard output.
std::string parseEnding(T text, const char* ending) {
    const std::string path(text);
    if (!isStandardOutput(path) && fileExtension(path) != ending)
        throw std::invalid_argument(std::string("expected a name that ends in ") + ending + ", not '" + path + "'");
    return path;
}

std::string printLength(const std::optional<Length>& length) {
    return length ? exactText(length->value) + (length->inches ? "in" : "px") : std::string();
}

std::string debugNames() {
    std::string names;
    for (const char* name : debugViewNames()) names += names.empty() ? name : std::string(", ") + name;
    return names;
}

std::string printSamples(const P& d) {
    return d.supersample == RenderSettings::kEdges ? std::string("auto") : std::to_string(d.supersample);
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
         .parse = [](T text, P& d) { d.occlusion.detail = static_cast<std::uint32_t>(parseInteger(text, 4, 32)); },
         .print = [](const P& d) { return std::to_string(d.occlusion.detail); }},
        {.key = "size",
         .syntax = "WxH",
         .standard = "=",
         .help = "Pixels, each side 1 to 32768",
         .topic = Topic::size,
         .facet = Facet::view,
         .parse = [](T text, P& d) { d.size = parseSize(text); },
         .print = [](const P& d) { return std::to_string(d.size.width) + "x" + std::to_string(d.size.height); }},
        {.key = "supersample",
         .syntax = "auto|N",
         .standard = "=",
         .help = "N x N samples per pixel, 1 to 8; auto: 16 where a pixel shows an edge, one elsewhere",
         .topic = Topic::samples,
         .facet = Facet::shading,
         .parse = [](T text, P& d) { d.supersample = parseSupersample(text); },
         .print = printSamples},
        {.key = "mesh-error",
         .syntax = "SHARE",
         .standard = "=",
         .help = "Allowed error of outlines of cartoons and surfaces, 0 to 4 sample distances (with --supersample\n"
                 "auto a quarter of a pixel); small meshes then take fewer triangles; 0: always all",
         .topic = Topic::levels,
         .facet = Facet::shading,
         .parse = [](T text, P& d) { d.meshError = parseNumber(text, 0, kLargestMeshError); },
         .print = printNumber<&P::meshError>},
        {.key = "width",
         .syntax = "LENGTH",
         .standard = "from --size",
         .help = "85mm, 8.5cm, 3.3in, at --dpi; or 1200px. Without --height, keeps the aspect ratio of --size",
         .topic = Topic::paper,
         .facet = Facet::view,
         .parse = [](T text, P& d) { d.width = parseLength(text); },
         .print = [](const P& d) { return printLength(d.width); }},
        {.key = "height",
         .syntax = "LENGTH",
         .standard = "from --size",
         .help = "Height, as --width",
         .topic = Topic::paper,
         .facet = Facet::view,
         .parse = [](T text, P& d) { d.height = parseLength(text); },
         .print = [](const P& d) { return printLength(d.height); }},
        {.key = "dpi",
         .syntax = "N",
         .standard = "300 with lengths on paper",
         .help = "Dots per inch, 1 to 10000; stored in PNG, TIFF and JPEG",
         .topic = Topic::paper,
         .facet = Facet::view,
         .parse = [](T text, P& d) { d.dpi = parseNumber(text, 1, 10000); },
         .print = [](const P& d) { return d.dpi ? exactText(*d.dpi) : std::string(); }},
        {.key = "depth",
         .syntax = "8|16",
         .standard = "=",
         .help = "Bits per channel, 16 in PNG and TIFF",
         .topic = Topic::paper,
         .parse =
             [](T text, P& d) {
                 d.bits = parseChoice(text, {"8", "16"}) == 0 ? 8 : 16;
             },
         .print = [](const P& d) { return std::to_string(d.bits); }},
    };
}

void parseDevice(T text, P& d) {
    if (text.empty()) throw std::invalid_argument("expected a device's number or part of its name");
    d.device.device = text;
}

std::vector<Option> drawingRows() {
    return {
        {.key = "debug",
         .syntax = "VIEW",
         .standard = "none",
         .help = "Show an intermediate image of the frame instead: " + debugNames(),
         .topic = Topic::debug,
         .facet = Facet::shading,
         .parse = [](T text, P& d) { d.debug = static_cast<DebugView>(parseChoice(text, debugViewNames())); },
         .print = [](const P& d) { return std::string(debugViewNames()[static_cast<std::size_t>(d.debug)]); }},
        {.key = "device",
         .syntax = "N|NAME",
         .standard = "the best one",
         .help = "Number or part of the name, as `nacre devices` lists them",
         .topic = Topic::device,
         .parse = parseDevice,
         .print = printText<&P::device, &DeviceOptions::device>},
        {.key = "visibility",
         .syntax = "PATH",
         .standard = "auto",
         .help = "auto, encoded, fragdepth, deferred, raster-order or tiles",
         .topic = Topic::path,
         .parse = [](T text, P& d) { d.device.visibility = kPathValues[parseChoice(text, kPaths)]; },
         .print = [](const P& d) { return findName(d.device.visibility, kPathValues, kPaths); }},
        {.key = "msaa",
         .syntax = "auto|off|4",
         .standard = "auto",
         .help = "Samples per pixel of a window in motion, averaged on the tile; auto: 4 where the device makes them "
                 "cheap;\n"
                 "4: also in pictures with --supersample 1. A window at rest always has 16",
         .topic = Topic::path,
         .parse = [](T text, P& d) { d.device.multisampling = static_cast<Multisampling>(parseChoice(text, kMsaa)); },
         .print = [](const P& d) { return std::string(kMsaa[static_cast<std::size_t>(d.device.multisampling)]); }},
        {.key = "encoded-format",
         .syntax = "FORMAT",
         .standard = "auto",
         .help = "Format of encoded depth: auto, r32f, rgba16f, rg16f, a2b10g10r10 or rgba8",
         .topic = Topic::path,
         .parse = [](T text, P& d) { d.device.encoded = kRungValues[parseChoice(text, kRungs)]; },
         .print = [](const P& d) { return findName(d.device.encoded, kRungValues, kRungs); }},
        {.key = "prepass",
         .syntax = "on|off",
         .standard = "on",
         .help = "Opaque plates that reject hidden work; never changes the picture",
         .topic = Topic::frame,
         .parse =
             [](T text, P& d) {
                 d.tuning.plates = parseChoice(text, kOnOff) == 0 ? PlateShape::automatic : PlateShape::none;
             },
         .print = [](const P& d) { return std::string(d.tuning.plates == PlateShape::none ? "off" : "on"); }},
        {.key = "transient",
         .syntax = "on|off",
         .standard = "on",
         .help = "off: every attachment has memory and is stored; never changes the picture",
         .topic = Topic::frame,
         .parse = parseSwitch<kOnOff, &P::tuning, &FrameTuning::transient>,
         .print = printSwitch<kOnOff, &P::tuning, &FrameTuning::transient>},
        {.key = "merge",
         .syntax = "on|off",
         .standard = "on",
         .help = "Passes as subpasses of one render pass; never changes the picture",
         .topic = Topic::frame,
         .parse = parseSwitch<kOnOff, &P::tuning, &FrameTuning::merge>,
         .print = printSwitch<kOnOff, &P::tuning, &FrameTuning::merge>},
        {.key = "validate",
         .help = "Run under the Vulkan validation layer; any message is an error",
         .topic = Topic::validation,
         .parse = parseFlag<&P::device, &DeviceOptions::validate>,
         .print = printSwitch<kOnOff, &P::device, &DeviceOptions::validate>,
         .kind = Option::Kind::flag},
    };
}

}  // namespace

std::vector<Option> fileRows() {
    std::vector<Option> rows{
        {.key = "output",
         .syntax = "FILE",
         .help = "The picture: .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr; - is PNG to standard output",
         .parse = parseOutput,
         .print = printText<&P::output>,
         .letter = "o",
         .required = true},
        {.key = "layers",
         .syntax = "FILE.exr",
         .standard = "none",
         .help = "Colour, depth, normal, atom and occlusion of every pixel; - for standard output",
         .parse = [](T text, P& d) { d.layers = parseEnding(text, ".exr"); },
         .print = printText<&P::layers>},
        {.key = "stats",
         .syntax = "FILE.json",
         .standard = "none",
         .help = "View, counts, times and memory as JSON; - for standard output",
         .parse = parseFile<&P::stats>,
         .print = printText<&P::stats>},
        {.key = "save-view",
         .syntax = "FILE.json",
         .standard = "none",
         .help = "The picture's camera and all visible settings, for --view; - for standard output",
         .parse = [](T text, P& d) { d.saveView = parseEnding(text, ".json"); },
         .print = printText<&P::saveView>},
        {.key = "capture",
         .syntax = "FILE.rdc",
         .standard = "none",
         .help = "The frame and its occlusion bake for RenderDoc, which must be installed and listens on this machine "
                 "only;\n- for standard output",
         .parse =
             [](T text, P& d) {
                 d.capture = parseEnding(text, ".rdc");
                 d.device.capture = true;
             },
         .print = printText<&P::capture>},
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
