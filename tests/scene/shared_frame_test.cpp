// One camera for all models of a file.

#include "engine/scene/view/shared_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"

namespace nacre {
namespace {

Molecule read(const std::string& text, int model, const char* name = "models.xyz") {
    return readMolecule(name, text, {.model = model, .others = true});
}

Representation makeScene(const Molecule& molecule, const RepresentationOptions& look = {},
                         const DrawnAtomsOptions& drawn = {}) {
    return represent(molecule, drawnAtoms(molecule, drawn), look, sharedFrame(molecule, drawn, look));
}

// Helium has a radius of 1.4 Å, neon of 1.54 Å (van der Waals, Bondi 1964).
const std::string kWalk = "2\n\nHe 0 0 0\nNe 2 0 0\n2\n\nHe 10 0 0\nNe 12 0 0\n2\n\nHe 0 6 0\nNe 2 6 0\n";

TEST(SharedFrame, IsTheSameForEveryModel) {
    for (int model = 1; model <= 3; ++model) {
        const Representation scene = makeScene(read(kWalk, model));
        EXPECT_EQ(scene.center, glm::dvec3(6, 3, 0)) << model;
        EXPECT_NEAR(scene.radius, std::sqrt(45.0) + 1.54, 1e-6) << model;
    }
}

TEST(SharedFrame, IsThatOfAllModelsDrawnTogether) {
    const Molecule molecule = read(kWalk, 2), all = read(kWalk, kAllModels);
    const Representation one = makeScene(molecule), overlay = makeScene(all);
    EXPECT_EQ(one.center, overlay.center);
    EXPECT_DOUBLE_EQ(one.radius, overlay.radius);
}

TEST(SharedFrame, LeavesTheModelsOwnWhereItIsAskedFor) {
    const Representation scene = makeScene(read(kWalk, 2), RepresentationOptions{.ownFrame = true});
    EXPECT_EQ(scene.center, glm::dvec3(11, 0, 0));
    EXPECT_NEAR(scene.radius, 1 + 1.54, 1e-6);
    EXPECT_FALSE(sharedFrame(read("1\n\nHe 0 0 0\n", 1), {}, {}));
}

TEST(SharedFrame, HoldsWhatIsDrawnAndNothingElse) {
    RepresentationOptions look;
    look.rules = {{Rule::Action::hide, parseSelection("elem Ne"), {}, {}}};
    look.style = Style::licorice;
    const Representation scene = makeScene(read(kWalk, 1), look);
    EXPECT_EQ(scene.center, glm::dvec3(5, 3, 0));
    EXPECT_NEAR(scene.radius, std::sqrt(34.0) + 0.25, 1e-6);
    const std::string water =
        "HETATM    1  O   HOH A   1       0.000   0.000   0.000  1.00  0.00           O\n"
        "ATOM      2  CA  GLY A   2       0.000   0.000   0.000  1.00  0.00           C\n";
    std::string far = water;
    far.replace(30, 8, " 100.000");
    const std::string text = "MODEL        1\n" + water + "ENDMDL\nMODEL        2\n" + far + "ENDMDL\n";
    const Molecule molecule = read(text, 1, "two.pdb");
    EXPECT_EQ(makeScene(molecule).center, glm::dvec3(0));
    EXPECT_EQ(makeScene(molecule, {}, {.water = true}).center, glm::dvec3(50, 0, 0));
}

TEST(SharedFrame, OfRulesThatGoByPlacesAsksEveryModel) {
    // What lies about the neon is one helium in the first model, another in the second.
    const std::string text = "3\n\nNe 0 0 0\nHe 2 0 0\nHe 50 0 0\n3\n\nNe 0 0 0\nHe 50 0 0\nHe 0 4 0\n";
    RepresentationOptions look;
    look.rules = {{Rule::Action::hide, parseSelection("not ((around 5 of elem Ne) or elem Ne)"), {}, {}}};
    for (int model = 1; model <= 2; ++model) {
        const Representation scene = makeScene(read(text, model), look);
        EXPECT_EQ(scene.center, glm::dvec3(1, 2, 0)) << model;
    }
}

TEST(SharedFrame, OfModelsWithOtherAtomsHoldsThem) {
    const std::string text = "1\n\nHe 0 0 0\n2\n\nHe 0 0 0\nNe 0 8 0\n";
    for (int model = 1; model <= 2; ++model) EXPECT_EQ(makeScene(read(text, model)).center, glm::dvec3(0, 4, 0));
}

TEST(SharedFrame, OfAnAssemblyHoldsItsCopies) {
    const auto atom = [](const char* x) {
        return std::string("ATOM      1  CA  GLY A   1    ") + x + "   0.000   0.000  1.00  0.00           C\n";
    };
    const std::string copies =
        "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
        "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
        "REMARK 350   BIOMT1   2  1.000000  0.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT2   2  0.000000  1.000000  0.000000       20.00000\n"
        "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n";
    const std::string text =
        copies + "MODEL        1\n" + atom("   0.000") + "ENDMDL\nMODEL        2\n" + atom("  10.000") + "ENDMDL\n";
    RepresentationOptions look{.assembly = "1"};
    for (int model = 1; model <= 2; ++model)
        EXPECT_EQ(makeScene(read(text, model, "two.pdb"), look).center, glm::dvec3(5, 10, 0)) << model;
}

}  // namespace
}  // namespace nacre
