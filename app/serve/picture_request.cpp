#include "app/serve/picture_request.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/download/database_id.h"
#include "app/download/load_scene.h"
#include "app/drawing/complete.h"
#include "app/files/json_text.h"
#include "app/files/opened_file.h"
#include "app/files/unnamed_file.h"
#include "app/input/input_files.h"
#include "app/picture/appearance_values.h"
#include "app/picture/picture_names.h"
#include "app/picture/saved_view.h"
#include "app/serve/problem.h"
#include "app/serve/uploads.h"
#include "engine/error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

constexpr Topics kServers = Topic::device | Topic::path | Topic::validation | Topic::files | Topic::view |
                            Topic::trajectory | Topic::debug | Topic::frame;
const std::string kBody = "the input";  // the name of a body
/// Options reserved to the server: of reading, and one that starts programs.
constexpr std::string_view kServerKeys[] = {"cache",   "offline",       "memory", "occlusion-memory",
                                            "mvs-map", "electrostatics"};

using Opened = std::shared_ptr<const OpenedFile>;

/// Opens an input, if a request may use it. Null: it is no file. @throws Problem
Opened openedInput(const std::string& input, const ServeOptions& options, const Uploads& uploads) {
    if (input.starts_with(Uploads::kPrefix)) {
        if (Opened file = uploads.find(input)) return file;
        throw Problem(404, "'" + input + "' is no longer stored: upload it again");
    }
    if (input.starts_with("sample:")) return nullptr;
    try {
        if (parseDatabaseId(input)) return nullptr;
    } catch (const Error& wrong) {
        throw Problem(400, wrong.what());
    }
    if (options.root.empty())
        throw Problem(404, "'" + input +
                               "' is neither a sample nor an identifier (pdb:1BNA), and this server has no folder "
                               "of files (--root)");
    const std::shared_ptr<const OpenFolder> root = OpenFolder::at(options.root);
    Opened file = root ? root->open(input) : nullptr;
    // Gives the same answer for files outside the root and missing files.
    if (!file) throw Problem(404, "there is no input '" + input + "'");
    return file;
}

/// Replaces an input, if a request may use it. @throws Problem
void takeInput(std::string& path, Opened& opened, const ServeOptions& options, const Uploads& uploads) {
    opened = openedInput(path, options, uploads);
    if (opened) path = opened->name();
}

/// Key of an input: its name, its content, and the content of files that it names. A body's name is ignored.
std::string makeKey(const InputOptions& input) {
    if (!input.opened) return input.path;
    return input.path + (input.sceneFiles ? " with its folder " : " ") + fileHash(input.opened->path()) + "\n" +
           contentOfNamed(input);
}

/// Whether an option takes a file or its text; the server accepts the text.
bool takesText(const Option& option) { return option.syntax.find("FILE|") != std::string::npos; }

OptionValue parseValue(const std::string& key, const std::string& text) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', '-');
    const Option* row = findOption(name);
    if (!row) throw Problem(400, "there is no option \"" + key + "\" (GET /options lists them)");
    if (!isServed(*row)) throw Problem(400, "\"" + key + "\" is set by the server");
    if (takesText(*row) && !isTableText(text)) throw Problem(400, "\"" + key + "\" takes text here, not a file name");
    if (name == "format" && !formatFromName(text)) {
        std::string names;
        for (const std::string& ending : pictureEndings()) names += (names.empty() ? "" : ", ") + ending.substr(1);
        throw Problem(400, "format: expected one of " + names + " for the picture, or an input's format (" +
                               formatNames() + "), not '" + text + "'");
    }
    if (name == "look" && text.find_first_of("./\\") != std::string::npos)
        throw Problem(400, "\"look\" takes a look's name here");
    OptionValue value{name, text};
    if (row->kind == Option::Kind::flag) {
        if (text == "off" || text == "false" || text == "0") return {};
        value.value.clear();
    } else if (row->kind == Option::Kind::pair) {
        std::replace(value.value.begin(), value.value.end(), ';', '\n');
    }
    return value;
}

/// An untrusted saved view: its inputs count as the request's.
void takeView(const std::string& text, const std::string& name, PictureDescription& d) {
    PictureDescription view = parseSavedView(text, name);
    if (!view.input.trajectory.path.empty()) throw Problem(422, "a view's trajectory is not drawn here");
    if (!view.maps.files.empty() || !view.maps.surface.file.empty())
        throw Problem(422, "a view's maps are not drawn here");
    for (const PrimitiveSource& source : view.primitives)
        if (!isJsonText(source.text)) throw Problem(422, "a view's files of primitives are not drawn here");
    for (const Coloring& table : view.look.colorFrom)
        if (!isTableText(table.source)) throw Problem(422, "a view's files of colours are not drawn here");
    view.input.namedBy.clear();
    view.input.hash.clear();
    for (FurtherInput& further : view.input.further) further.hash.clear();
    view.size = d.size;
    d = view;
}

/// Options that affect the picture. @param reading  only those that affect the molecule
std::string printed(const PictureDescription& description, bool reading) {
    std::ostringstream text;
    for (const Option& row : options())
        if (row.value.print && row.facet != Facet::device && row.key != "output" && row.key != "input" &&
            row.key != "further-inputs" && row.key != "cache" &&
            (!reading || row.facet == Facet::input || row.facet == Facet::frame))
            text << row.key << '=' << row.value.print(description) << '\n';
    return text.str();
}

