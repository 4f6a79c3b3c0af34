#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/shared/printable.h"

namespace nacre::app {

/// JSON as it is written, to files and terminals: two spaces a level, bytes that are no UTF-8 as U+FFFD.
inline std::string jsonText(const nlohmann::ordered_json& json) {
    return printableJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

}  // namespace nacre::app
