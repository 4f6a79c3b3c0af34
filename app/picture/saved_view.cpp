#include "app/picture/saved_view.h"

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>

#include "app/files/json_text.h"
#include "app/picture/appearance_values.h"
#include "app/picture/effect_options.h"
#include "app/picture/input_names.h"
#include "app/picture/mesh_options.h"
#include "app/picture/option_text.h"
#include "app/picture/option_values.h"
#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

using Json = nlohmann::json;  // sorts its keys, so that many of them are no burden
using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostRules = 1000;

/// A number or text as an option would have it.
std::string textOf(const Json& value) {
    if (value.is_string()) {
        if (value.get_ref<const std::string&>().find('\0') != std::string::npos)
            throw std::invalid_argument("it holds a NUL");  // where names of files would end
        return value.get<std::string>();
    }
    if (value.is_number()) return value.dump();
    throw std::invalid_argument("expected a text or a number");
}

bool isOn(const Json& value, const char* on, const char* off) { return parseChoice(textOf(value), {on, off}) == 0; }

template <std::size_t count>
std::array<double, count> numbersOf(const Json& value) {
    if (!value.is_array() || value.size() != count)
        throw std::invalid_argument("expected a list of " + std::to_string(count) + " numbers");
    std::array<double, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        if (!value[i].is_number() || !std::isfinite(value[i].get<double>()))
            throw std::invalid_argument("expected a list of " + std::to_string(count) + " numbers");
        numbers[i] = value[i].get<double>();
    }
    return numbers;
}

glm::dquat orientationOf(const Json& value) {
    const auto q = numbersOf<4>(value);
    const glm::dquat orientation(q[0], q[1], q[2], q[3]);
    const double length = glm::length(orientation);
    if (!(length > 1e-6 && length < 1e6)) throw std::invalid_argument("expected a quaternion w, x, y, z");
    // One that is unit already keeps its very digits.
    return std::abs(length - 1) < 1e-12 ? orientation : orientation / length;
}

Rule parseRule(const std::string& option, const std::string& value) {
    if (option == "show") return parseShow(value);
    if (option == "hide") return parseHide(value);
    if (option == "color-by") return parseColorBy(value);
    throw std::invalid_argument("expected show, hide or color-by, not '" + option + "'");
}

void readRules(const Json& list, SavedView& view) {
    if (!list.is_array() || list.size() > kMostRules)
        throw std::invalid_argument("expected a list of at most " + std::to_string(kMostRules) + " rules");
    for (const Json& rule : list) {
        const bool off = rule.is_object() && rule.contains("off");
        if (!rule.is_object() || rule.size() != (off ? 2 : 1) || (off && !rule["off"].is_boolean()))
            throw std::invalid_argument("expected each rule as {\"option\": \"value\"}, and \"off\": true if so");
        for (const auto& [option, value] : rule.items())
            if (option != "off") view.look.rules.push_back(parseRule(option, textOf(value)));
        if (off) view.look.rules.back().on = !rule["off"].get<bool>();
    }
}

std::optional<Format> parseFormat(const std::string& name) {
    const auto format = formatFromName(name);
    if (!name.empty() && !format) throw std::invalid_argument("expected one of " + formatNames());
    return format;
}

/// Texts of an option that may be given many times.
template <typename Value>
void readList(const Json& list, std::vector<Value>& values, Value (*parse)(std::string_view)) {
    if (!list.is_array() || list.size() > kMostWordOptions)
        throw std::invalid_argument("expected a list of at most " + std::to_string(kMostWordOptions) + " texts");
    for (const Json& text : list) values.push_back(parse(textOf(text)));
}

/// @returns whether the key is one of how atoms move
bool readTrajectory(const std::string& key, const Json& value, TrajectoryOptions& trajectory) {
    if (key == "trajectory")
        trajectory.path = textOf(value);
    else if (key == "trajectory-hash")
        trajectory.hash = textOf(value);
    else if (key == "frame")
        trajectory.frame = parseFrame(textOf(value));
    else if (key == "whole")
        trajectory.whole = isOn(value, "on", "off");
    else if (key == "fit-frames")
        trajectory.fit = parseSelection(textOf(value));
    else if (key == "smooth")
        trajectory.smooth = parseSmoothing(textOf(value));
    else
        return false;
    return true;
}

std::vector<FurtherInput> readInputs(const Json& list) {
    if (!list.is_array() || list.size() + 1 > kMostInputs)
        throw std::invalid_argument("expected a list of fewer than " + std::to_string(kMostInputs) + " molecules");
    std::vector<FurtherInput> inputs;
    for (const Json& each : list) {
        FurtherInput& input = inputs.emplace_back();
        if (!each.is_object()) throw std::invalid_argument("expected each molecule as {\"input\": ...}");
        for (const auto& [key, value] : each.items()) {
            if (key != "name" && key != "input" && key != "hash")
                throw std::invalid_argument("a molecule has no \"" + key + "\"");
            (key == "name" ? input.name : key == "input" ? input.path : input.hash) = textOf(value);
        }
        if (input.path.empty()) throw std::invalid_argument("a molecule without \"input\"");
        if (!input.name.empty() && !isInputName(input.name))
            throw std::invalid_argument("'" + input.name + "' is no name: letters, digits, - and _");
    }
    return inputs;
}