/// Whether `format` is the picture's; with any other value, the key is the input's format.
bool isPictureFormat(const std::string& key, const std::string& text) {
    return key == "format" && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos &&
           isPictureName("picture." + text);
}

std::string pictureName(const Query& query) {
    std::string name = "picture.png";
    for (const auto& [key, text] : query)
        if (isPictureFormat(key, text)) name = "picture." + text;
    return name;
}

bool isStyle(const std::string& word) {
    try {
        parseStyle(word);
        return true;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

}  // namespace

bool isServed(const Option& option) {
    const bool file = option.syntax.find("FILE") != std::string::npos && !takesText(option) && option.key != "look";
    return !file && !has(kServers, option.topic) && option.topic != Topic::saved &&
           std::find(std::begin(kServerKeys), std::end(kServerKeys), option.key) == std::end(kServerKeys);
}

std::string moleculeKey(const PictureDescription& description) {
    const InputOptions& input = description.input;
    std::string key = printed(description, true) + (input.alone ? "alone " : "") + makeKey(input);
    for (const FurtherInput& further : input.further)
        key += "\n" + further.name + "=" + makeKey(furtherInput(input, further));
    return key;
}

PictureRequest pictureRequest(const Query& query, const UnnamedFile* body, const ServeOptions& options,
                              const Uploads& uploads) {
    PictureRequest request;
    PictureDescription& d = request.description;
    try {
        bool isView = false;
        if (body) {
            const std::string text = body->size() <= kMostViewBytes ? body->bytes() : std::string();
            const nlohmann::json json = parseJson<nlohmann::json>(text);
            isView = json.is_object() && (json.contains("input") || json.contains("rules") || json.contains("style"));
            if (isView) takeView(text, "the request's view", d);
        }
        std::vector<OptionValue> values;
        for (const auto& [key, text] : query) {
            if (isPictureFormat(key, text)) continue;
            OptionValue value = parseValue(key, text);
            if (!value.key.empty()) values.push_back(std::move(value));
        }
        setOptions(values, d);
        if (body && !isView)
            d.input.path = kBody, d.input.opened = OpenedFile::of(kBody, *body);
        else if (!d.input.path.empty())
            takeInput(d.input.path, d.input.opened, options, uploads);
        for (FurtherInput& further : d.input.further) takeInput(further.path, further.opened, options, uploads);
        d.output = pictureName(query);
        d.input.cache = options.picture.input.cache;
        d.input.offline = options.picture.input.offline || !options.picture.input.allowDownload;
        d.input.memoryMegabytes = options.picture.input.memoryMegabytes;
        // Scenes may download by the server's rules, and may not read its files.
        d.input.allowDownload = options.picture.input.allowDownload;
        d.input.sceneMaps = options.picture.input.sceneMaps;
        d.input.sceneHosts = options.sceneHosts;
        d.input.sceneFiles = !body && d.input.opened && d.input.opened->hasFolder();
        d.occlusion.megabytes = options.picture.occlusion.megabytes;
        d.device = options.picture.device;
        completeUnwritten(d);
        checkSize(d, kMostServedSamples);
        request.molecule = moleculeKey(d);
        request.identity = printed(d, false) + request.molecule + "\n" + d.output;
    } catch (const UsageError& error) {
        throw Problem(400, error.what());
    } catch (const Error& error) {
        throw Problem(422, error.what());
    } catch (const std::invalid_argument& error) {
        throw Problem(400, error.what());
    }
    return request;
}

Query queryOfName(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || !isPictureFormat("format", name.substr(dot + 1))) return {};
    std::string stem = name.substr(0, dot), size;
    const std::size_t dash = stem.rfind('-');
    if (dash != std::string::npos && stem.find('x', dash) != std::string::npos &&
        stem.find_first_not_of("0123456789x", dash + 1) == std::string::npos) {
        size = stem.substr(dash + 1);
        stem.resize(dash);
    }
    std::istringstream words(stem);
    std::string id;
    std::getline(words, id, '_');
    const std::vector<std::string> samples = sampleNames();
    const bool sample = std::find(samples.begin(), samples.end(), id) != samples.end();
    if (!sample && (id.size() != 4 || !std::isdigit(static_cast<unsigned char>(id[0])))) return {};
    Query query{{"input", (sample ? "sample:" : "pdb:") + id}, {"format", name.substr(dot + 1)}};
    for (std::string word; std::getline(words, word, '_');) {
        if (word.starts_with("assembly-"))
            query.emplace_back("assembly", word.substr(9));
        else if (word.starts_with("model-"))
            query.emplace_back("model", word.substr(6));
        else if (word == "front" || word == "side" || word == "top") {
            query.emplace_back("orient", "principal");
            if (word != "front") query.emplace_back("rotate", word == "side" ? "0,90,0" : "90,0,0");
        } else {
            query.emplace_back(isStyle(word) ? "style" : "color", word);
        }
    }
    if (!size.empty()) query.emplace_back("size", size);
    return query;
}

}  // namespace nacre::app
