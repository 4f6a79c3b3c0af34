#include <gtest/gtest.h>

#include "tests/molecule/expect_error.h"

namespace nacre {
namespace {

std::string cml(const std::string& inside) { return "<?xml version=\"1.0\"?>\n<cml>\n" + inside + "</cml>\n"; }

const std::string kTwoAtoms =
    "<atomArray><atom id=\"a\" elementType=\"C\" x3=\"0\" y3=\"0\" z3=\"0\"/>"
    "<atom id=\"b\" elementType=\"N\" x3=\"1\" y3=\"0.5\" z3=\"-1\" formalCharge=\"-1\"/>"
    "<atom id=\"c\" elementType=\"O\" x3=\"2\" y3=\"0\" z3=\"0\"/></atomArray>";

TEST(ReadCml, AtomsBondsAndTitle) {
    const Molecule molecule =
        readMolecule("a", cml("<molecule title=\"T &amp; U\"><bondArray><bond atomRefs2=\"a b\" order=\"A\"/>"
                              "<bond atomRefs2=\"c b\" order=\"2\"/></bondArray>" +
                              kTwoAtoms + "</molecule>"));
    EXPECT_EQ(molecule.file.format, "cml");
    EXPECT_EQ(molecule.file.title, "T & U");
    EXPECT_EQ(molecule.file.records, 1);
    EXPECT_EQ(molecule.file.bonds, 2);
    ASSERT_EQ(molecule.atoms.size(), 3u);
    EXPECT_EQ(molecule.atoms[1].element, 7);
    EXPECT_EQ(molecule.atoms[1].charge, -1);
    EXPECT_EQ(molecule.atoms[1].position, glm::vec3(1, 0.5f, -1));
    ASSERT_EQ(molecule.bonds.size(), 2u);
    EXPECT_EQ(molecule.bonds[0].order, 4);
    EXPECT_EQ(molecule.bonds[1].order, 2);
    EXPECT_TRUE(molecule.warnings.empty());
}

TEST(ReadCml, Orders) {
    const auto order = [](const std::string& attribute) {
        const Molecule molecule =
            readMolecule("a", cml("<molecule>" + kTwoAtoms + "<bondArray><bond atomRefs2=\"a b\" " + attribute +
                                  "/></bondArray></molecule>"));
        return molecule.warnings.empty() ? int(molecule.bonds[0].order) : -1;
    };
    EXPECT_EQ(order(""), 1);
    EXPECT_EQ(order("order=\"1\""), 1);
    EXPECT_EQ(order("order=\"S\""), 1);
    EXPECT_EQ(order("order=\"2\""), 2);
    EXPECT_EQ(order("order=\"D\""), 2);
    EXPECT_EQ(order("order=\"3\""), 3);
    EXPECT_EQ(order("order=\"T\""), 3);
    EXPECT_EQ(order("order=\"A\""), 4);
    EXPECT_EQ(order("order=\"odd\""), -1);  // single, with a warning
}

TEST(ReadCml, SeveralMoleculesStandTogether) {
    // Ids are each molecule's own; a molecule inside another is part of it.
    const std::string bond = "<bondArray><bond atomRefs2=\"a c\" order=\"1\"/></bondArray>";
    const std::string inner =
        "<molecule><atomArray><atom id=\"d\" elementType=\"H\" x2=\"5\" y2=\"6\"/></atomArray></molecule>";
    const Molecule molecule =
        readMolecule("a", cml("<molecule><name>first</name>" + kTwoAtoms + bond + "</molecule><molecule>" + inner +
                              kTwoAtoms + bond + "</molecule>"));
    EXPECT_EQ(molecule.file.records, 3);
    EXPECT_EQ(molecule.file.title, "first");
    EXPECT_EQ(molecule.atoms.size(), 7u);
    ASSERT_EQ(molecule.residues.size(), 2u);
    EXPECT_EQ(molecule.residues[1].atomCount, 4u);
    ASSERT_EQ(molecule.bonds.size(), 2u);
    EXPECT_EQ(molecule.bonds[1].a, 4u);
    EXPECT_EQ(molecule.bonds[1].b, 6u);
    ASSERT_EQ(molecule.warnings.size(), 1u);
    EXPECT_NE(molecule.warnings[0].find("two dimensions only: 1"), std::string::npos) << molecule.warnings[0];
}

TEST(ReadCml, PrefixesAndArraysOfWords) {
    const Molecule molecule = readMolecule(
        "a",
        "<c:molecule xmlns:c=\"http://www.xml-cml.org/schema\"><c:atomArray atomID=\"a b\" elementType=\"Fe  O\" "
        "x3=\"1 2\" y3=\"3 4\" z3=\"5 6\" formalCharge=\"2 -2\"/><c:bondArray atomRef1=\"a\" atomRef2=\"b\" "
        "order=\"2\"/></c:molecule>");
    ASSERT_EQ(molecule.atoms.size(), 2u);
    EXPECT_EQ(molecule.atoms[0].element, 26);
    EXPECT_EQ(molecule.atoms[1].position, glm::vec3(2, 4, 6));
    EXPECT_EQ(molecule.atoms[1].charge, -2);
    ASSERT_EQ(molecule.bonds.size(), 1u);
    EXPECT_EQ(molecule.bonds[0].order, 2);
}

TEST(ReadCml, Faults) {
    const auto inMolecule = [](const std::string& inside) { return cml("<molecule>\n" + inside + "</molecule>\n"); };
    const auto atom = [&](const std::string& attributes) {
        return inMolecule("<atomArray>\n<atom id=\"a\" elementType=\"C\" " + attributes + "/></atomArray>");
    };
    test::expectError("a", atom("xFract=\"0.1\" yFract=\"0.2\" zFract=\"0.3\""),
                      {"(line 5)", "fractional coordinates"});
    test::expectError("a", atom(""), {"(line 5)", "atom 'a' has no coordinates"});
    test::expectError("a", atom("x3=\"0\" y3=\"inf\" z3=\"0\""), {"(line 5)", "invalid y coordinate"});
    test::expectLeftOut("a", atom("x3=\"0\" y3=\"0\" z3=\"0\" formalCharge=\"99\""),
                        "left out 1 formal charge, line 5: not usable");
    test::expectLeftOut("a", inMolecule(kTwoAtoms + "\n<bondArray><bond atomRefs2=\"a z\"/></bondArray>"),
                        "left out 1 bond, line 5: of atoms that are not there");
    test::expectError("a", inMolecule(kTwoAtoms + "<bondArray><bond atomRefs2=\"a\"/></bondArray>"),
                      {"needs two atoms"});
    test::expectError("a", inMolecule(kTwoAtoms + kTwoAtoms), {"two atoms are called 'a'"});
    test::expectError("a", "<cml>\n<molecule>\n</cml>", {"(line 3)", "not valid XML: mismatched tag"});
    test::expectError("a", inMolecule(""), {"it has no atoms"});
    test::expectError("a", inMolecule(kTwoAtoms), {"read as one"}, {.model = 2});
}

TEST(ReadCml, HostileXml) {
    std::string deep = "<cml>";
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    test::expectError("a", deep, {"nested more than 256 deep"});
    test::expectError("a", "<!DOCTYPE cml [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;\">]>\n<cml>&b;</cml>",
                      {"declares XML entities"});
    test::expectError("a", "<!DOCTYPE cml [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>\n<cml>&a;</cml>",
                      {"declares XML entities"});
}

TEST(ReadCml, AtomsOfABondInAttributesOfTheirOwn) {
    const std::string atoms =
        "<atomArray><atom id='a' elementType='C' x3='0' y3='0' z3='0'/><atom id='b' elementType='O' x3='1.2' y3='0' "
        "z3='0'/></atomArray>";
    for (const char* bond :
         {"<bond atomRefs2='a b' order='2'/>", "<bond atomsRefs2='a b' order='2'/>",
          "<bond atomRefs1='a' atomRefs2='b' order='2'/>", "<bond atomRef1='a' atomRef2='b' order='2'/>",
          "<bondArray atomRefs1='a' atomRefs2='b' order='2'/>"}) {
        const Molecule molecule =
            readMolecule("a.cml", "<cml><molecule>" + atoms + "<bondArray>" + bond + "</bondArray></molecule></cml>");
        ASSERT_EQ(molecule.bonds.size(), 1u) << bond;
        EXPECT_EQ(molecule.bonds[0].order, 2) << bond;
    }
}

}  // namespace
}  // namespace nacre
