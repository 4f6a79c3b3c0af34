// Coordinates that no molecule has: each reader refuses them, with the file and the axis.

#include <gtest/gtest.h>

#include <limits>

#include "tests/molecule/bcif_writer.h"
#include "tests/molecule/expect_error.h"
#include "tests/molecule/text_molecules.h"

namespace nacre {
namespace {

TEST(FarAtoms, EveryTextFormatRefusesThem) {
    for (const test::AtomText& format : test::oneAtomTexts()) {
        SCOPED_TRACE(format.name);
        EXPECT_EQ(readMolecule(format.name, format.with("1.5")).atoms.size(), 1u);
        for (const char* x : {"1e39", "-1e39", "1e30", "2e9", "1e400", "nan", "inf", "-inf"})
            test::expectError(format.name, format.with(x), {format.name.c_str(), "x"});
    }
}

TEST(FarAtoms, WhatIsJustWithinReads) {
    for (const test::AtomText& format : test::oneAtomTexts()) {
        if (format.name == "small.cif") continue;  // fractions of the cell have a bound of their own
        SCOPED_TRACE(format.name);
        const bool nanometres = format.name == "a.gro";
        const Molecule molecule = readMolecule(format.name, format.with(nanometres ? "1e8" : "1e9"));
        EXPECT_EQ(molecule.atoms[0].position.x, 1e9f);
    }
    // Ten times as far in Å.
    test::expectError("a.gro", "title\n1\n    1LIG      C    1 2.0e8   0.0     0.0   \n 1 1 1\n",
                      {"(line 3)", "invalid x"});
}

TEST(FarAtoms, NumbersOfBinaryCifTooGo) {
    using namespace test;
    const auto column = [](const char* name, double value) {
        std::uint64_t bits = 0;
        __builtin_memcpy(&bits, &value, sizeof bits);
        return bcifColumn(name, bcifData(littleEndian(bits, 8), {bcifByteArray(33)}));
    };
    const auto file = [&](double x) {
        return bcifFile(
            {bcifCategory("_atom_site", 1, {column("Cartn_x", x), column("Cartn_y", 0), column("Cartn_z", 0)})});
    };
    EXPECT_EQ(readMolecule("a.bcif", file(1e9)).atoms.size(), 1u);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {1e39, 1e30, 2e9, -2e9, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
        expectError("a.bcif", file(x), {"Cartn_x of row 1"});
}

TEST(FarAtoms, OtherNumbersOfPdbAreFinite) {
    const std::string line = "ATOM      1  C   LIG A   1       0.000   0.000   0.000 1e200 1e300           C\n";
    const Molecule molecule = readMolecule("a.pdb", line);
    EXPECT_EQ(molecule.atoms[0].occupancy, 1.0f);
    EXPECT_EQ(molecule.atoms[0].temperatureFactor, 0.0f);
    ASSERT_EQ(molecule.warnings.size(), 1u);
    EXPECT_NE(molecule.warnings[0].find("not numbers"), std::string::npos);
}

}  // namespace
}  // namespace nacre