std::vector<FitOptions> readFits(const Json& list) {
    if (!list.is_array() || list.size() > kMostInputs) throw std::invalid_argument("expected a list of pairs");
    std::vector<FitOptions> fits;
    for (const Json& pair : list) {
        if (!pair.is_array() || pair.size() != 2) throw std::invalid_argument("expected each fit as a pair");
        fits.push_back({parseSelection(textOf(pair[0])), parseSelection(textOf(pair[1]))});
    }
    return fits;
}

void addInputKeys(const SavedView& view, OrderedJson& json) {
    if (!view.name.empty()) json["name"] = view.name;
    for (const FurtherInput& further : view.further) {
        OrderedJson each = OrderedJson::object();
        if (!further.name.empty()) each["name"] = further.name;
        each["input"] = further.path;
        if (!further.hash.empty()) each["hash"] = further.hash;
        json["further-inputs"].push_back(each);
    }
    for (const FitOptions& fit : view.fits) json["fits"].push_back({fit.moving.text, fit.fixed.text});
}

void addMotionKeys(const TrajectoryOptions& trajectory, OrderedJson& json) {
    if (!trajectory.path.empty()) {
        json["trajectory"] = trajectory.path;
        if (!trajectory.hash.empty()) json["trajectory-hash"] = trajectory.hash;
        json["frame"] = trajectory.frame;
    }
    if (trajectory.whole) json["whole"] = "on";
    if (trajectory.fit) json["fit-frames"] = trajectory.fit->text;
    if (trajectory.smooth > 1) json["smooth"] = trajectory.smooth;
}

/// @returns whether the key is one of words
bool readWords(const std::string& key, const Json& value, Words& words) {
    if (key == "labels")
        readList(value, words.labels, parseLabel);
    else if (key == "measures")
        readList(value, words.measures, parseMeasure);
    else if (key == "title")
        words.title = parseTitle(textOf(value));
    else if (key == "scale-bar")
        words.scaleBar = parseScaleBar(textOf(value));
    else if (key == "legend")
        words.legend = isOn(value, "on", "off");
    else if (key == "show-labels")
        words.seenOnly = !isOn(value, "all", "seen");
    else if (key == "text-size")
        words.size = parseNumber(textOf(value), 4, 2000);
    else if (key == "text-color")
        words.color = parseInk(textOf(value));
    else
        return false;
    return true;
}

void addWords(const Words& words, OrderedJson& json) {
    for (const Label& label : words.labels) json["labels"].push_back(labelText(label));
    for (const Measure& measure : words.measures) json["measures"].push_back(measure.text);
    if (!words.title.empty()) json["title"] = words.title;
    if (words.scaleBar != ScaleBar::off) json["scale-bar"] = scaleBarText(words.scaleBar);
    if (words.legend) json["legend"] = "on";
    if (words.seenOnly) json["show-labels"] = "seen";
    if (words.size > 0) json["text-size"] = words.size;
    if (words.color) json["text-color"] = backgroundText({(*words.color)[0], (*words.color)[1], (*words.color)[2], 1});
}

void readKey(const std::string& key, const Json& value, SavedView& view) {
    if (key == "input") {
        view.input = textOf(value);
    } else if (key == "hash") {
        view.hash = textOf(value);
    } else if (key == "name") {
        view.name = textOf(value);
        if (!isInputName(view.name))
            throw std::invalid_argument("'" + view.name + "' is no name: letters, digits, - and _");
    } else if (key == "further-inputs") {
        view.further = readInputs(value);
    } else if (key == "fits") {
        view.fits = readFits(value);
    } else if (key == "format") {
        view.format = parseFormat(textOf(value));
    } else if (key == "model") {
        view.model = parseModel(textOf(value));
    } else if (key == "camera") {
        view.look.ownFrame = !isOn(value, "all", "model");
    } else if (key == "occlusion-models") {
        view.look.modelsOcclude = !isOn(value, "own", "all");
    } else if (key == "assembly") {
        view.look.assembly = textOf(value);
    } else if (key == "style") {
        view.look.style = parseStyle(textOf(value));
    } else if (key == "color") {
        view.look.color = parseColoring(textOf(value));
    } else if (key == "palette") {
        view.look.palette = parsePalette(textOf(value));
    } else if (key == "rules") {
        readRules(value, view);
    } else if (key == "water") {
        view.drawn.water = isOn(value, "show", "hide");
    } else if (key == "hydrogens") {
        view.drawn.hydrogens = isOn(value, "show", "hide");
    } else if (key == "projection") {
        view.camera.projection =
            isOn(value, "ortho", "perspective") ? Projection::orthographic : Projection::perspective;
    } else if (key == "fov") {
        view.camera.fovDegrees = parseNumber(textOf(value), kSmallestFov, kLargestFov);
    } else if (key == "zoom") {
        view.camera.zoom = parseNumber(textOf(value), kSmallestZoom, kLargestZoom);
    } else if (key == "orientation") {
        view.camera.orientation = orientationOf(value);
    } else if (key == "pan") {
        const auto pan = numbersOf<2>(value);
        view.camera.pan = {pan[0], pan[1]};
    } else if (key == "uncover") {
        view.uncover = parseSelection(textOf(value));
    } else if (key == "background") {
        view.background = parseColor(textOf(value));
    } else if (key == "lighting") {
        view.lighting = isOn(value, "on", "off");
    } else if (key == "occlusion") {
        view.occlusionDirections = parseOcclusion(textOf(value));
    } else if (const EffectOption* option = effectOption(key)) {
        option->set(textOf(value), view.effects);
    } else if (const MeshOption* mesh = meshOption(key)) {
        mesh->set(textOf(value), view.look);
    } else if (!readWords(key, value, view.words) && !readTrajectory(key, value, view.trajectory)) {
        throw std::invalid_argument("no such key");
    }
}

}  // namespace

