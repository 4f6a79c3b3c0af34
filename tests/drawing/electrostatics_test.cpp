// Potentials by the programs pdb2pqr and apbs: judged by a formula, and with programs of our own that fail.

#include "app/input/electrostatics.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "tests/support/temporary_folder.h"

namespace nacre::app {
namespace {

Molecule makePqr(const std::string& atoms) { return readMolecule("ions.pqr", atoms, {.format = Format::pqr}); }

std::string catchError(const Molecule& molecule, const InputOptions& input = {}) {
    try {
        electrostaticPotential(molecule, input);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// Puts programs of this name before those of the system.
class OwnPrograms {
public:
    ~OwnPrograms() { setenv("PATH", before_.c_str(), 1); }
    void add(const std::string& name, const std::string& script) {
        std::ofstream(folder_ / name) << "#!/bin/sh\n" << script << "\n";
        chmod((folder_ / name).c_str(), 0755);
        setenv("PATH", (folder_.path() + ":" + before_).c_str(), 1);
    }
    void none() { setenv("PATH", folder_.path().c_str(), 1); }
    const nacre::test::TemporaryFolder& folder() const { return folder_; }

private:
    nacre::test::TemporaryFolder folder_;
    const std::string before_ = std::getenv("PATH");
};

// Debye and Hückel: an ion of charge z and radius b, that other ions approach up to a, in water.
TEST(Electrostatics, OfAnIonIsThatOfDebyeAndHueckel) {
    const Molecule ion = makePqr("ATOM 1 NA NA 1 1.0 2.0 3.0 1.0 2.0\nEND\n");
    const std::shared_ptr<const DensityMap> map = electrostaticPotential(ion, {});
    constexpr double kBjerrum = 7.135, kDebye = 7.86, kExclusion = 4;  // Å
    for (const double r : {4.5, 6.0, 8.0, 10.0}) {
        const double expected = kBjerrum * std::exp(-(r - kExclusion) / kDebye) / (r * (1 + kExclusion / kDebye));
        for (const glm::dvec3 direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0, 0.8)})
            EXPECT_NEAR(valueAt(*map, glm::dvec3(1, 2, 3) + r * direction), expected, 0.03 * expected + 0.01) << r;
    }
    EXPECT_EQ(electrostaticPotential(ion, {}), map) << "calculated once";
}

TEST(Electrostatics, ColourSurfacesRedWhereNegative) {
    const Molecule ions = makePqr("ATOM 1 CL CL 1 -4 0 0 -1.0 2.0\nATOM 2 NA NA 2 4 0 0 1.0 2.0\nEND\n");
    PictureDescription picture;
    picture.size = {64, 48};
    picture.occlusion.directions = 0;
    setOption(option("electrostatics"), "on", picture);
    Drawing drawing;
    drawing.build(ions, picture);
    ASSERT_FALSE(drawing.scene().meshes.empty()) << "the style is a surface where no other is asked for";
    const Representation& scene = drawing.scene();
    std::size_t red = 0, blue = 0;
    for (const MeshVertex& vertex : scene.meshVertices) {
        const std::uint32_t color = scene.meshLooks[vertex.look].color;
        const bool left = decodePosition(vertex, scene.triangles.front().step()).x + scene.center.x < 0;
        const bool reddish = (color & 255) > (color >> 16 & 255);
        (reddish ? red : blue) += 1;
        EXPECT_EQ(reddish, left);
    }
    EXPECT_GT(red, 20u);
    EXPECT_GT(blue, 20u);
    ASSERT_EQ(scene.legends.size(), 1u);
}

TEST(Electrostatics, NamesWhatHasNoCharges) {
    OwnPrograms programs;
    // Keeps the first atom of each file.
    programs.add("pdb2pqr", "sed -n '1s/.*/ATOM 1 N ALA A 1 0.0 0.0 0.0 0.5 1.5/p' \"$3\" >\"$4\"");
    const Molecule molecule =
        readMolecule("a.pdb",
                     "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N\n"
                     "HETATM    2  C1  LIG A   2       3.000   0.000   0.000  1.00  0.00           C\n"
                     "HETATM    3  O   HOH A   3       9.000   0.000   0.000  1.00  0.00           O\n");
    const std::shared_ptr<const DensityMap> map = electrostaticPotential(molecule, {});
    ASSERT_EQ(map->warnings.size(), 1u);
    EXPECT_NE(map->warnings[0].find("leaves out LIG:"), std::string::npos) << map->warnings[0];
}

TEST(Electrostatics, SaysWhatFailed) {
    const Molecule dna = sampleMolecule("dna");
    OwnPrograms programs;
    programs.add("pdb2pqr", "echo 'a line'\necho 'CRITICAL: no such residue' >&2\nexit 3");
    EXPECT_EQ(catchError(dna), "cannot calculate the electrostatic potential: pdb2pqr: CRITICAL: no such residue");
    programs.add("pdb2pqr", "kill -9 $$");
    EXPECT_EQ(catchError(dna), "cannot calculate the electrostatic potential: pdb2pqr was ended by signal 9");
    programs.add("apbs", "echo 'grid too large'");
    const Molecule ion = makePqr("ATOM 1 NA NA 1 0 0 0 1.0 2.5\nEND\n");
    EXPECT_EQ(catchError(ion), "cannot calculate the electrostatic potential: apbs: grid too large");
    InputOptions small;
    small.memoryMegabytes = 30;
    EXPECT_NE(catchError(ion, small).find("apbs needs 17 MB for the coarsest grid"), std::string::npos)
        << catchError(ion, small);
    programs.none();
    remove((programs.folder() / "pdb2pqr").c_str());
    EXPECT_NE(catchError(dna).find("the program pdb2pqr is not installed"), std::string::npos) << catchError(dna);
}

// Insertion codes, long names and numbers have no place there.
TEST(Electrostatics, HandsTheModelOverAsAPdbFile) {
    OwnPrograms programs;
    programs.add("pdb2pqr", "cp \"$3\" \"" + programs.folder() / "seen.pdb" + "\"; exit 1");
    catchError(sampleMolecule("dna"));
    const Molecule seen = readMoleculeFile(programs.folder() / "seen.pdb");
    const Molecule dna = sampleMolecule("dna");
    ASSERT_EQ(seen.atoms.size(), dna.atoms.size());
    ASSERT_EQ(seen.residues.size(), dna.residues.size());
    for (std::size_t i = 0; i < dna.atoms.size(); ++i) {
        EXPECT_LT(glm::distance(seen.atoms[i].position, dna.atoms[i].position), 0.001f);
        EXPECT_EQ(seen.atoms[i].name.view(), dna.atoms[i].name.view());
        EXPECT_EQ(seen.atoms[i].element, dna.atoms[i].element);
    }
}

}  // namespace
}  // namespace nacre::app
