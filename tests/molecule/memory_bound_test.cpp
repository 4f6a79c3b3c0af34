// How large a molecule may be, and that every reader keeps to it.

#include "engine/molecule/memory_bound.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/error.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

TEST(MemoryBound, EveryReaderStopsAtTheFirstAtomTooMany) {
    NACRE_NEEDS_DATA();
    std::ifstream in(*test::dataFolder() / "expected.json");
    const nlohmann::json files = nlohmann::json::parse(in)["files"];
    std::set<Format> formats;
    for (const auto& [file, expected] : files.items()) {
        if (file.starts_with("bad/") || !expected["atoms"].is_number() || expected["atoms"] > 6000) continue;
        const std::string path = test::dataFile(file);
        Molecule molecule;
        try {
            molecule = readMoleculeFile(path);
        } catch (const Error&) {
            continue;  // other tests say which are read
        }
        if (molecule.atoms.size() < 2) continue;
        if (const auto format = formatFromName(molecule.file.format)) formats.insert(*format);
        ReadOptions options{.maxAtoms = molecule.atoms.size()};
        EXPECT_EQ(readMoleculeFile(path, options).atoms.size(), molecule.atoms.size()) << file;
        --options.maxAtoms;
        try {
            readMoleculeFile(path, options);
            ADD_FAILURE() << file;
        } catch (const Error& error) {
            const std::string wanted =
                "more than " + std::to_string(options.maxAtoms) + " atoms, the most that the memory limit allows";
            EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
        }
    }
    EXPECT_GE(formats.size(), 10u);
}

TEST(MemoryBound, SplitsTheMemoryBetweenTextAndAtoms) {
    const ReadOptions options = readWithin(140'000'000);
    EXPECT_EQ(options.maxAtoms, 100'000u);
    EXPECT_EQ(options.maxBytes, 35'000'000u);
    EXPECT_EQ(readWithin(std::uint64_t{1} << 50).maxAtoms, kMaxAtoms);
    EXPECT_EQ(readWithin(std::uint64_t{1} << 50).maxBytes, ReadOptions{}.maxBytes);
}

}  // namespace
}  // namespace nacre