void setViewKey(const std::string& key, const std::string& value, SavedView& view) { readKey(key, value, view); }

SavedView parseSavedView(const std::string& json, const std::string& name) {
    std::string twice;
    Json object;
    try {
        object = parseJson<Json>(json, twice);
    } catch (const std::invalid_argument& error) {
        throw Error("cannot read view", name, error.what());
    }
    if (!object.is_object()) throw Error("cannot read view", name, "it is no JSON object");
    if (!twice.empty()) throw Error("cannot read view", name, "\"" + twice + "\": it is there twice");
    SavedView view;
    for (const auto& [key, value] : object.items()) {
        try {
            readKey(key, value, view);
        } catch (const std::exception& error) {
            throw Error("cannot read view", name, "\"" + key + "\": " + error.what());
        }
    }
    nameInputs(view);
    return view;
}

std::string readViewText(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text;
    for (char c = 0; text.size() <= kMostBytes && file.get(c);) text.push_back(c);
    if (text.empty()) throw Error("cannot read view", path, "the file is missing, empty or not readable");
    if (text.size() > kMostBytes) throw Error("cannot read view", path, "it is larger than a view can be");
    return text;
}

SavedView readSavedView(const std::string& path) { return parseSavedView(readViewText(path), path); }

std::string savedViewJson(const SavedView& view) {
    OrderedJson json = OrderedJson::object();
    if (!view.input.empty()) json["input"] = view.input;
    if (!view.hash.empty()) json["hash"] = view.hash;
    addInputKeys(view, json);
    if (view.format) json["format"] = formatName(*view.format);
    json["model"] = view.model == kAllModels ? OrderedJson("all") : OrderedJson(view.model);
    addMotionKeys(view.trajectory, json);
    if (view.look.ownFrame) json["camera"] = "model";
    if (view.look.modelsOcclude) json["occlusion-models"] = "all";
    if (!view.look.assembly.empty()) json["assembly"] = view.look.assembly;
    if (view.look.style) json["style"] = styleName(*view.look.style);
    json["color"] = coloringText(view.look.color);
    if (view.look.palette != Palette::automatic) json["palette"] = paletteName(view.look.palette);
    for (const MeshOption& option : meshOptions())
        if (option.text(view.look) != option.text({})) json[option.name] = option.text(view.look);
    json["rules"] = OrderedJson::array();
    for (const Rule& rule : view.look.rules) {
        const auto [option, value] = ruleText(rule);
        json["rules"].push_back({{option, value}});
        if (!rule.on) json["rules"].back()["off"] = true;
    }
    json["water"] = view.drawn.water ? "show" : "hide";
    json["hydrogens"] = view.drawn.hydrogens ? "show" : "hide";
    json["projection"] = view.camera.projection == Projection::orthographic ? "ortho" : "perspective";
    json["fov"] = view.camera.fovDegrees;
    json["zoom"] = view.camera.zoom;
    const glm::dquat& q = view.camera.orientation;
    json["orientation"] = {q.w, q.x, q.y, q.z};
    json["pan"] = {view.camera.pan.x, view.camera.pan.y};
    if (view.uncover) json["uncover"] = view.uncover->text;
    json["background"] = backgroundText(view.background);
    json["lighting"] = view.lighting ? "on" : "off";
    json["occlusion"] = view.occlusionDirections ? OrderedJson(view.occlusionDirections) : OrderedJson("off");
    for (const EffectOption& option : effectOptions())
        if (option.text(view.effects) != option.text({})) json[option.name] = option.text(view.effects);
    addWords(view.words, json);
    return jsonText(json);
}

InputOptions inputOf(const SavedView& view, InputOptions options) {
    options.path = view.input;
    options.hash = view.hash;
    options.format = view.format;
    options.model = view.model;
    options.alone = view.look.ownFrame;
    options.trajectory = view.trajectory;
    options.name = view.name;
    options.further = view.further;
    options.fits = view.fits;
    return options;
}

}  // namespace nacre::app
