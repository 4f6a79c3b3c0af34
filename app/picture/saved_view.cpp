#include "app/picture/saved_view.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <utility>

#include "app/files/json_text.h"
#include "app/picture/appearance_values.h"
#include "app/picture/input_names.h"
#include "app/picture/option_text.h"
#include "app/picture/options.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

using Json = nlohmann::json;  // sorts its keys, so that it handles many
using OrderedJson = nlohmann::ordered_json;
using Kind = Option::Kind;

/// A number or text in the option's syntax.
std::string toText(const Json& value) {
    if (value.is_string()) {
        if (value.get_ref<const std::string&>().find('\0') != std::string::npos)
            throw std::invalid_argument("it contains a NUL character");  // file names would end there
        return value.get<std::string>();
    }
    if (value.is_number()) return value.dump();
    throw std::invalid_argument("expected a text or a number");
}

Rule parseRule(const std::string& option, const std::string& value) {
    if (option == "show") return parseShow(value);
    if (option == "hide") return parseHide(value);
    if (option == "color-by") return parseColorBy(value);
    throw std::invalid_argument("expected show, hide or color-by, not '" + option + "'");
}

void readRules(const Json& list, std::vector<Rule>& rules) {
    if (!list.is_array() || list.size() > kMostRules)
        throw std::invalid_argument("expected a list of at most " + std::to_string(kMostRules) + " rules");
    for (const Json& rule : list) {
        const bool off = rule.is_object() && rule.contains("off");
        if (!rule.is_object() || rule.size() != (off ? 2 : 1) || (off && !rule["off"].is_boolean()))
            throw std::invalid_argument("expected each rule as {\"option\": \"value\"}, and \"off\": true if so");
        for (const auto& [option, value] : rule.items())
            if (option != "off") rules.push_back(parseRule(option, toText(value)));
        if (off) rules.back().on = !rule["off"].get<bool>();
    }
}

OrderedJson rulesJson(const std::vector<Rule>& rules) {
    OrderedJson list = OrderedJson::array();
    for (const Rule& rule : rules) {
        const auto [option, value] = ruleText(rule);
        list.push_back({{option, value}});
        if (!rule.on) list.back()["off"] = true;
    }
    return list;
}

void readInputs(const Json& list, std::vector<FurtherInput>& inputs) {
    if (!list.is_array() || list.size() + 1 > kMostInputs)
        throw std::invalid_argument("expected a list of fewer than " + std::to_string(kMostInputs) + " molecules");
    for (const Json& each : list) {
        FurtherInput& input = inputs.emplace_back();
        if (!each.is_object()) throw std::invalid_argument("expected each molecule as {\"input\": ...}");
        for (const auto& [key, value] : each.items()) {
            if (key != "name" && key != "input" && key != "hash")
                throw std::invalid_argument("a molecule has no \"" + key + "\"");
            (key == "name" ? input.name : key == "input" ? input.path : input.hash) = toText(value);
        }
        if (input.path.empty()) throw std::invalid_argument("a molecule without \"input\"");
        if (!input.name.empty() && !isInputName(input.name))
            throw std::invalid_argument("'" + input.name + "' is not a valid name: use letters, digits, - and _");
    }
}

OrderedJson inputsJson(const std::vector<FurtherInput>& inputs) {
    OrderedJson list = OrderedJson::array();
    for (const FurtherInput& further : inputs) {
        OrderedJson each = OrderedJson::object();
        if (!further.name.empty()) each["name"] = further.name;
        each["input"] = further.path;
        if (!further.hash.empty()) each["hash"] = further.hash;
        list.push_back(each);
    }
    return list;
}

