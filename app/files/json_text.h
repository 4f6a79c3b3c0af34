#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/printable.h"
#include "engine/error.h"

namespace nacre::app {

/// JSON for files and terminals: two spaces per level, invalid UTF-8 as U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return printableJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

/// Maximum nesting depth of any JSON that is read: parsing, printing and destroying values recurse once per level.
constexpr int kDeepestJson = 64;

/// Whether a text is nested deeper. Reads only brackets and strings.
inline bool isTooDeep(std::string_view json) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString && c == '\\') ++i;
        if (c == '"') inString = !inString;
        if (inString) continue;
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > kDeepestJson) return true;
    }
    return false;
}

/// Parses a text. @returns a discarded value if it is not JSON, or too deep
template <typename Json>
Json parseJson(const std::string& text) {
    return isTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

/// As above. @param twice  receives a key that an object repeats, so that a value would be lost; else unchanged
/// @throws std::invalid_argument if it is too deep
template <typename Json>
Json parseJson(const std::string& text, std::string& twice) {
    if (isTooDeep(text))
        throw std::invalid_argument("it is nested more than " + std::to_string(kDeepestJson) + " levels deep");
    std::vector<std::set<std::string>> keys;  // per open object
    const auto watch = [&](int, typename Json::parse_event_t event, const Json& value) {
        if (event == Json::parse_event_t::object_start) keys.emplace_back();
        if (event == Json::parse_event_t::object_end) keys.pop_back();
        if (event != Json::parse_event_t::key) return true;
        const std::string key = value.template get<std::string>();
        if (!keys.back().insert(key).second) twice = key;
        return true;
    };
    return Json::parse(text, watch, false);
}

/// The content of a text file or pipe. @param task  beginning of an error, such as "cannot read colours"
inline std::string readTextFile(const std::string& task, const std::string& path, std::size_t mostBytes) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw Error(task, path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(task, path, "the file is missing or not readable");
    std::string text;
    char buffer[1 << 16];
    while (file.read(buffer, sizeof buffer) || file.gcount() > 0) {
        text.append(buffer, static_cast<std::size_t>(file.gcount()));
        if (text.size() > mostBytes)
            throw Error(task, path, "it is larger than the limit of " + std::to_string(mostBytes >> 20) + " MB");
    }
    return text;
}

/// Parses a file written by people. @param task  beginning of an error, such as "cannot read colours"
/// @throws Error with the line of a syntax error, or the number that is out of range, or if it is too deep
template <typename Json>
Json parseJsonText(const std::string& text, const std::string& task, const std::string& name) {
    if (isTooDeep(text))
        throw Error(task, name, "it is nested more than " + std::to_string(kDeepestJson) + " levels deep");
    try {
        return Json::parse(text);
    } catch (const typename Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw Error(task, name, "it is not valid JSON", 1 + std::count(text.begin(), end, '\n'));
    } catch (const typename Json::out_of_range& error) {  // its message has the number
        const std::string why = error.what();
        throw Error(task, name, "a number is too large: " + printable(why.substr(why.rfind(' ') + 1)));
    }
}

}  // namespace nacre::app
