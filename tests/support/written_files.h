#pragma once
// The built-in samples as files of every format, by several writers, as the build made them: see tests/written. They
// need no data folder.

#include <algorithm>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace nacre::test {

/// What is added to the coordinates of the samples where a unit cell surrounds them (_core.cif), Å.
inline constexpr glm::vec3 kMiddleOfCell{50, 50, 50};

#ifdef NACRE_WRITTEN_FILES

struct WrittenFile {
    std::string path;
    std::string name;    ///< "obabel/dna_core.cif": who wrote it, and what
    std::string sample;  ///< as sampleMolecule() takes it: "dna"
    /// Of its name: ".sdf", "_v3000.sdf", ".cif.gz"
    std::string kind;
};

/// All of one sample each, sorted; none where the build makes none.
inline std::vector<WrittenFile> writtenFiles() {
    std::vector<WrittenFile> files;
    const std::filesystem::path folder = NACRE_WRITTEN_FILES;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || entry.path().parent_path().filename() == "several") continue;
        const std::string leaf = entry.path().filename();
        const std::size_t end = leaf.find_first_of("._");
        files.push_back({entry.path(), entry.path().lexically_relative(folder), leaf.substr(0, end), leaf.substr(end)});
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return files;
}

/// Path of one of them, as in "obabel/dna.mol2".
inline std::string writtenFile(const std::string& name) { return std::string(NACRE_WRITTEN_FILES "/") + name; }

#endif

}  // namespace nacre::test

/// Skips the test where the build made no such files.
#define NACRE_NEEDS_WRITTEN_FILES()            \
    if (::nacre::test::writtenFiles().empty()) \
    GTEST_SKIP() << "a build for another machine makes no files of the samples"
