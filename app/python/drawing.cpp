#include "app/python/drawing.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <string_view>
#include <tuple>

#include "app/cli/common_options.h"
#include "app/cli/picture_job.h"
#include "app/cli/picture_options.h"
#include "app/cli/set_options.h"
#include "app/download/load_molecule.h"
#include "app/files/messages.h"
#include "app/input/read_input.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"
#include "engine/renderer.h"

namespace nacre::python {
namespace {

using app::OptionValue;
using app::RenderOptions;

/// Of the command line alone: a structure is there already, and files are save()'s.
constexpr std::array<std::string_view, 7> kNotHere = {"input",   "output", "layers",        "stats",
                                                      "capture", "view",   "allow-download"};
/// What turns or frames the same scene, or shades it: the occlusion that is baked stays.
constexpr std::array<std::string_view, 8> kOfTheCamera = {"rotate", "zoom",        "projection", "fov",
                                                          "size",   "supersample", "background", "lighting"};

bool isOne(const std::string& name, std::span<const std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// How a structure is read; it is by then.
bool isOfReading(const std::string& name) {
    static const std::vector<std::string> names = [] {
        app::InputOptions input;
        app::CommandSpec command{"read", "", ""};
        app::addInput(command, input, false);
        app::addTrajectory(command, input.trajectory);
        std::vector<std::string> list = {"fit"};
        for (const app::OptionSpec& option : command.options) list.push_back(app::plainName(option));
        return list;
    }();
    return std::find(names.begin(), names.end(), name) != names.end();
}

struct Request {
    RenderOptions options;
    std::string scene;  ///< options that the scene depends on, as one text
};

/// @param output  whose name tells the format; it is not made @throws app::UsageError
Request requestOf(const Structure& structure, const std::string& json, const std::string& output) {
    Request request;
    app::CommandSpec render{"render", "", ""};
    app::addRender(render, request.options);
    std::vector<OptionValue> values = app::optionValuesOf(json, render);
    for (const OptionValue& value : values) {
        if (isOne(value.name, kNotHere)) throw app::UsageError("render() takes no \"" + value.name + "\"");
        if (isOfReading(value.name) && value.name != "cache")
            throw app::UsageError("\"" + value.name + "\" is for open()");
        if (!isOne(value.name, kOfTheCamera)) request.scene += value.name + "=" + value.value + "\n";
    }
    for (const std::string& input : structure.inputs) values.push_back({"input", input});
    values.push_back({"output", output});
    app::setOptions(render, values);
    app::checkRender(request.options);
    app::checkSamples(request.options.size, request.options.supersample, app::kMostSamplesHeld);
    return request;
}

/// What decides about the device.
auto deviceKey(const DeviceOptions& d) { return std::tuple(d.device, d.visibility, d.encoded, d.validate); }

/// The renderer, made for the first picture and kept; one thread at a time draws.
class Shared {
public:
    /// @param prepared  loses its scene to the renderer
    template <typename Draw>
    auto draw(const Structure& structure, const Request& request, app::PreparedPicture& prepared, Draw&& draw) {
        const std::lock_guard lock(turn_);
        const auto key = deviceKey(request.options.device);
        if (!renderer_ || key_ != key || !renderer_->deviceLoss().empty()) {
            renderer_.reset();
            shown_.reset();
            renderer_.emplace(request.options.device);
            key_ = key;
        }
        if (shown_ != structure.molecule || scene_ != request.scene) {
            shown_.reset();
            renderer_->setScene(std::move(prepared.scene));
            shown_ = structure.molecule;
            scene_ = request.scene;
        }
        auto drawn = draw(*renderer_, prepared.settings);
        if (const auto messages = renderer_->validationMessages(); !messages.empty())
            throw Error("Vulkan validation", renderer_->stats().device.name, messages.front());
        return drawn;
    }

private:
    std::mutex turn_;
    std::optional<Renderer> renderer_;
    std::tuple<std::string, Visibility, EncodedDepth, bool> key_;
    std::shared_ptr<const Molecule> shown_;
    std::string scene_;
};

/// Never destroyed: at the interpreter's end drivers may be gone already.
Shared& shared() {
    static Shared* const one = new Shared;
    return *one;
}

/// How open() reads. @throws app::UsageError
app::InputOptions readingOf(const std::vector<std::string>& inputs, const std::string& json) {
    RenderOptions options;
    app::CommandSpec render{"render", "", ""};
    app::addRender(render, options);
    std::vector<OptionValue> values = app::optionValuesOf(json, render);
    for (const OptionValue& value : values)
        if (!isOfReading(value.name)) throw app::UsageError("open() takes no \"" + value.name + "\"");
    for (const std::string& input : inputs) values.push_back({"input", input});
    values.push_back({"output", "picture.png"});  // never made
    app::setOptions(render, values);
    options.output.clear();
    app::checkRender(options);
    return options.input;
}

}  // namespace

Structure openInputs(const std::vector<std::string>& inputs, const std::string& options) {
    if (inputs.empty()) throw app::UsageError("open() needs an input");
    const app::InputOptions input = readingOf(inputs, options);
    const auto standard = [](const auto& one) { return one.path == "-"; };
    if (standard(input) || std::any_of(input.further.begin(), input.further.end(), standard))
        throw app::UsageError("open() reads no standard input: hand over its bytes");
    const app::HeardMessages heard;
    auto molecule = std::make_shared<const Molecule>(app::loadMolecule(input));
    return {std::move(molecule), inputs, heard.warnings, heard.notes};
}

Structure openBytes(const std::string& name, std::string bytes, const std::string& options) {
    const app::InputOptions input = readingOf({name.empty() ? "bytes" : name}, options);
    if (!input.trajectory.path.empty())
        throw app::UsageError("\"trajectory\" goes with a structure's path, not its bytes");
    const std::uint64_t most =
        input.memoryMegabytes ? static_cast<std::uint64_t>(*input.memoryMegabytes) << 20 : app::memoryShare(2);
    ReadOptions reading = readWithin(most);
    reading.format = input.format;
    reading.model = input.model;
    return {std::make_shared<const Molecule>(readMolecule(input.path, std::move(bytes), reading)), {input.path}};
}

namespace {

constexpr const char* kPlain = "picture.png";  ///< what shows a picture's pixels as they are

Drawing drawAs(const std::string& output, const Structure& structure, const std::string& options) {
    const Request request = requestOf(structure, options, output);
    app::PreparedPicture prepared = app::preparePicture(*structure.molecule, request.options);
    Drawing drawing;
    drawing.format = app::formatOf(request.options);
    drawing.warnings = prepared.scene.warnings;
    drawing.picture = shared().draw(structure, request, prepared,
                                    [](Renderer& r, const RenderSettings& settings) { return r.render(settings); });
    if (const auto crowded = app::addWords(prepared, request.options, prepared.settings, drawing.picture))
        drawing.warnings.push_back(std::to_string(crowded) + " labels found no room in the picture");
    return drawing;
}

}  // namespace

Drawing draw(const Structure& structure, const std::string& options) { return drawAs(kPlain, structure, options); }

LayerPicture drawLayers(const Structure& structure, const std::string& options, std::vector<std::string>& warnings) {
    const Request request = requestOf(structure, options, kPlain);
    app::PreparedPicture prepared = app::preparePicture(*structure.molecule, request.options);
    warnings = prepared.scene.warnings;
    return shared().draw(structure, request, prepared,
                         [](Renderer& r, const RenderSettings& settings) { return r.layers(settings); });
}

std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options) {
    if (!app::isPictureName(path) || app::isStandardOutput(path))
        throw app::UsageError("save() takes a name that ends in .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr, not '" +
                              path + "'");
    app::OutputFile file(path);
    const Drawing drawing = drawAs(path, structure, options);
    app::writePicture(file, drawing.picture, drawing.format);
    return drawing.warnings;
}

std::vector<std::pair<std::string, std::string>> optionNames() {
    RenderOptions options;
    app::CommandSpec render{"render", "", ""};
    app::addRender(render, options);
    std::vector<std::pair<std::string, std::string>> names;
    for (const app::OptionSpec& option : render.options) {
        std::string name = app::plainName(option);
        if (isOne(name, kNotHere) || (isOfReading(name) && name != "cache")) continue;
        std::replace(name.begin(), name.end(), '-', '_');
        names.emplace_back(std::move(name), option.help);
    }
    return names;
}

}  // namespace nacre::python
