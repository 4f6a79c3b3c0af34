// What pocket, interactions and added hydrogens ask for is what is drawn.

#include <gtest/gtest.h>

#include <algorithm>

#include "app/drawing/drawing.h"
#include "app/input/read_input.h"
#include "app/picture/options.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

PictureDescription describePicture(std::initializer_list<std::pair<const char*, const char*>> options) {
    PictureDescription picture;
    picture.input.path = "sample:dna";
    picture.input.cache = "off";
    for (const auto& [key, value] : options) setOption(option(key), value, picture);
    return picture;
}

TEST(Pocket, IsSticksInAFaintCartoonWithLabelsAndContacts) {
    const Molecule molecule = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(molecule, describePicture({{"pocket", "chain A and resi 4"}}));
    const Representation& scene = drawing.scene();
    EXPECT_FALSE(scene.triangles.empty());
    EXPECT_FALSE(scene.spheres.empty());
    ASSERT_FALSE(scene.contacts.empty());
    for (const DrawnContact& contact : scene.contacts)  // what the contacts end at is drawn
        for (const InteractionEnd* end : {&contact.interaction.a, &contact.interaction.b})
            EXPECT_TRUE(std::any_of(scene.sphereLooks.begin(), scene.sphereLooks.end(),
                                    [&](const SphereLook& look) { return look.atom == end->atoms.front() + 1; }));
    EXPECT_GT(drawing.words.labels.size(), 2u);
    EXPECT_GT(drawing.run.zoom, 1.5);
    for (const PlacedLabel& label : drawing.words.labels) EXPECT_NE(label.text, "DG 4");
}

TEST(Pocket, OfTheLigandIsThatOfTheMainOne) {
    const PictureDescription ligand = describePicture({{"pocket", "ligand"}});
    ASSERT_TRUE(ligand.aim.zoomTo && ligand.look.contacts.of);
    EXPECT_EQ(ligand.aim.zoomTo->text, "mainligand");
    EXPECT_EQ(ligand.look.contacts.of->text, "mainligand");
    for (const Rule& rule : ligand.look.rules)
        EXPECT_NE(rule.selection.text.find("(mainligand)"), std::string::npos) << rule.selection.text;
}

TEST(Pocket, OptionsOverrideIt) {
    const PictureDescription plain = describePicture({{"pocket", "resi 4"}});
    EXPECT_EQ(plain.look.cartoonOpacity, 0.3);
    ASSERT_TRUE(plain.aim.zoomTo);
    EXPECT_EQ(plain.aim.zoomTo->text, "resi 4");
    const PictureDescription other = describePicture(
        {{"show", "resi 4=spacefill"}, {"pocket", "resi 4"}, {"cartoon-opacity", "1"}, {"interaction-kinds", "metal"}});
    EXPECT_EQ(other.look.cartoonOpacity, 1);
    EXPECT_EQ(other.look.rules.back().style, Style::spacefill);  // rules that were given come last
    EXPECT_FALSE(other.look.contacts.kinds[0]);
    EXPECT_THROW(describePicture({{"pocket", "resi"}}), Error);
}

TEST(Pocket, DistancesOfContactsAreLabels) {
    const Molecule molecule = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(molecule, describePicture({{"style", "licorice"},
                                               {"interactions", "chain A,chain B"},
                                               {"interaction-kinds", "hydrogen-bond"},
                                               {"interaction-labels", "distance"}}));
    ASSERT_EQ(drawing.words.labels.size(), drawing.scene().contacts.size());
    EXPECT_EQ(drawing.words.labels.front().text, "3.0");
    drawing.prepare(molecule, describePicture({{"style", "licorice"}, {"interaction-labels", "distance"}}));
    ASSERT_FALSE(drawing.warnings.empty());  // it needs interactions
}

TEST(AddedHydrogens, AreDrawnAndDoNotMove) {
    InputOptions input;
    input.path = "sample:dna";
    const auto hydrogens = [&] {
        const Molecule molecule = readLocally(input, std::uint64_t{1} << 30);
        return std::count_if(molecule.atoms.begin(), molecule.atoms.end(),
                             [](const Atom& atom) { return isHydrogen(atom.element); });
    };
    EXPECT_EQ(hydrogens(), 0);
    input.addHydrogens = true;
    // Of each nucleotide with its phosphate A has 11, C 11, G 11, T 12; the two at the 5' ends one more.
    EXPECT_EQ(hydrogens(), 2 * (4 * 11 + 4 * 11 + 2 * 11 + 2 * 12) + 2 + 2);
    Drawing drawing;
    const Molecule molecule = readLocally(input, std::uint64_t{1} << 30);
    drawing.prepare(molecule, describePicture({{"style", "licorice"}}));
    EXPECT_EQ(drawing.scene().drawnAtoms, molecule.atoms.size());
    input.trajectory.path = "md.xtc";
    EXPECT_THROW(readLocally(input, std::uint64_t{1} << 30), Error);
}

}  // namespace
}  // namespace nacre::app
