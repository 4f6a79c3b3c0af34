#include "app/python/drawing.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/drawing/complete.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "app/files/spare_memory.h"
#include "app/input/interaction_list.h"
#include "app/input/read_input.h"
#include "app/picture/input_names.h"
#include "app/picture/option_json.h"
#include "app/picture/picture_names.h"
#include "app/python/interrupt.h"
#include "engine/error.h"
#include "engine/molecule/memory_bound.h"
#include "engine/renderer.h"
#include "engine/scene/build/representation.h"

namespace nacre::python {
namespace {

using app::OptionValue;
using app::PictureDescription;
using app::Topic;

/// Options only for the command line: the structure is already open, and save() writes files.
constexpr app::Topics kNotHere = Topic::input | Topic::files | Topic::view;

bool isOfReading(const app::Option& option) { return has(app::kReading, option.topic); }
/// An option of reading that also sets the occlusion cache.
bool isCache(const app::Option& option) { return option.key == "cache"; }

/// Drivers and threads do not survive fork(). @throws Error in a forked process
void checkNotForked() {
    static std::atomic<pid_t> owner{0};
    pid_t first = 0;
    const pid_t self = getpid();
    if (!owner.compare_exchange_strong(first, self) && first != self)
        throw Error("cannot draw", "process " + std::to_string(self),
                    "it was forked from one that had drawn: start processes by spawn or forkserver "
                    "(multiprocessing.get_context(\"spawn\"))");
}

/// Options that decide the device.
auto deviceKey(const DeviceOptions& d) {
    return std::tuple(d.device, d.visibility, d.multisampling, d.encoded, d.validate);
}

/// The renderer, created for the first picture and kept; one thread at a time draws. Each structure keeps its scene.
class Shared {
public:
    void draw(const Structure& structure, const PictureDescription& request, const Colors& colors, const Draw& draw) {
        checkNotForked();  // before any lock that a vanished thread may hold
        if (!colors.atoms.empty()) checkCount(colors, structure.molecule->atoms.size());
        const std::lock_guard its(structure.kept->turn);
        checkInterrupt();
        app::Drawing& drawing = structure.kept->drawing;
        if (!(structure.kept->colors == colors)) {
            drawing.forget();
            structure.kept->colors = colors;
            drawing.recolor = {};
            if (!colors.atoms.empty())
                drawing.recolor = [kept = structure.kept.get()](Representation& scene) { paint(kept->colors, scene); };
        }
        const auto check = [](double) { checkInterrupt(); };
        app::loadMaps(request, check);
        drawing.prepare(*structure.molecule, request);  // in parallel with other threads
        checkInterrupt();
        drawing.settings.occlusion.onProgress = check;
        const std::lock_guard lock(turn_);
        checkInterrupt();
        const auto key = deviceKey(request.device);
        if (!canvas_ || key_ != key || canvas_->isLost()) {
            canvas_.reset();
            canvas_.emplace(request.device);
            key_ = key;
        }
        draw(drawing, *canvas_);
        app::givePicturesMemoryBack();
        if (const auto messages = canvas_->renderer.validationMessages(); !messages.empty())
            throw Error("Vulkan validation", canvas_->renderer.stats().device.name, messages.front());
    }

private:
    std::mutex turn_;
    std::optional<app::Canvas> canvas_;
    decltype(deviceKey({})) key_;
};

/// Never destroyed: when the interpreter ends, drivers may already be gone.
Shared& shared() {
    static Shared* const one = new Shared;
    return *one;
}

/// Reading options of open(). @throws app::UsageError
app::InputOptions parseReading(const std::vector<std::string>& inputs, const std::string& json) {
    std::vector<OptionValue> values = app::parseOptionValues(json, "open()");
    for (const OptionValue& value : values)
        if (!isOfReading(app::option(value.key))) throw app::UsageError("open() takes no \"" + value.key + "\"");
    for (const std::string& input : inputs) values.push_back({"input", input});
    PictureDescription read;
    app::setOptions(values, read);
    app::completePicture(read);
    return read.input;
}

}  // namespace

PictureDescription makeRequest(const Structure& structure, const std::string& json, const std::string& output) {
    std::vector<OptionValue> values = app::parseOptionValues(json, "render()");
    for (const OptionValue& value : values) {
        const app::Option& option = app::option(value.key);
        if (has(kNotHere, option.topic)) throw app::UsageError("render() takes no \"" + value.key + "\"");
        if (isOfReading(option) && !isCache(option)) throw app::UsageError("\"" + value.key + "\" is for open()");
    }
    for (const std::string& input : structure.inputs) values.push_back({"input", input});
    values.push_back({"output", output});
    PictureDescription request;
    app::setOptions(values, request);
    request.input.conformations = structure.reading.conformations;
    app::completePicture(request);
    app::checkSize(request, app::kMostSamplesHeld);
    return request;
}

nlohmann::ordered_json interactions(const Structure& structure, const std::string& options) {
    const RepresentationOptions look = makeRequest(structure, options, kPlain).look;
    if (!look.contacts.of) throw app::UsageError("info(): \"interactions\" is a selection");
    const Molecule& molecule = *structure.molecule;
    return app::interactionList(molecule, app::listInteractions(molecule, look.contacts, look.assembly));
}

void withScene(const Structure& structure, const PictureDescription& request, const Colors& colors, const Draw& draw) {
    shared().draw(structure, request, colors, draw);
}

void checkName(const char* who, const std::string& path, bool good, std::span<const std::string> endings) {
    if (!good || app::isStandardOutput(path))
        throw app::UsageError(std::string(who) + " takes a name that ends in " + app::joinAlternatives(endings) +
                              ", not '" + path + "'");
}

Structure openInputs(const std::vector<std::string>& inputs, const std::string& options) {
    if (inputs.empty()) throw app::UsageError("open() needs an input");
    const app::InputOptions input = parseReading(inputs, options);
    const auto standard = [](const auto& one) { return one.path == "-"; };
    if (standard(input) || std::any_of(input.further.begin(), input.further.end(), standard))
        throw app::UsageError("open() does not read standard input: pass its bytes");
    const app::HeardMessages heard;
    const auto check = [](double) { checkInterrupt(); };
    auto molecule = std::make_shared<const Molecule>(app::loadMolecule(input, check, check, checkInterrupt));
    return {std::move(molecule), inputs, heard.warnings, heard.notes, input};
}

Structure openBytes(const std::string& name, std::string bytes, const std::string& options) {
    const app::InputOptions input = parseReading({name.empty() ? "bytes" : name}, options);
    if (!input.trajectory.path.empty())
        throw app::UsageError("\"trajectory\" goes with a structure's path, not its bytes");
    const std::uint64_t most =
        input.memoryMegabytes ? static_cast<std::uint64_t>(*input.memoryMegabytes) << 20 : app::memoryShare(2);
    ReadOptions reading = readWithin(most);
    reading.format = input.format;
    reading.model = input.model;
    reading.others = true;
    auto molecule = std::make_shared<const Molecule>(readMolecule(input.path, std::move(bytes), reading));
    return {std::move(molecule), {input.path}, {}, {}, input};
}

namespace {

/// @param alpha  whether to keep alpha in 8 bits per channel
void drawNow(app::Drawing& drawing, app::Canvas& canvas, bool alpha, Drawn& drawn) {
    drawn.warnings = drawing.warnings;
    if (drawing.settings.fine)
        drawn.picture = drawing.draw(canvas, &drawn.warnings);
    else
        drawn.codes = drawing.drawCoded(canvas, alpha, &drawn.warnings);
}

Drawn drawAs(const std::string& output, bool alpha, const Structure& structure, const std::string& options,
             const Colors& colors) {
    const PictureDescription request = makeRequest(structure, options, output);
    Drawn drawn;
    drawn.format = app::chooseFormat(request);
    withScene(structure, request, colors, [&](app::Drawing& drawing, app::Canvas& canvas) {
        drawNow(drawing, canvas, alpha || app::hasAlpha(drawn.format, output), drawn);
    });
    return drawn;
}

}  // namespace

Drawn draw(const Structure& structure, const std::string& options, const Colors& colors) {
    return drawAs(kPlain, true, structure, options, colors);
}

std::vector<Drawn> drawAll(const Structure& structure, const std::vector<std::string>& options, const Colors& colors) {
    // An invalid request ends the list, so that earlier pictures are not lost. It fails as the first request of the
    // next call.
    std::vector<PictureDescription> requests;
    for (const std::string& one : options) {
        try {
            requests.push_back(makeRequest(structure, one, kPlain));
        } catch (const std::exception&) {
            if (requests.empty()) throw;
            break;
        }
    }
    std::vector<Drawn> all(requests.size());
    if (requests.empty()) return all;
    for (const PictureDescription& request : requests)
        if (deviceKey(request.device) != deviceKey(requests.front().device))
            throw app::UsageError("pictures() draws with one device");
    withScene(structure, requests.front(), colors, [&](app::Drawing& drawing, app::Canvas& canvas) {
        constexpr std::size_t kInFlight = 2, kMostBytes = std::size_t{32} << 20;
        std::size_t bytes = 0;
        std::deque<Drawn*> started;
        const auto finish = [&](std::size_t left) {
            for (; started.size() > left; started.pop_front()) started.front()->codes = canvas.renderer.finishCoded();
        };
        try {
            for (std::size_t i = 0; i < requests.size(); ++i) {
                if (bytes >= kMostBytes) {
                    all.resize(i);  // the started ones precede it
                    break;
                }
                const PictureDescription& request = requests[i];
                try {
                    app::loadMaps(request);
                    drawing.prepare(*structure.molecule, request);
                    drawing.settings.occlusion.onProgress = [](double) { checkInterrupt(); };
                } catch (const std::exception&) {
                    if (i == 0) throw;
                    all.resize(i);
                    break;
                }
                all[i].format = app::chooseFormat(request);
                if (drawing.startsCoded()) {
                    drawing.startCoded(canvas, true);
                    started.push_back(&all[i]);
                    all[i].warnings = drawing.warnings;
                    finish(kInFlight - 1);
                } else {
                    finish(0);
                    drawNow(drawing, canvas, true, all[i]);
                }
                const View& view = drawing.settings.view;
                bytes += std::size_t{view.width} * view.height * (drawing.settings.fine ? sizeof(float) * 4 : 4);
            }
            finish(0);
        } catch (...) {
            while (canvas.renderer.started() > 0) canvas.renderer.finishCoded();
            throw;
        }
    });
    return all;
}

LayerPicture drawLayers(const Structure& structure, const std::string& options, const Colors& colors,
                        std::vector<std::string>& warnings) {
    LayerPicture layers;
    withScene(structure, makeRequest(structure, options, kPlain), colors,
              [&](app::Drawing& drawing, app::Canvas& canvas) {
                  warnings = drawing.warnings;
                  drawing.show(canvas);
                  layers = drawing.layers(canvas.renderer);
              });
    return layers;
}

std::vector<std::string> save(const Structure& structure, const std::string& path, const std::string& options,
                              const Colors& colors) {
    checkName("save()", path, app::isPictureName(path), app::pictureEndings());
    app::OutputFile file(path);
    const Drawn drawn = drawAs(path, false, structure, options, colors);
    checkInterrupt();
    if (drawn.codes)
        app::writePicture(file, *drawn.codes, drawn.format.dpi);
    else
        app::writePicture(file, drawn.picture, drawn.format);
    return drawn.warnings;
}

std::vector<bool> selected(const Structure& structure, const std::string& text) {
    try {
        Selection selection = parseSelection(text);
        app::InputOptions inputs;
        for (const std::string& input : structure.inputs) app::addInput(inputs, input);
        if (inputs.several()) app::nameInputs(app::inputNames(inputs), selection);
        return selectAtoms(*structure.molecule, selection);
    } catch (const Error& error) {
        throw app::UsageError(error.what());
    }
}

namespace {

/// Whether render() accepts it.
bool isOfPictures(const app::Option& option) {
    return has(app::kEveryTopic & ~kNotHere, option.topic) && (!isOfReading(option) || isCache(option));
}

}  // namespace

std::string schemaOfOptions() { return app::optionSchema("Options of a picture", isOfPictures); }

std::vector<std::pair<std::string, std::string>> optionNames() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const app::Option& option : app::options()) {
        if (!isOfPictures(option)) continue;
        std::string name(option.key);
        std::replace(name.begin(), name.end(), '-', '_');
        names.emplace_back(std::move(name), option.help);
    }
    return names;
}

}  // namespace nacre::python