/// Passes each element of a list to the option.
void readList(const Option& option, const Json& list, PictureDescription& view) {
    if (!list.is_array() || list.size() > kMostWordOptions)
        throw std::invalid_argument("expected a list of at most " + std::to_string(kMostWordOptions) +
                                    (option.kind == Kind::pair ? " pairs" : " texts"));
    option.value.parse("", view);
    for (const Json& one : list) {
        if (option.kind == Kind::pair && (!one.is_array() || one.size() != 2))
            throw std::invalid_argument("expected each as a pair");
        option.value.parse(option.kind == Kind::pair ? toText(one[0]) + "\n" + toText(one[1]) : toText(one), view);
    }
}

/// [1, 2.5] as "1,2.5"; drops invalid numbers, so that the count is wrong.
std::string joined(const Json& list) {
    std::string text;
    for (const Json& number : list)
        if (number.is_number() && std::isfinite(number.get<double>()))
            text += (text.empty() ? "" : ",") + number.dump();
    return text;
}

void readOption(const Option& option, const Json& value, PictureDescription& view) {
    switch (option.kind) {
        case Kind::rules:
            return readRules(value, view.look.rules);
        case Kind::inputs:
            return readInputs(value, view.input.further);
        case Kind::list:
        case Kind::pair:
            return readList(option, value, view);
        case Kind::numbers:
            return option.value.parse(value.is_array() ? joined(value) : value.is_string() ? toText(value) : "", view);
        case Kind::value:
        case Kind::flag:
            return option.value.parse(toText(value), view);
    }
}

OrderedJson numberJson(const std::string& text, Option::Number number) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (number == Option::Number::none || end == text.c_str() || *end) return text;
    return number == Option::Number::real ? OrderedJson(value) : OrderedJson(std::strtoll(text.c_str(), nullptr, 10));
}

/// Splits a text at a character.
std::vector<std::string> divided(const std::string& text, char sign) {
    std::vector<std::string> pieces;
    for (std::size_t from = 0; from <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find(sign, from), text.size());
        pieces.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return pieces;
}

OrderedJson toJson(const Option& option, const PictureDescription& view) {
    if (option.kind == Kind::rules) return rulesJson(view.look.rules);
    if (option.kind == Kind::inputs) return inputsJson(view.input.further);
    const std::string text = option.value.print(view);
    if (option.kind == Kind::value || option.kind == Kind::flag) return numberJson(text, option.number);
    const auto isNumber = [](const std::string& one) { return !numberJson(one, Option::Number::real).is_string(); };
    if (option.kind == Kind::numbers && !std::ranges::all_of(divided(text, ','), isNumber)) return text;
    OrderedJson list = OrderedJson::array();
    for (const std::string& one : divided(text, option.kind == Kind::numbers ? ',' : '\n'))
        list.push_back(option.kind == Kind::numbers ? numberJson(one, Option::Number::real)
                       : option.kind == Kind::pair  ? OrderedJson(divided(one, '\t'))
                                                    : OrderedJson(one));
    return list;
}

bool isSaved(const Option& option, const PictureDescription& view) {
    static const PictureDescription kStandard;
    switch (option.save) {
        case Option::Save::never:
            return false;
        case Option::Save::always:
            return true;
        case Option::Save::withTrajectory:
            return !view.input.trajectory.path.empty();
        case Option::Save::differing:
            return option.kind == Kind::inputs ? !view.input.further.empty()
                                               : option.value.print(view) != option.value.print(kStandard);
    }
    return false;
}

constexpr const char* kWhatAViewIs = " (views are files of --save-view, of --stats and of the window)";

/// Reads keys in the order of the options, since some depend on earlier ones.
void readKeys(const Json& object, const std::string& name, PictureDescription& view) {
    const auto fail = [&](std::string_view key, const std::string& why) {
        throw Error("cannot read view", name, "\"" + std::string(key) + "\": " + why);
    };
    std::set<std::string_view> known;
    for (const Option& option : options()) {
        if (option.save == Option::Save::never) continue;
        known.insert(option.savedKey());
        const auto found = object.find(std::string(option.savedKey()));
        if (found == object.end()) continue;
        try {
            readOption(option, *found, view);
        } catch (const std::exception& error) {
            fail(option.savedKey(), error.what());
        }
    }
    for (const auto& [key, value] : object.items())
        if (!known.contains(key)) fail(key, std::string("no such key") + kWhatAViewIs);
    nameInputs(view);
}

