#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "tests/molecule/expect_error.h"
#include "tests/molecule/msgpack_writer.h"
#include "tests/molecule/same_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using namespace test;
using Fields = std::vector<std::pair<std::string, std::string>>;

std::string encoded(int codec, int size, int parameter, const std::string& data) {
    return packBinary(bigEndian(static_cast<std::uint32_t>(codec), 4) + bigEndian(static_cast<std::uint32_t>(size), 4) +
                      bigEndian(static_cast<std::uint32_t>(parameter), 4) + data);
}
std::string words(std::initializer_list<int> values, int bytes) {
    std::string data;
    for (const int value : values) data += bigEndian(static_cast<std::uint32_t>(value), bytes);
    return data;
}
std::string integers(std::initializer_list<int> values) {
    return encoded(4, static_cast<int>(values.size()), 0, words(values, 4));
}
std::string list(std::initializer_list<int> values) {
    std::vector<std::string> elements;
    for (const int value : values) elements.push_back(packInteger(value));
    return packArray(elements);
}
std::string texts(std::initializer_list<const char*> values) {
    std::vector<std::string> elements;
    for (const char* value : values) elements.push_back(packText(value));
    return packArray(elements);
}

std::string group(const std::string& bondAtoms = list({0, 1}), const std::string& bondOrders = list({2})) {
    return packMap({{"groupName", packText("CMO")},
                    {"atomNameList", texts({"C", "O"})},
                    {"elementList", texts({"C", "O"})},
                    {"formalChargeList", list({-1, 1})},
                    {"bondAtomList", bondAtoms},
                    {"bondOrderList", bondOrders}});
}

