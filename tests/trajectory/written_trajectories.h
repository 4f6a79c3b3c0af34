#pragma once
// Trajectories that MDTraj wrote, and what it read of them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "engine/molecule/read.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {

/// The folder of what MDTraj wrote, once for all tests.
inline const TemporaryFolder& written() {
    static const TemporaryFolder folder;
    static const int code = std::system(
        ("/usr/bin/python3 '" NACRE_SOURCE_DIR "/tests/written/write_trajectories.py' '" + folder.path() + "' 2>&1")
            .c_str());
    EXPECT_EQ(code, 0) << "MDTraj (Debian's python3-mdtraj) is missing or failed";
    return folder;
}

inline std::vector<float> readNumbers(const std::string& name) {
    const std::string bytes = readContents(written() / (name + ".bin"));
    std::vector<float> numbers(bytes.size() / 4);
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * 4);
    return numbers;
}

inline Molecule chains() { return readMoleculeFile(written() / "t.xyz"); }

}  // namespace nacre::test
