#include "app/python/drawing.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <tuple>

#include "app/download/load_molecule.h"
#include "app/drawing/complete.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/input/read_input.h"
#include "app/picture/option_json.h"
#include "app/picture/picture_names.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"
#include "engine/renderer.h"

namespace nacre::python {
namespace {

using app::OptionValue;
using app::PictureDescription;
using app::Topic;

/// For the command line alone: a structure is there already, and files are save()'s.
constexpr app::Topics kNotHere = Topic::input | Topic::files | Topic::view;

bool isOfReading(const app::Option& option) { return has(app::kReading, option.topic); }
/// Of reading, but it says where occlusion is kept, too.
bool isCache(const app::Option& option) { return option.key == "cache"; }

/// @param output  whose name tells the format; it is not made @throws app::UsageError
PictureDescription requestOf(const Structure& structure, const std::string& json, const std::string& output) {
    std::vector<OptionValue> values = app::optionValuesOf(json, "render()");
    for (const OptionValue& value : values) {
        const app::Option& option = app::option(value.key);
        if (has(kNotHere, option.topic)) throw app::UsageError("render() takes no \"" + value.key + "\"");
        if (isOfReading(option) && !isCache(option)) throw app::UsageError("\"" + value.key + "\" is for open()");
    }
    for (const std::string& input : structure.inputs) values.push_back({"input", input});
    values.push_back({"output", output});
    PictureDescription request;
    app::setOptions(values, request);
    app::completePicture(request);
    app::checkSize(request, app::kMostSamplesHeld);
    return request;
}

/// What decides about the device.
auto deviceKey(const DeviceOptions& d) { return std::tuple(d.device, d.visibility, d.encoded, d.validate); }

/// The renderer, made for the first picture and kept; one thread at a time draws. Each structure keeps its scene.
class Shared {
public:
    /// @param draw  of (drawing, canvas) what is to be handed back
    template <typename Draw>
    auto draw(const Structure& structure, const PictureDescription& request, Draw&& draw) {
        const std::lock_guard its(structure.kept->turn);
        app::Drawing& drawing = structure.kept->drawing;
        drawing.prepare(*structure.molecule, request);  // beside others that draw
        const std::lock_guard lock(turn_);
        const auto key = deviceKey(request.device);
        if (!canvas_ || key_ != key || !canvas_->renderer.deviceLoss().empty()) {
            canvas_.reset();
            canvas_.emplace(request.device);
            key_ = key;
        }
        auto drawn = draw(drawing, *canvas_);
        if (const auto messages = canvas_->renderer.validationMessages(); !messages.empty())
            throw Error("Vulkan validation", canvas_->renderer.stats().device.name, messages.front());
        return drawn;
    }

private:
    std::mutex turn_;
    std::optional<app::Canvas> canvas_;
    std::tuple<std::string, Visibility, EncodedDepth, bool> key_;
};

/// Never destroyed: at the interpreter's end drivers may be gone already.
Shared& shared() {
    static Shared* const one = new Shared;
    return *one;
}

/// How open() reads. @throws app::UsageError
app::InputOptions readingOf(const std::vector<std::string>& inputs, const std::string& json) {
    std::vector<OptionValue> values = app::optionValuesOf(json, "open()");
    for (const OptionValue& value : values)
        if (!isOfReading(app::option(value.key))) throw app::UsageError("open() takes no \"" + value.key + "\"");
    for (const std::string& input : inputs) values.push_back({"input", input});
    PictureDescription read;
    app::setOptions(values, read);
    app::completePicture(read);
    return read.input;
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

Drawn drawAs(const std::string& output, const Structure& structure, const std::string& options) {
    const PictureDescription request = requestOf(structure, options, output);
    return shared().draw(structure, request, [&](app::Drawing& drawing, app::Canvas& canvas) {
        std::size_t crowded = 0;
        Drawn drawn{drawing.draw(canvas, &crowded), app::formatOf(request), drawing.warnings};
        if (crowded) drawn.warnings.push_back(std::to_string(crowded) + " labels found no room in the picture");
        return drawn;
    });
}

}  // namespace

Drawn draw(const Structure& structure, const std::string& options) { return drawAs(kPlain, structure, options); }

LayerPicture drawLayers(const Structure& structure, const std::string& options, std::vector<std::string>& warnings) {
    return shared().draw(structure, requestOf(structure, options, kPlain),
                         [&](app::Drawing& drawing, app::Canvas& canvas) {
                             warnings = drawing.warnings;
                             drawing.show(canvas);
                             return drawing.layers(canvas.renderer);
                         });
}

std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options) {
    if (!app::isPictureName(path) || app::isStandardOutput(path))
        throw app::UsageError("save() takes a name that ends in .png, .tif, .tiff, .jpg, .jpeg, .webp or .exr, not '" +
                              path + "'");
    app::OutputFile file(path);
    const Drawn drawn = drawAs(path, structure, options);
    app::writePicture(file, drawn.picture, drawn.format);
    return drawn.warnings;
}

std::vector<std::pair<std::string, std::string>> optionNames() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const app::Option& option : app::options()) {
        if (!has(app::kEveryTopic & ~kNotHere, option.topic) || (isOfReading(option) && !isCache(option))) continue;
        std::string name(option.key);
        std::replace(name.begin(), name.end(), '-', '_');
        names.emplace_back(std::move(name), option.help);
    }
    return names;
}

}  // namespace nacre::python
