#pragma once
// Finds the structures that the data-driven tests read: the folder in NACRE_DATA, else ../shared/data beside the tree.
// test_data.py does the same for Python.

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace nacre::test {

/// The data folder, if there is one. @throws std::runtime_error if NACRE_DATA names a folder without data
inline std::optional<std::filesystem::path> dataFolder() {
    const char* named = std::getenv("NACRE_DATA");
    const std::filesystem::path folder =
        named ? std::filesystem::path(named) : std::filesystem::path(NACRE_SOURCE_DIR) / "../shared/data";
    if (std::filesystem::exists(folder / "expected.json")) return folder;
    if (named) throw std::runtime_error("NACRE_DATA=" + folder.string() + " holds no test data");
    return std::nullopt;
}

/// Path of one data file. Use inside a test, behind NACRE_NEEDS_DATA().
inline std::string dataFile(const std::string& name) { return (*dataFolder() / name).string(); }

}  // namespace nacre::test

/// Skips the test, with the reason, where the data folder is absent.
#define NACRE_NEEDS_DATA()            \
    if (!::nacre::test::dataFolder()) \
    GTEST_SKIP() << "no test data: neither NACRE_DATA nor ../shared/data beside the source tree holds it"
