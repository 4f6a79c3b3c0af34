#pragma once
// tools/inspect, which reads captures by RenderDoc's own module and replays them.

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace nacre::test {

/// What it lists of a capture. @param more options of tools/inspect, for the shell
inline nlohmann::json inspect(const std::string& capture, const std::string& more = "") {
    const TemporaryFolder logs;
    const std::string command = "'" NACRE_SOURCE_DIR "/tools/inspect' '" + capture + "' --json " + more + " >'" +
                                (logs / "out") + "' 2>'" + (logs / "err") + "'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("tools/inspect: " + readContents(logs / "err"));
    return nlohmann::json::parse(readContents(logs / "out"));
}

/// The names of passes in a list of them, in order.
inline std::vector<std::string> listNames(const nlohmann::json& list) {
    std::vector<std::string> names;
    for (const nlohmann::json& one : list) names.push_back(one.value("name", one.value("kind", "")));
    return names;
}

}  // namespace nacre::test
