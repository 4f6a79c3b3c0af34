#include "engine/molecule/assemblies.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "engine/molecule/read.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

TransformRows shift(double x) { return {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0}; }
/// A quarter turn about z, then a shift along x.
TransformRows turn(double x) { return {0, -1, 0, x, 1, 0, 0, 0, 0, 0, 1, 0}; }

TransformsById operators() {
    TransformsById all{{"P", turn(0)}, {"X0", shift(1000)}, {"1-P", shift(7)}};
    for (int i = 1; i <= 60; ++i) all[std::to_string(i)] = shift(i);
    return all;
}

/// Where the transforms of an expression put the origin, along x.
std::vector<float> places(const std::string& expression) {
    AssemblyLimits limits(100);
    std::vector<float> found;
    for (const glm::mat4x3& m : expandOperators(expression, operators(), limits).transforms) found.push_back(m[3].x);
    return found;
}

TEST(Assemblies, OperatorExpressions) {
    EXPECT_EQ(places("1"), (std::vector<float>{1}));
    EXPECT_EQ(places("1,2,5-8"), (std::vector<float>{1, 2, 5, 6, 7, 8}));
    EXPECT_EQ(places(" (1, 2) "), (std::vector<float>{1, 2}));
    EXPECT_EQ(places("P"), (std::vector<float>{0}));
    EXPECT_EQ(places("1-P"), (std::vector<float>{7}));  // a name, not a range
    EXPECT_EQ(places("(X0)(1-3)"), (std::vector<float>{1001, 1002, 1003}));
    EXPECT_EQ(places("(10,20)(1-2)"), (std::vector<float>{11, 12, 21, 22}));
    EXPECT_EQ(places("(1)(2)(3-4)"), (std::vector<float>{6, 7}));
    EXPECT_EQ(places("(1-60)(1-60)").size(), 3600u);
}

TEST(Assemblies, TransformsHaveTheNamesOfTheirOperators) {
    const auto named = [](const std::string& expression, const TransformsById& all) {
        AssemblyLimits limits(100);
        return expandOperators(expression, all, limits).operators;
    };
    EXPECT_EQ(named("1-P,2", operators()), (std::vector<std::string>{"1-P", "2"}));
    EXPECT_EQ(named("(X0)(1-2)(P)", operators()), (std::vector<std::string>{"X0-1-P", "X0-2-P"}));
    const std::string longName(1'000'000, 'x');
    EXPECT_LT(named("(" + longName + ")(1)", {{longName, shift(1)}, {"1", shift(1)}})[0].size(), 1000u);
}

TEST(Assemblies, TheLastFactorIsAppliedFirst) {
    AssemblyLimits limits(100);
    const glm::vec4 origin(0, 0, 0, 1);
    // Shifted by 1 along x, then turned to y; or turned, then shifted.
    EXPECT_EQ(expandOperators("(P)(1)", operators(), limits).transforms[0] * origin, glm::vec3(0, 1, 0));
    EXPECT_EQ(expandOperators("(1)(P)", operators(), limits).transforms[0] * origin, glm::vec3(1, 0, 0));
    EXPECT_EQ(toMatrix(multiply(turn(5), shift(1))) * glm::vec4(1, 0, 2, 1), glm::vec3(5, 2, 2));
}

TEST(Assemblies, MalformedAndHostileExpressions) {
    for (const char* expression :
         {"", "()", "(1", "1)", "(1)2", "1,,2", "5-2", "61", "(1-60)(61-88)", "-1", "1-", "(1)(", "1-99999999999"}) {
        AssemblyLimits limits(100);
        EXPECT_THROW(expandOperators(expression, operators(), limits), AssemblyFault) << expression;
    }
    AssemblyLimits limits(100);
    EXPECT_THROW(expandOperators("(1-60)(1-60)(1-60)(1-60)(1-60)(1-60)(1-60)(1-60)", operators(), limits),
                 AssemblyFault);
    EXPECT_THROW(toMatrix(shift(HUGE_VAL)), AssemblyFault);
    EXPECT_THROW(toMatrix(shift(NAN)), AssemblyFault);
    EXPECT_THROW(limits.spend(0, AssemblyLimits::kMaxSubchains + 1), AssemblyFault);
}

