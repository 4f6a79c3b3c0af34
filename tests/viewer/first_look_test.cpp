#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "app/drawing/aim.h"
#include "app/drawing/scenes.h"
#include "app/picture/looks.h"
#include "app/viewer/loader.h"
#include "app/viewer/presets.h"
#include "tests/molecule/build_molecule.h"
#include "tests/molecule/build_peptide.h"

namespace nacre::app {
namespace {

TEST(Aim, TheLigandIsTheMainOne) {
    test::MoleculeText text;
    const auto ring = [&](const char* name, int atoms, float x) {
        text.residue(name, atoms);
        for (int i = 0; i < atoms; ++i) text.atom("C" + std::to_string(i), "C", {x, static_cast<float>(i), 0});
    };
    ring("NAG", 14, 0), ring("GOL", 6, 20), ring("LIG", 5, 40), ring("LIG", 5, 60);
    const ResidueFacts facts(text.molecule);
    const Representation scene = buildScene(facts, {});
    const auto zoomed = [&](const char* to) {
        Aim aim;
        aim.zoomTo = parseSelection(to);
        return aimed({}, aim, facts, {scene, scene.radius}, {640, 480}).camera;
    };
    const Camera main = zoomed("ligand"), first = zoomed("id 21-25"), sugar = zoomed("resn NAG");
    EXPECT_EQ(main.pan, first.pan);
    EXPECT_EQ(main.zoom, first.zoom);
    EXPECT_NE(main.pan, sugar.pan);
    EXPECT_NE(zoomed("ligand and all").pan, main.pan) << "what is written otherwise means all of it";
}

TEST(Presets, ALigandInItsPocketIsThatOfShowPocket) {
    PictureDescription preset, shown;
    const auto pocket = std::ranges::find_if(presets(), &Preset::pocket);
    ASSERT_NE(pocket, presets().end());
    applyPreset(*pocket, preset);
    applyPocket("ligand", shown);
    EXPECT_EQ(preset.look, shown.look);
    EXPECT_EQ(preset.words.labels, shown.words.labels);
    EXPECT_EQ(preset.aim.zoomTo, shown.aim.zoomTo);
}

TEST(FirstLook, IsOfWhatIsOpenedNotOfWhatIsReadAgain) {
    const Sources sources{[](const PictureDescription&) { return test::buildChain(300, -57, -47); }};
    Loader loader(sources, {});
    PictureDescription view;
    view.input.path = "protein.pdb";
    loader.open(view);
    loader.wait();
    EXPECT_EQ(loader.take().value().view.look.style, Style::cartoon);
    loader.read(view);
    loader.wait();
    EXPECT_FALSE(loader.take().value().view.look.style);
}

}  // namespace
}  // namespace nacre::app
