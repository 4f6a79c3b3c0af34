#pragma once
// What the tests with the fault layer share: the layer in force, a small picture, and what must hold after any fault.

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "engine/error.h"
#include "tests/fault_layer/faults.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {

/// What windows measure unless a test says otherwise. A frame of 1280 x 720, as large as SwiftShader's are by
/// themselves, takes it longer than all else.
inline void haveSmallWindows() { faults::setWindowSize(160, 120); }

/// Puts the layer above the validation layer, for this process and those that it starts.
inline const bool faultLayerInForce = [] {
    haveSmallWindows();
    setenv("VK_ADD_LAYER_PATH", NACRE_FAULT_LAYER_FOLDER, 1);
    setenv("VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_faults", 1);
    return true;
}();

/// NACRE_FAULTS_ALL=1: every call in turn, each in a run of its own (minutes); otherwise one from each place of the
/// program, all in one run.
inline bool everyCall() {
    const char* value = std::getenv("NACRE_FAULTS_ALL");
    return value && *value == '1';
}

/// Places of the program that calls came from.
inline std::size_t sites(const std::vector<faults::Call>& calls) {
    std::set<std::pair<std::string, std::uint64_t>> seen;
    for (const faults::Call& call : calls) seen.emplace(call.function, call.site);
    return seen.size();
}

/// One line of three parts: what, where, why.
inline void expectClear(const std::string& message) {
    EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos) << message;
    EXPECT_NE(message.find(": "), std::string::npos) << message;
    EXPECT_GT(message.size(), 15u) << message;
}

/// Everything that was made is gone, in order.
inline void expectNothingLeft() {
    for (const auto& [kind, count] : faults::alive()) ADD_FAILURE() << count << " x " << kind << " left";
    for (const std::string& message : faults::messages()) ADD_FAILURE() << message;
}

}  // namespace nacre::test
