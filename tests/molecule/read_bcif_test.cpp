#include <gtest/gtest.h>

#include <set>

#include "engine/molecule/formats/format_table.h"
#include "tests/molecule/bcif_writer.h"
#include "tests/molecule/expect_error.h"
#include "tests/molecule/same_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using namespace test;

/// Three coordinates columns of whole numbers, and others besides.
std::string atomSite(std::int64_t rows, const std::string& x, const std::vector<std::string>& others = {}) {
    const BcifIntegers zeros(static_cast<std::size_t>(rows), 0);
    std::vector<std::string> columns = {bcifColumn("Cartn_x", x), bcifColumn("Cartn_y", bcifPlain(zeros)),
                                        bcifColumn("Cartn_z", bcifPlain(zeros))};
    columns.insert(columns.end(), others.begin(), others.end());
    return bcifFile({bcifCategory("_atom_site", rows, columns)});
}

float readX(const std::string& file, std::size_t atom) {
    return readMolecule("a.bcif", file).atoms.at(atom).position.x;
}

TEST(ReadBcif, IsTheSameAsMmcif) {
    NACRE_NEEDS_DATA();
    const std::pair<const char*, const char*> kPairs[] = {{"1igy.bcif", "1igy.cif.gz"}, {"1l2y.bcif", "1l2y.cif.gz"}};
    for (const auto& [binary, text] : kPairs) {
        SCOPED_TRACE(binary);
        const Molecule a = readMoleculeFile(dataFile(binary)), b = readMoleculeFile(dataFile(text));
        expectSameAtoms(a, b);
        expectSameBonds(a, b);
        expectSameAssemblies(a, b);
        EXPECT_EQ(a.assemblies.size(), 1u);
        EXPECT_EQ(a.file.title, b.file.title);
        EXPECT_EQ(a.warnings, b.warnings);
    }
    ReadOptions options{.model = 17};
    expectSameAtoms(readMoleculeFile(dataFile("1l2y.bcif"), options),
                    readMoleculeFile(dataFile("1l2y.cif.gz"), options));
    options.model = 39;
    EXPECT_THROW(readMoleculeFile(dataFile("1l2y.bcif"), options), Error);
}

TEST(ReadBcif, IsMmcifInAnotherOrder) {
    NACRE_NEEDS_DATA();
    // The two files of 1J59 have the chains in different orders.
    const auto contents = [](const Molecule& molecule) {
        std::multiset<std::string> all;
        for (const Atom& atom : molecule.atoms) all.insert(described(molecule, atom));
        for (const Bond& bond : molecule.bonds) {
            const auto ends =
                std::minmax({described(molecule, molecule.atoms[bond.a]), described(molecule, molecule.atoms[bond.b])});
            all.insert(ends.first + " - " + ends.second + " x" + std::to_string(bond.order));
        }
        for (const Assembly& assembly : molecule.assemblies)
            for (const AssemblyPart& part : assembly.parts)
                for (const std::uint32_t subchain : part.subchains)
                    all.insert(assembly.id + ": " + molecule.subchains[subchain]);
        return all;
    };
    const auto a = contents(readMoleculeFile(dataFile("1j59.bcif.gz")));
    EXPECT_EQ(a, contents(readMoleculeFile(dataFile("1j59.cif.gz"))));
    EXPECT_EQ(a.size(), 4718u + 4639 + 14);  // atoms, bonds, subchains of the one assembly
}