/// Whether it is an output of --stats, which includes a view's camera and clipping planes.
bool isStatistics(const Json& object) {
    const auto view = object.find("view");
    return view != object.end() && view->is_object() && view->contains("pixels_per_angstrom");
}

void readStatistics(const Json& view, const std::string& name, PictureDescription& d) {
    const auto numbers = [&](const char* key, std::size_t count) {
        std::vector<double> values;
        const Json value = view.value(key, Json());
        for (const Json& each : value.is_array() ? value : Json::array({value}))
            if (each.is_number() && std::isfinite(each.get<double>())) values.push_back(each.get<double>());
        if (values.size() != count)
            throw Error("cannot read view", name,
                        std::string("\"") + key + "\": expected " + std::to_string(count) +
                            (count == 1 ? " number" : " numbers"));
        return values;
    };
    const std::vector<double> center = numbers("center", 3), q = numbers("orientation", 4), pan = numbers("pan", 2);
    const double across =
        std::min(numbers("width", 1)[0], numbers("height", 1)[0]) / numbers("pixels_per_angstrom", 1)[0];
    const auto text = [&](const char* key, const char* standard) {
        const Json value = view.value(key, Json(standard));
        if (!value.is_string()) throw Error("cannot read view", name, std::string("\"") + key + "\": expected a text");
        return toText(value);
    };
    Camera& camera = d.camera;
    camera = {};
    camera.fovDegrees = PictureDescription{}.camera.fovDegrees;
    camera.center = {center[0], center[1], center[2]};
    camera.pan = {pan[0], pan[1]};
    try {
        option("projection").value.parse(text("projection", "ortho"), d);
        const glm::dquat orientation(q[0], q[1], q[2], q[3]);
        if (glm::length(orientation) < 1e-9) throw std::invalid_argument("\"orientation\": expected a quaternion");
        camera.orientation = glm::normalize(orientation);
        option("scale").value.parse(exactText(across) + "A", d);
        option("clip").value.parse(text("clip", "off"), d);
        if (camera.projection == Projection::perspective) camera.eyeDistance = numbers("eye_distance", 1)[0];
    } catch (const std::invalid_argument& error) {
        throw Error("cannot read view", name, error.what());
    }
}

void readView(const std::string& json, const std::string& name, PictureDescription& view) {
    std::string twice;
    Json object;
    try {
        object = parseJson<Json>(json, twice);
    } catch (const std::invalid_argument& error) {
        throw Error("cannot read view", name, error.what());
    }
    if (!object.is_object())
        throw Error("cannot read view", name, std::string("it is not a JSON object") + kWhatAViewIs);
    if (!twice.empty()) throw Error("cannot read view", name, "\"" + twice + "\": it occurs twice");
    view.aim.fits = false;  // it keeps its scale, even if not stated
    if (isStatistics(object))
        readStatistics(object["view"], name, view);
    else
        readKeys(object, name, view);
    view.aim.uncovers = true;  // a saved plane does not count as an explicit --clip
}

/// A view's file is relative to the view; absolute paths and downloads stay.
std::string besideView(const std::string& view, const std::string& file) {
    const std::filesystem::path there = std::filesystem::path(view).parent_path() / file;
    std::error_code error;
    return std::filesystem::exists(there, error) ? there.string() : file;
}

void placeBeside(const std::string& path, PictureDescription& view) {
    changeMapFiles(view.maps, [&](const std::string& map) { return besideView(path, map); });
    for (PrimitiveSource& source : view.primitives)
        if (!source.made && !isJsonText(source.text)) source.text = besideView(path, source.text);
    for (Coloring& table : view.look.colorFrom)
        if (!table.table && !isTableText(table.source)) table.source = besideView(path, table.source);
}

