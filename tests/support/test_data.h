#pragma once
// Finds the structures that the data-driven tests read: the folder in NACRE_DATA, else ../shared/data beside the tree.
// test_data.py does the same for Python.

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace nacre::test {

/// The data folder, if there is one. It may have only some of the files. @throws std::runtime_error if NACRE_DATA names
/// a folder without any
inline std::optional<std::filesystem::path> dataFolder() {
    const char* named = std::getenv("NACRE_DATA");
    const std::filesystem::path folder =
        named ? std::filesystem::path(named) : std::filesystem::path(NACRE_SOURCE_DIR) / "../shared/data";
    if (std::filesystem::exists(folder / "expected.json")) return folder;
    if (!named) return std::nullopt;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.is_regular_file()) return folder;
    throw std::runtime_error("NACRE_DATA=" + folder.string() + " holds no test data");
}

/// Path of one data file. Use inside a test, behind NACRE_NEEDS_DATA().
inline std::string dataFile(const std::string& name) { return (*dataFolder() / name).string(); }

/// Says which of the files is absent; empty: none. No names: all files of the folder, which expected.json lists.
/// "sample:dna" is no file.
inline std::string describeMissingData(std::vector<std::string> names) {
    const std::optional<std::filesystem::path> folder = dataFolder();
    if (names.empty()) names.emplace_back("expected.json");
    for (const std::string& name : names) {
        if (name.rfind("sample:", 0) == 0) continue;
        if (!folder) return "no test data: neither NACRE_DATA nor ../shared/data beside the source tree holds it";
        if (!std::filesystem::exists(*folder / name)) return "the test data lack " + (*folder / name).string();
    }
    return {};
}

}  // namespace nacre::test

/// Skips the test, with the reason, where a file that it names is absent; where it names none, if any may be.
#define NACRE_NEEDS_DATA(...)                                                                                      \
    if (const std::string missing_data = ::nacre::test::describeMissingData({__VA_ARGS__}); !missing_data.empty()) \
    GTEST_SKIP() << missing_data