TEST(ReadBcif, EveryEncodingOfNumbers) {
    EXPECT_EQ(readX(atomSite(2, bcifData("\x05\xff", {bcifByteArray(1)})), 1), -1.0f);
    EXPECT_EQ(readX(atomSite(2, bcifData("\x05\xff", {bcifByteArray(4)})), 1), 255.0f);
    EXPECT_EQ(readX(atomSite(1, bcifData("\xfe\xff", {bcifByteArray(2)})), 0), -2.0f);
    EXPECT_EQ(readX(atomSite(1, bcifData("\xfe\xff", {bcifByteArray(5)})), 0), 65534.0f);
    EXPECT_EQ(readX(atomSite(1, bcifData(littleEndian(70000, 4), {bcifByteArray(6)})), 0), 70000.0f);
    EXPECT_EQ(readX(atomSite(1, bcifData(littleEndian(0x3FC00000, 4), {bcifByteArray(32)})), 0), 1.5f);
    EXPECT_EQ(readX(atomSite(1, bcifData(littleEndian(0xC004000000000000, 8), {bcifByteArray(33)})), 0), -2.5f);
    EXPECT_EQ(readX(atomSite(3, bcifPackedDeltas({-1, 40000, -70000})), 1), 40000.0f);
    EXPECT_EQ(readX(atomSite(3, bcifPackedDeltas({-1, 40000, -70000})), 2), -70000.0f);
    EXPECT_EQ(readX(atomSite(4, bcifRuns({7, 7, 7, 9})), 2), 7.0f);
    EXPECT_EQ(readX(atomSite(2, bcifStrings(2, [](std::size_t i) { return i ? "-3.25" : "1"; })), 1), -3.25f);
    // Unsigned packing of 8 bits: 255 + 255 + 1, then 3.
    const auto packing = [](std::int64_t size) {
        return bcifEncoding(
            "IntegerPacking",
            {{"byteCount", packInteger(1)}, {"isUnsigned", packBoolean(true)}, {"srcSize", packInteger(size)}});
    };
    EXPECT_EQ(readX(atomSite(2, bcifData("\xff\xff\x01\x03", {packing(2), bcifByteArray(4)})), 0), 511.0f);
    EXPECT_EQ(readX(atomSite(2, bcifData("\xff\xff\x01\x03", {packing(2), bcifByteArray(4)})), 1), 3.0f);
    // Eleven steps from -1 to 1 are 0.2 apart.
    const std::string intervals = bcifEncoding(
        "IntervalQuantization", {{"min", packNumber(-1)}, {"max", packNumber(1)}, {"numSteps", packInteger(11)}});
    EXPECT_FLOAT_EQ(readX(atomSite(2, bcifData(std::string("\x00\x0a", 2), {intervals, bcifByteArray(4)})), 1), 1.0f);
    EXPECT_FLOAT_EQ(readX(atomSite(2, bcifData(std::string("\x00\x07", 2), {intervals, bcifByteArray(4)})), 1), 0.4f);
}

TEST(ReadBcif, MasksHideValues) {
    const std::string mask = bcifPlain({0, 1, 2});
    const Molecule molecule = readMolecule(
        "a.bcif", atomSite(3, bcifPlain({1, 2, 3}),
                           {bcifColumn("occupancy", bcifPlain({0, 0, 0}), mask),
                            bcifColumn("label_alt_id", bcifStrings(3, [](std::size_t) { return "B"; }), mask)}));
    EXPECT_EQ(molecule.atoms[0].occupancy, 0.0f);
    EXPECT_EQ(molecule.atoms[1].occupancy, 1.0f);
    EXPECT_EQ(molecule.atoms[2].occupancy, 1.0f);
    EXPECT_EQ(molecule.atoms[0].alternate, 'B');
    EXPECT_EQ(molecule.atoms[1].alternate, '\0');
}