/// Two carbon monoxides in two chains of one author, bonded to each other; one assembly of two copies of the second.
Fields twoResidues() {
    const std::string half = bigEndian(0x3F000000, 4);
    const std::string shift = list({1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    const std::string unity = list({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    const auto transform = [](const std::string& matrix) {
        return packMap({{"chainIndexList", list({1})}, {"matrix", matrix}});
    };
    return {{"mmtfVersion", packText("1.0.0")},
            {"title", packText("gas")},
            {"numAtoms", packInteger(4)},
            {"numGroups", packInteger(2)},
            {"numChains", packInteger(2)},
            {"numModels", packInteger(1)},
            {"groupsPerChain", list({1, 1})},
            {"chainsPerModel", list({2})},
            {"chainIdList", encoded(5, 2, 4, std::string("A\0\0\0B\0\0\0", 8))},
            {"chainNameList", encoded(5, 2, 4, std::string("X\0\0\0X\0\0\0", 8))},
            {"groupList", packArray({group()})},
            {"groupTypeList", integers({0, 0})},
            {"groupIdList", encoded(8, 2, 0, words({-3, 1, 5, 1}, 4))},
            {"insCodeList", encoded(6, 2, 0, words({0, 1, 'C', 1}, 4))},
            {"altLocList", encoded(6, 4, 0, words({0, 2, 'A', 2}, 4))},
            {"xCoordList", encoded(10, 4, 1000, words({32767, 1000, 500, -32768, -1, 3}, 2))},
            {"yCoordList", encoded(1, 4, 0, half + half + half + half)},
            {"zCoordList", encoded(9, 4, 100, words({250, 4}, 4))},
            {"occupancyList", encoded(11, 4, 4, words({4, 2, 1, 0}, 2))},
            {"bFactorList", encoded(13, 4, 10, "\x7f\x01\x02\x03\x04")},
            {"bondAtomList", integers({0, 2})},
            {"bondOrderList", encoded(2, 1, 0, "\x03")},
            {"bioAssemblyList",
             packArray({packMap(
                 {{"name", packText("dimer")}, {"transformList", packArray({transform(unity), transform(shift)})}})})}};
}

/// The same with one field replaced, or left out.
std::string with(const std::string& field, const std::string& value) {
    Fields fields = twoResidues();
    for (auto& [name, content] : fields)
        if (name == field) content = value;
    return packMap(fields);
}
std::string without(const std::string& field) {
    Fields fields = twoResidues();
    fields.erase(std::remove_if(fields.begin(), fields.end(), [&](const auto& pair) { return pair.first == field; }),
                 fields.end());
    return packMap(fields);
}

TEST(ReadMmtf, EveryField) {
    const Molecule m = readMolecule("a", packMap(twoResidues()));
    ASSERT_EQ(m.atoms.size(), 4u);
    EXPECT_EQ(m.file.format, "mmtf");
    EXPECT_EQ(m.file.title, "gas");
    EXPECT_EQ(m.atoms[0].position, glm::vec3(33.767f, 0.5f, 2.5f));
    EXPECT_EQ(m.atoms[1].position.x, 34.267f);
    EXPECT_EQ(m.atoms[2].position.x, 1.498f);
    EXPECT_EQ(m.atoms[3].position.x, 1.501f);
    EXPECT_EQ(m.atoms[1].occupancy, 0.5f);
    EXPECT_EQ(m.atoms[0].temperatureFactor, 12.8f);  // 127 + 1 tenths
    EXPECT_EQ(m.atoms[3].temperatureFactor, 0.4f);
    EXPECT_EQ(m.atoms[0].charge, -1);
    EXPECT_EQ(m.atoms[1].name.view(), "O");
    EXPECT_EQ(m.atoms[1].element, 8);
    EXPECT_TRUE(m.atoms[1].hetero);
    EXPECT_EQ(m.atoms[1].alternate, '\0');
    EXPECT_EQ(m.atoms[2].alternate, 'A');
    ASSERT_EQ(m.residues.size(), 2u);
    EXPECT_EQ(m.residues[0].number, -3);
    EXPECT_EQ(m.residues[1].number, 2);
    EXPECT_EQ(m.residues[1].insertionCode, 'C');
    EXPECT_EQ(m.residues[1].name.view(), "CMO");
    ASSERT_EQ(m.chains.size(), 1u);
    EXPECT_EQ(m.chains[0].name, "X");
    EXPECT_EQ(m.subchains, (std::vector<std::string>{"A", "B"}));
    ASSERT_EQ(m.bonds.size(), 3u);
    EXPECT_EQ(m.bonds[0].order, 2);  // 0-1, 0-2, 2-3
    EXPECT_EQ(m.bonds[1].b, 2u);
    EXPECT_EQ(m.bonds[1].order, 3);
    ASSERT_EQ(m.assemblies.size(), 1u);
    EXPECT_EQ(m.assemblies[0].id, "dimer");
    ASSERT_EQ(m.assemblies[0].parts.size(), 1u);
    EXPECT_EQ(m.assemblies[0].parts[0].subchains, std::vector<std::uint32_t>{1});
    ASSERT_EQ(m.assemblies[0].parts[0].transforms.size(), 2u);
    EXPECT_EQ(m.assemblies[0].parts[0].transforms[1] * glm::vec4(1, 2, 3, 1), glm::vec3(11, 2, 3));
    EXPECT_TRUE(m.warnings.empty());
}

TEST(ReadMmtf, OptionalFields) {
    for (const char* field : {"insCodeList", "altLocList", "occupancyList", "bFactorList", "chainNameList", "title",
                              "bondOrderList", "bondAtomList", "bioAssemblyList"}) {
        SCOPED_TRACE(field);
        EXPECT_EQ(readMolecule("a", without(field)).atoms.size(), 4u);
    }
    EXPECT_EQ(readMolecule("a", without("chainNameList")).chains.size(), 2u);
    for (const char* field :
         {"mmtfVersion", "numAtoms", "numGroups", "numChains", "numModels", "groupsPerChain", "chainsPerModel",
          "chainIdList", "groupList", "groupTypeList", "groupIdList", "xCoordList", "yCoordList", "zCoordList"}) {
        SCOPED_TRACE(field);
        expectError("a.mmtf", without(field), {"cannot read molecule"});
    }
}

TEST(ReadMmtf, WhatIsWrong) {
    const auto wrong = [](const char* field, const std::string& value, const char* part) {
        SCOPED_TRACE(field);
        expectError("a.mmtf", with(field, value), {part});
    };
    wrong("mmtfVersion", packText("2.0"), "version '2.0' is not supported");
    wrong("numAtoms", packInteger(5), "announces 4 values instead of 5");
    wrong("numAtoms", packInteger(2'000'000'000), "numAtoms is missing or impossible");
    wrong("numAtoms", packInteger(-4), "numAtoms is missing or impossible");
    wrong("numAtoms", packInteger(0), "no atoms");
    wrong("groupsPerChain", list({1, 2}), "impossible value");
    wrong("groupsPerChain", list({1, 0}), "does not add up");
    wrong("groupsPerChain", list({2}), "stated length");
    wrong("groupTypeList", integers({0, 1}), "a group that is not there");
    wrong("groupTypeList", integers({0, -1}), "a group that is not there");
    wrong("groupList", packArray({group(list({0, 2}))}), "a bond to an atom that is not there");
    wrong("groupList", packArray({group(list({0, 0}))}), "a bond to an atom that is not there");
    wrong("groupList", packArray({group(list({0, 1, 1}))}), "lists of bonds differ");
    wrong("groupList", packArray({packMap({})}), "its groups have 0 atoms instead of numAtoms");
    wrong("bondAtomList", integers({0, 4}), "bondAtomList refers to an atom");
    wrong("bondAtomList", integers({0, 1, 2}), "impossible number");
    wrong("xCoordList", encoded(10, 4, 1000, words({1, 2, 3}, 2)), "xCoordList: it does not have 4 values");
    wrong("xCoordList", encoded(10, 4, 0, words({1, 2, 3, 4}, 2)), "x of atom 1 is not a finite number");
    wrong("yCoordList", encoded(1, 4, 0, words({0x7FC00000, 0, 0, 0}, 4)), "y of atom 1 is not a finite number");
    wrong("zCoordList", encoded(9, 4, 1, words({1, 2'000'000'000}, 4)), "not have 4 values");
    wrong("zCoordList", encoded(99, 4, 1, ""), "codec 99 is unknown");
    wrong("chainIdList", encoded(5, 2, 4, "A"), "chainIdList is not an array of 2 names");
    expectError("a.mmtf", packMap(twoResidues()), {"no model 2; the file has 1"}, {.model = 2});
}

TEST(ReadMmtf, DamagedAssembliesAreLeftOut) {
    const auto assembly = [](const std::string& chains, const std::string& matrix) {
        const std::string transform = packMap({{"chainIndexList", chains}, {"matrix", matrix}});
        return packArray({packMap({{"name", packText("x")}, {"transformList", packArray({transform})}})});
    };
    const std::string unity = list({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    for (const std::string& damaged : {assembly(list({2}), unity), assembly(list({-1}), unity),
                                       assembly(list({0}), list({1, 2, 3})), assembly(list({}), unity)}) {
        const Molecule m = readMolecule("a", with("bioAssemblyList", damaged));
        EXPECT_TRUE(m.assemblies.empty());
        ASSERT_EQ(m.warnings.size(), 1u);
        EXPECT_EQ(m.warnings[0].find("assembly x is left out"), 0u) << m.warnings[0];
    }
}

TEST(ReadMmtf, AgreesWithMmcif) {
    NACRE_NEEDS_DATA();
    const std::pair<const char*, const char*> kPairs[] = {
        {"1bna.mmtf", "1bna.cif"}, {"1crn.mmtf", "1crn.cif"}, {"1en2.mmtf", "1en2.cif"}, {"4hhb.mmtf", "4hhb.cif.gz"}};
    // MMTF may have the atoms of a residue in another order, and alternate residues one after the other.
    const auto contents = [](const Molecule& molecule) {
        std::multiset<std::string> all;
        for (const Atom& atom : molecule.atoms) all.insert(described(molecule, atom));
        return all;
    };
    for (const auto& [mmtf, text] : kPairs) {
        SCOPED_TRACE(mmtf);
        Molecule a = readMoleculeFile(dataFile(mmtf)), b = readMoleculeFile(dataFile(text));
        for (Atom& atom : a.atoms) atom.charge = 0;  // MMTF's are those of the dictionary
        for (Atom& atom : b.atoms) atom.charge = 0;
        if (std::string(mmtf) == "4hhb.mmtf") {  // the two are of different years, and name the ligands differently
            EXPECT_EQ(a.subchains.size(), b.subchains.size());
            for (std::string& name : a.subchains) name.clear();
            for (std::string& name : b.subchains) name.clear();
        }
        EXPECT_EQ(contents(a), contents(b));
        expectSameAssemblies(a, b);
        EXPECT_EQ(a.assemblies.size(), 1u);
    }
}

TEST(ReadMmtf, AssembliesAndModels) {
    NACRE_NEEDS_DATA();
    const Molecule virus = readMoleculeFile(dataFile("1auy-virus.mmtf"));
    ASSERT_EQ(virus.assemblies.size(), 4u);
    EXPECT_EQ(virus.assemblies[0].parts.at(0).transforms.size(), 60u);
    EXPECT_EQ(virus.assemblies[0].parts.at(0).subchains.size(), 3u);
    EXPECT_EQ(readMoleculeFile(dataFile("4opj.mmtf")).assemblies.size(), 2u);
    ReadOptions options;
    const Molecule first = readMoleculeFile(dataFile("1msh-nmr30.mmtf"));
    options.model = 30;
    const Molecule last = readMoleculeFile(dataFile("1msh-nmr30.mmtf"), options);
    EXPECT_NE(first.atoms[0].position, last.atoms[0].position);
    for (const Bond& bond : last.bonds)
        EXPECT_LT(glm::distance(last.atoms[bond.a].position, last.atoms[bond.b].position), 2.3f);
}

}  // namespace
}  // namespace nacre