/// Inserts the values of a view before the existing ones.
template <typename Value>
void append(std::vector<Value>& list, const std::vector<Value>& before) {
    list.insert(list.end(), before.begin(), before.end());
}

/// Options refer to maps by index: pads lists that are shorter than the view's list of maps.
void appendMaps(MapOptions& maps, const MapOptions& more) {
    const std::size_t count = maps.files.size();
    const auto add = [&](auto& list, const auto& of) {
        if (!of.empty() && count > 0) list.resize(count);
        append(list, of);
    };
    add(maps.files, more.files);
    add(maps.levels, more.levels);
    add(maps.styles, more.styles);
    add(maps.colors, more.colors);
    add(maps.values, more.values);
    add(maps.slices, more.slices);
    add(maps.transfers, more.transfers);
    add(maps.opacities, more.opacities);
}

}  // namespace

bool isViewFile(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    if (path.ends_with(".view.json")) return true;
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error || bytes > kMostViewBytes) return false;
    char first = 0;
    if (std::ifstream file(path, std::ios::binary); !(file >> first) || first != '{') return false;
    const auto object = parseJson<Json>(readViewText(path));
    if (!object.is_object() || object.empty()) return false;
    std::size_t known = 0;
    for (const Option& option : options())
        known += option.save != Option::Save::never && object.contains(option.savedKey()) ? 1 : 0;
    return isStatistics(object) || 2 * known > object.size();
}

PictureDescription parseSavedView(const std::string& json, const std::string& name) {
    PictureDescription view;
    readView(json, name, view);
    return view;
}

std::string readViewText(const std::string& path) {
    const std::string text = readTextFile("cannot read view", path, kMostViewBytes);
    if (text.empty()) throw Error("cannot read view", path, "it is empty");
    return text;
}

std::string savedViewJson(const PictureDescription& view) {
    OrderedJson json = OrderedJson::object();
    for (const Option& option : options())
        if (isSaved(option, view)) json[std::string(option.savedKey())] = toJson(option, view);
    return jsonText(json);
}

void applySavedView(const std::string& path, PictureDescription& description) {
    PictureDescription view = description;
    view.look.rules.clear();
    view.words.labels.clear();
    view.words.measures.clear();
    view.input.fits.clear(), view.input.alignments.clear();
    for (auto clear : {"primitives", "color-from", "map", "map-level", "map-style", "map-color", "map-color-from",
                       "map-slice", "map-opacity"})
        option(clear).value.parse("", view);
    readView(readViewText(path), path, view);
    placeBeside(path, view);
    append(view.look.rules, description.look.rules);
    append(view.words.labels, description.words.labels);
    append(view.words.measures, description.words.measures);
    append(view.input.fits, description.input.fits);
    append(view.input.alignments, description.input.alignments);
    append(view.look.colorFrom, description.look.colorFrom);
    append(view.primitives, description.primitives);
    appendMaps(view.maps, description.maps);
    view.mapsChanged();
    view.view = path;
    view.aim.placed = view.camera.isPlaced();
    if (description.input.path.empty()) {
        view.input.namedBy = view.input.path.empty() ? "" : path;
        view.input.trajectory.namedBy = view.input.trajectory.path.empty() ? "" : path;
    } else {
        view.input = description.input;
    }
    description = std::move(view);
}

InputOptions makeInput(const PictureDescription& view, InputOptions options) {
    InputOptions input = view.input;
    input.alone = view.look.ownFrame;
    input.cache = options.cache;
    input.offline = options.offline;
    input.namedBy = options.namedBy;
    input.allowDownload = options.allowDownload;
    input.memoryMegabytes = options.memoryMegabytes;
    return input;
}

}  // namespace nacre::app
