#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/files/printable.h"

namespace nacre::app {

/// JSON as it is written, to files and terminals: two spaces a level, bytes that are no UTF-8 as U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return printableJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

/// What a text says. @param twice  a key that an object has twice, of which a value would be lost; else untouched
/// @returns a discarded value if it is no JSON
template <typename Json>
Json parseJson(const std::string& text, std::string& twice) {
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