TEST(Assemblies, AsManyTransformsAsThereIsMemoryFor) {
    AssemblyLimits few(10), many(1'000'000), most(SIZE_MAX);
    EXPECT_NO_THROW(few.spend(AssemblyLimits::kFewTransforms, 0));  // files of real assemblies
    EXPECT_THROW(few.spend(1, 0), AssemblyFault);
    EXPECT_NO_THROW(many.spend(1'000'000, 0));
    EXPECT_THROW(many.spend(1, 0), AssemblyFault);
    EXPECT_THROW(most.spend(AssemblyLimits::kMaxTransforms + 1, 0), AssemblyFault);
}

TEST(Assemblies, PartsAreJoined) {
    Assembly assembly;
    addPart(assembly, {{toMatrix(shift(1))}, {2, 0, 2}, {"a"}});
    addPart(assembly, {{toMatrix(shift(2))}, {0, 2}, {"b"}});
    addPart(assembly, {{toMatrix(shift(3))}, {1}});
    addPart(assembly, {{}, {1}});
    addPart(assembly, {{toMatrix(shift(3))}, {}});
    ASSERT_EQ(assembly.parts.size(), 2u);
    EXPECT_EQ(assembly.parts[0].subchains, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(assembly.parts[0].transforms.size(), 2u);
    EXPECT_EQ(assembly.parts[0].operators, (std::vector<std::string>{"a", "b"}));
}

std::string mmcif(const std::string& generators) {
    return "data_x\nloop_\n_pdbx_struct_assembly.id\n_pdbx_struct_assembly.details\n1 'one of them'\n2 .\n"
           "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
           "_pdbx_struct_assembly_gen.asym_id_list\n" +
           generators +
           "loop_\n_pdbx_struct_oper_list.id\n_pdbx_struct_oper_list.matrix[1][1]\n_pdbx_struct_oper_list.matrix[1][2]"
           "\n"
           "_pdbx_struct_oper_list.matrix[1][3]\n_pdbx_struct_oper_list.vector[1]\n_pdbx_struct_oper_list.matrix[2][1]"
           "\n"
           "_pdbx_struct_oper_list.matrix[2][2]\n_pdbx_struct_oper_list.matrix[2][3]\n_pdbx_struct_oper_list.vector[2]"
           "\n"
           "_pdbx_struct_oper_list.matrix[3][1]\n_pdbx_struct_oper_list.matrix[3][2]\n_pdbx_struct_oper_list.matrix[3]["
           "3]\n"
           "_pdbx_struct_oper_list.vector[3]\na 1 0 0 5 0 1 0 6 0 0 1 7\nb 1 0 0 ? 0 1 0 0 0 0 1 0\n"
           "loop_\n_atom_site.type_symbol\n_atom_site.label_asym_id\n_atom_site.auth_asym_id\n_atom_site.Cartn_x\n_"
           "atom_site.Cartn_y\n"
           "_atom_site.Cartn_z\nC A X 0 0 0\nC B X 5 0 0\nC C Y 9 0 0\n";
}

TEST(Assemblies, OfMmcif) {
    const Molecule m = readMolecule("a.cif", mmcif("1 a A,C\n2 a 'B, C,Q'\n2 a A\n3 a A\n"));
    EXPECT_EQ(m.subchains, (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_EQ(m.chains.size(), 2u);
    ASSERT_EQ(m.assemblies.size(), 2u);
    EXPECT_EQ(m.assemblies[0].id, "1");
    EXPECT_EQ(m.assemblies[0].details, "one of them");
    EXPECT_EQ(m.assemblies[0].parts.at(0).subchains, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(m.assemblies[0].parts.at(0).transforms.at(0)[3], glm::vec3(5, 6, 7));
    ASSERT_EQ(m.assemblies[1].parts.size(), 2u);
    EXPECT_EQ(m.assemblies[1].parts[0].subchains, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_TRUE(m.warnings.empty());
}

TEST(Assemblies, WhatCannotBeReadIsLeftOutWithAWarning) {
    const std::pair<const char*, const char*> kCases[] = {
        {"1 a A\n2 c A\n", "no operator 'c'"},
        {"1 a A\n2 b A\n", "missing or too large"},
        {"1 a A\n2 (a A\n", "malformed: '(a'"},
        {"1 a A\n2 a Q\n", "does not say how to place any of its chains"},
        {"1 a A\n", "does not say how to place any of its chains"}};
    for (const auto& [generators, why] : kCases) {
        const Molecule m = readMolecule("a.cif", mmcif(generators));
        EXPECT_EQ(m.assemblies.size(), 1u);
        ASSERT_EQ(m.warnings.size(), 1u) << generators;
        EXPECT_NE(m.warnings[0].find("assembly 2 is left out"), std::string::npos) << m.warnings[0];
        EXPECT_NE(m.warnings[0].find(why), std::string::npos) << m.warnings[0];
    }
}

std::string pdb(const std::string& remarks) {
    const std::string atoms =
        "ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79           N\n"
        "ATOM      2  N   THR B   1      27.047  14.099   3.625  1.00 13.79           N\n";
    return remarks + atoms;
}
const std::string kRow1 = "REMARK 350   BIOMT1   1 -1.000000  0.000000  0.000000       30.00000\n";
const std::string kRow2 = "REMARK 350   BIOMT2   1  0.000000 -1.000000  0.000000      -20.00000\n";
const std::string kRow3 = "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        1.50000\n";

TEST(Assemblies, OfRemark350) {
    const Molecule m = readMolecule(
        "a.pdb",
        pdb("REMARK 350 BIOMOLECULE: 1\nREMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: DIMERIC\n"
            "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\nREMARK 350                    AND CHAINS: B\n" +
            kRow1 + kRow2 + kRow3 + "REMARK 350 BIOMOLECULE: 2\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n" + kRow1 +
            kRow2 + kRow3 + "REMARK 350 APPLY THE FOLLOWING TO CHAINS: NULL\n" + kRow1 + kRow2 + kRow3));
    ASSERT_EQ(m.assemblies.size(), 2u);
    EXPECT_EQ(m.assemblies[0].id, "1");
    EXPECT_EQ(m.assemblies[0].details, "DIMERIC");
    ASSERT_EQ(m.assemblies[0].parts.size(), 1u);
    EXPECT_EQ(m.assemblies[0].parts[0].subchains, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(m.assemblies[0].parts[0].transforms.at(0) * glm::vec4(1, 2, 3, 1), glm::vec3(29, -22, 4.5f));
    ASSERT_EQ(m.assemblies[1].parts.size(), 2u);
    EXPECT_EQ(m.assemblies[1].parts[0].subchains, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(m.assemblies[1].parts[1].subchains, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(m.assemblies[1].parts[1].operators, std::vector<std::string>{"3"});
    EXPECT_EQ(m.file.biomtOperators, 3);
}

TEST(Assemblies, DamagedRemark350) {
    for (const std::string& rows :
         {kRow1 + kRow3, kRow2 + kRow1 + kRow3, kRow1 + kRow2 + "REMARK 350   BIOMT3   1  0.0 x\n",
          std::string("REMARK 350 APPLY THE FOLLOWING TO CHAINS: Q\n") + kRow1 + kRow2 + kRow3}) {
        const Molecule m = readMolecule("a.pdb", pdb("REMARK 350 BIOMOLECULE: 1\n" + rows));
        EXPECT_TRUE(m.assemblies.empty());
        ASSERT_EQ(m.warnings.size(), 1u) << rows;
        EXPECT_EQ(m.warnings[0].find("assembly 1 is left out"), 0u) << m.warnings[0];
    }
    EXPECT_EQ(readMolecule("a.pdb", pdb(kRow1 + kRow2 + kRow3)).assemblies.at(0).id, "1");
}

/// Largest distance between the atoms of copies that another program wrote and those that the transforms make.
float worst(const Molecule& copies, const Molecule& unit, const std::vector<glm::mat4x3>& transforms,
            std::size_t count) {
    float distance = 0;
    for (std::size_t c = 0; c < count; ++c)
        for (std::size_t i = 0; i < unit.atoms.size(); ++i) {
            const glm::vec3 made = transforms[c] * glm::vec4(unit.atoms[i].position, 1);
            distance = std::max(distance, glm::distance(made, copies.atoms[c * unit.atoms.size() + i].position));
        }
    return distance;
}

TEST(Assemblies, OfPdbMakeTheWholeCapsid) {
    NACRE_NEEDS_DATA();
    const Molecule unit = readMoleculeFile(test::dataFile("3j6r-hpv16.pdb.gz"));
    const Molecule copies = readMoleculeFile(test::dataFile("3j6r-capsid-expanded.cif.gz"));
    ASSERT_EQ(unit.assemblies.size(), 1u);
    ASSERT_EQ(unit.assemblies[0].parts.size(), 1u);
    EXPECT_EQ(unit.assemblies[0].parts[0].subchains.size(), 6u);
    const auto& transforms = unit.assemblies[0].parts[0].transforms;
    ASSERT_EQ(transforms.size(), 60u);
    ASSERT_EQ(copies.atoms.size(), 60 * unit.atoms.size());
    EXPECT_LT(worst(copies, unit, transforms, 60), 1e-3f);
}

TEST(Assemblies, OfMmcifMakeTheHalfCapsid) {
    NACRE_NEEDS_DATA();
    const Molecule unit = readMoleculeFile(test::dataFile("1f2n-virus.cif.gz"));
    const Molecule half = readMoleculeFile(test::dataFile("1f2n-halfcapsid-hybrid36.pdb.gz"));
    ASSERT_EQ(unit.assemblies.size(), 6u);
    const std::size_t kTransforms[] = {60, 1, 5, 6, 1, 60};
    for (std::size_t i = 0; i < 6; ++i) {
        ASSERT_EQ(unit.assemblies[i].parts.size(), 1u);
        EXPECT_EQ(unit.assemblies[i].parts[0].transforms.size(), kTransforms[i]);
        EXPECT_EQ(unit.assemblies[i].parts[0].subchains.size(), 9u);
    }
    ASSERT_EQ(half.atoms.size(), 30 * unit.atoms.size());
    EXPECT_LT(worst(half, unit, unit.assemblies[0].parts[0].transforms, 30), 2e-3f);
    EXPECT_EQ(unit.assemblies[3].details, "icosahedral 23 hexamer");
}

TEST(Assemblies, OfOtherFiles) {
    NACRE_NEEDS_DATA();
    const Molecule tetramer = readMoleculeFile(test::dataFile("1stp-v5.cif"));
    ASSERT_EQ(tetramer.assemblies.size(), 1u);
    EXPECT_EQ(tetramer.assemblies[0].parts.at(0).transforms.size(), 4u);
    EXPECT_EQ(readMoleculeFile(test::dataFile("1pfe.mmjson.json")).assemblies.size(), 1u);
    EXPECT_EQ(readMoleculeFile(test::dataFile("3pqr.pdb")).assemblies.size(), 2u);
    EXPECT_EQ(readMoleculeFile(test::dataFile("3pqr.cif")).assemblies.size(), 2u);
    EXPECT_TRUE(readMoleculeFile(test::dataFile("1hpv.pdb")).assemblies.empty());
}

}  // namespace
}  // namespace nacre
