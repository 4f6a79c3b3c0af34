#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/printable.h"

namespace nacre::app {

/// JSON as it is written, to files and terminals: two spaces a level, bytes that are no UTF-8 as U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return printableJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

/// How deep objects and arrays may stand in one another, in whatever JSON is read: what parses, prints or destroys
/// values goes down by a call per level.
constexpr int kDeepestJson = 64;

/// Whether a text is nested deeper than that. Looks at brackets and strings alone.
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

/// What a text says. @returns a discarded value if it is no JSON, or too deep
template <typename Json>
Json parseJson(const std::string& text) {
    return isTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

/// The same. @param twice  a key that an object has twice, of which a value would be lost; else untouched
/// @throws std::invalid_argument if it is too deep
template <typename Json>
Json parseJson(const std::string& text, std::string& twice) {
    if (isTooDeep(text))
        throw std::invalid_argument("it is nested more than " + std::to_string(kDeepestJson) + " levels deep");
    std::vector<std::set<std::string>> keys;  // of the objects that are open
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

}  // namespace nacre::app