TEST(ReadBcif, WhatIsWrong) {
    const auto wrong = [](const std::string& file, const char* part) { expectError("a.bcif", file, {part}); };
    wrong(packMap({{"dataBlocks", packInteger(1)}}), "no dataBlocks");
    wrong(bcifFile({}), "no atoms");
    wrong(atomSite(2, bcifPlain({1, 2, 3})), "column _atom_site.cartn_x: it does not have 2 values");
    wrong(atomSite(2, bcifPlain({1})), "it does not have 2 values");
    wrong(atomSite(1, bcifData("\x01\x02\x03", {bcifByteArray(3)})), "not a whole number");
    wrong(atomSite(1, bcifData(littleEndian(0x80000000, 4), {bcifByteArray(6)})), "exceeds 2147483647");
    wrong(atomSite(1, bcifData("\x01", {bcifByteArray(7)})), "type is out of range");
    wrong(atomSite(1, bcifData("\x01", {bcifEncoding("Zstd"), bcifByteArray(1)})), "unknown encoding");
    wrong(atomSite(1, bcifData("\x01", {bcifEncoding("Delta", {{"origin", packInteger(0)}})})), "not ByteArray");
    wrong(atomSite(1, bcifData("\x01", {})), "no encoding");
    wrong(atomSite(1, bcifData(littleEndian(0x7FC00000, 4), {bcifByteArray(32)})),
          "not a finite number within 1e9: 'nan'");
    wrong(atomSite(1, bcifData("\x01", {bcifEncoding("FixedPoint", {{"factor", packNumber(0)}}), bcifByteArray(1)})),
          "not a finite number within 1e9: 'inf'");
    const auto strings = [](const BcifIntegers& offsets, int index) {
        return bcifData(std::string(1, static_cast<char>(index)),
                        {bcifEncoding("StringArray", {{"dataEncoding", packArray({bcifByteArray(1)})},
                                                      {"stringData", packText("1234")},
                                                      {"offsetEncoding", packArray({bcifByteArray(3)})},
                                                      {"offsets", packBinary(int32Bytes(offsets))}})});
    };
    EXPECT_EQ(readX(atomSite(1, strings({0, 1, 4}, 1)), 0), 234.0f);
    wrong(atomSite(1, strings({0, 1, 5}, 0)), "offset of its strings is out of range");
    wrong(atomSite(1, strings({0, 3, 2}, 0)), "offset of its strings is out of range");
    wrong(atomSite(1, strings({-1, 3}, 0)), "offset of its strings is out of range");
    wrong(atomSite(1, strings({0, 4}, 1)), "a string that is not there");
    wrong(atomSite(1, strings({0, 4}, -2)), "a string that is not there");
    wrong(atomSite(1, strings({0, 4}, -1)), "not a finite number within 1e9: '?'");
    wrong(atomSite(1, strings({}, 0)), "a string that is not there");
}

TEST(ReadBcif, SizesOfHostileFilesAreNotBelieved) {
    const auto runs = [](std::int64_t value, std::int64_t count, std::int64_t size) {
        const std::string bytes = int32Bytes({static_cast<std::int32_t>(value), static_cast<std::int32_t>(count)});
        return bcifData(bytes, {bcifEncoding("RunLength", {{"srcSize", packInteger(size)}}), bcifByteArray(3)});
    };
    const auto site = [&](std::int64_t rows, const std::string& data) {
        return bcifFile(
            {bcifCategory("_atom_site", rows,
                          {bcifColumn("Cartn_x", data), bcifColumn("Cartn_y", data), bcifColumn("Cartn_z", data)})});
    };
    EXPECT_EQ(readMolecule("a.bcif", site(100, runs(1, 100, 100))).atoms.size(), 100u);
    expectError("a.bcif", site(2'000'000'000, runs(1, 2'000'000'000, 2'000'000'000)), {"rows of _atom_site"});
    expectError("a.bcif", site(-1, runs(1, 1, 1)), {"rows of _atom_site"});
    expectError("a.bcif", site(100, runs(1, 2'000'000'000, 2'000'000'000)), {"not have 100 values"});
    expectError("a.bcif", site(100, runs(1, 2'000'000'000, 100)), {"not have 100 values"});
    expectError("a.bcif", site(100, runs(1, -5, 100)), {"a negative one"});
    expectError("a.bcif", packMap({{"dataBlocks", "\xDD\xFF\xFF\xFF\xFF"}}), {"cut short"});
    expectError("a.bcif", packMap({{"dataBlocks", "\xC6\xFF\xFF\xFF\xFF"}}), {"cut short"});
    expectError("a.bcif", packMap({{"dataBlocks", std::string(1 << 20, '\x91')}}), {"cut short"});
    std::string deep(1 << 20, '\x91');
    expectError("a.bcif", packMap({{"dataBlocks", deep + '\xC0'}}), {"no categories"});
}

/// The whole capsid, written as BinaryCIF, reads back to the same atoms. What it takes is printed, and not judged:
/// the machine may be busy.
TEST(ReadBcif, AMillionAtoms) {
    NACRE_NEEDS_DATA();
    const Molecule capsid = readMoleculeFile(dataFile("3j6r-capsid-expanded.cif.gz"));
    ASSERT_EQ(capsid.atoms.size(), 1032840u);
    const std::string bytes = writeBcif(capsid);
    expectSameAtoms(formatRow(Format::bcif).readTables("capsid.bcif", bytes, {}, 0).front(), capsid);
    expectSameBonds(readMolecule("capsid.bcif", bytes), capsid);
}

}  // namespace
}  // namespace nacre
