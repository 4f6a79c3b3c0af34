// Pictures of ellipsoids with octants cut out.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "engine/scene/build/atom_ellipsoids.h"
#include "tests/reference/displacements.h"

namespace nacre::app {
namespace {

class OctantsTest : public testing::Test {
protected:
    OctantsTest() {
        picture.input.path = "sample:glucose";
        picture.input.cache = "off";
        picture.size = {120, 100};
        picture.occlusion.directions = 8;
        picture.look.style = Style::ellipsoids;
        picture.look.ellipsoids = EllipsoidForm::octants;
    }
    void set(std::string_view key, const std::string& value) { setOption(option(key), value, picture); }

    const Molecule molecule = test::glucoseWithTensors();
    PictureDescription picture;
    Drawing drawing;
};

TEST_F(OctantsTest, OneSceneServesEveryView) {
    drawing.prepare(molecule, picture);
    const int scenes = drawing.counts().scenes;
    for (const auto& [key, value] : {std::pair("rotate", "10,20,30"), {"projection", "perspective"}, {"fov", "80"}}) {
        set(key, value);
        drawing.prepare(molecule, picture);
    }
    EXPECT_EQ(drawing.counts().scenes, scenes);
    EXPECT_TRUE(drawing.scene().cutsOctants);
}

TEST_F(OctantsTest, AnotherFormIsAnotherScene) {
    Canvas canvas{DeviceOptions{}};
    drawing.prepare(molecule, picture);
    const Picture octants = drawing.draw(canvas);
    set("ellipsoids", "bands");
    EXPECT_TRUE(rebuildFor(drawing.description(), picture, CameraBy::hand).scene);
    drawing.prepare(molecule, picture);
    const Picture bands = drawing.draw(canvas);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < bands.rgba.size(); i += 4) differing += bands.rgba[i] != octants.rgba[i];
    EXPECT_GT(differing, 200u) << "of 12,000 pixels";
    set("ellipsoids", "octants");
    drawing.prepare(molecule, picture);
    EXPECT_EQ(drawing.draw(canvas).rgba, octants.rgba);
}

TEST_F(OctantsTest, LabelsStandAsBesideWholeEllipsoids) {
    set("label", "elem O={atom}");
    drawing.prepare(molecule, picture);
    ASSERT_EQ(drawing.words.labels.size(), 6u);
    for (const PlacedLabel& label : drawing.words.labels) {
        std::uint32_t atom = 0;
        const auto away = [&](std::uint32_t i) {
            return glm::distance(glm::dvec3(molecule.atoms[i].position) - drawing.scene().center, label.at);
        };
        for (std::uint32_t i = 1; i < molecule.atoms.size(); ++i)
            if (away(i) < away(atom)) atom = i;
        EXPECT_NEAR(label.radius, AtomEllipsoids(molecule, 50).reach(atom), 1e-3);
    }
}

}  // namespace
}  // namespace nacre::app
