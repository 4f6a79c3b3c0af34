// Octants of ellipsoids face the viewer of a picture, however its view comes about.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "engine/molecule/displacement.h"
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

    /// Ellipsoids with nothing in the octant that faces the eye of a view.
    std::size_t openToViewer(const Representation& r, const View& view) const {
        std::vector<bool> open(molecule.atoms.size());
        for (std::uint32_t atom = 0; atom < open.size(); ++atom) open[atom] = molecule.displacements[atom].stated();
        for (const Triangle& t : r.triangles) {
            const std::uint32_t atom = r.meshLooks[r.meshVertices[t.a].look].atom - 1;
            const glm::dvec3 center = glm::dvec3(molecule.atoms[atom].position) - r.center;
            glm::dvec3 middle(0);
            for (const std::uint32_t v : {t.a, t.b, t.c})
                middle += (glm::dvec3(decodePosition(r.meshVertices[v], t.step())) - center) / 3.0;
            glm::dvec3 toEye(0, 0, 1);
            if (view.projection == Projection::perspective)
                toEye = glm::dvec3(0, 0, view.eyeDistance) - view.seen(center);
            toEye = glm::transpose(view.rotation) * toEye;
            double least = 1;
            for (const glm::dvec3& axis : *displacementAxes(molecule.displacements[atom]))
                least = std::min(least,
                                 glm::dot(middle, axis) / glm::dot(axis, axis) * (glm::dot(toEye, axis) < 0 ? -1 : 1));
            if (least > 1e-3) open[atom] = false;
        }
        return static_cast<std::size_t>(std::ranges::count(open, true));
    }

    const Molecule molecule = test::glucoseWithTensors();
    PictureDescription picture;
    Drawing drawing;
    static constexpr std::size_t kEllipsoids = 12;
};

TEST_F(OctantsTest, FaceTheViewerOfEveryKindOfView) {
    const std::pair<const char*, const char*> changes[] = {
        {"rotate", "10,20,30"}, {"rotate", "-60,130,0"},       {"orient", "principal"},
        {"rotate", "0,180,0"},  {"projection", "perspective"}, {"fov", "80"},
        {"look-at", "elem O"},  {"zoom-to", "id 3"},           {"stereo", "anaglyph"}};
    for (const auto& [key, value] : changes) {
        SCOPED_TRACE(key + std::string(" ") + value);
        set(key, value);
        drawing.prepare(molecule, picture);
        EXPECT_EQ(openToViewer(drawing.scene(), drawing.settings.view), kEllipsoids);
        EXPECT_TRUE(drawing.octantsFace(picture.camera) || picture.aim.any());
        // As drawn by one that has drawn nothing yet, and from where whole ellipsoids are seen.
        Drawing fresh, whole;
        fresh.prepare(molecule, picture);
        EXPECT_EQ(fresh.settings.view.rotation, drawing.settings.view.rotation);
        EXPECT_EQ(fresh.settings.view.pixelsPerAngstrom, drawing.settings.view.pixelsPerAngstrom);
        PictureDescription bands = picture;
        bands.look.ellipsoids = EllipsoidForm::bands;
        whole.prepare(molecule, bands);
        EXPECT_EQ(whole.settings.view.rotation, drawing.settings.view.rotation);
        EXPECT_EQ(whole.settings.view.pixelsPerAngstrom, drawing.settings.view.pixelsPerAngstrom);
        EXPECT_EQ(whole.scene().radius, drawing.scene().radius);
        if (picture.aim.zoomTo) continue;  // the scene lacks what hides the target
        EXPECT_EQ(openToViewer(whole.scene(), drawing.settings.view), 0u);
    }
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
        EXPECT_NEAR(label.radius, AtomEllipsoids(molecule, 50).ball(atom), 1e-3);
    }
}

TEST_F(OctantsTest, OfMovingAtomsFaceTheFirstView) {
    set("rotate", "40,50,60");
    drawing.prepare(molecule, picture);
    const View view = drawing.settings.view;
    drawing.startMoving(molecule);
    drawing.moveTo(molecule);
    EXPECT_EQ(openToViewer(drawing.scene(), view), kEllipsoids);
}

TEST_F(OctantsTest, InAWindowAreThoseOfTheLastBuild) {
    Drawing byHand(CameraBy::hand);
    byHand.build(molecule, picture);
    EXPECT_EQ(byHand.counts().scenes, 2) << "whole, and cut";
    EXPECT_TRUE(byHand.octantsFace(picture.camera));
    Camera turned = picture.camera;
    turned.rotationDegrees = {0, 180, 0};
    EXPECT_FALSE(byHand.octantsFace(turned));
    set("rotate", "0,180,0");
    EXPECT_FALSE(rebuildFor(byHand.description(), picture, CameraBy::hand).scene)
        << "moving the camera rebuilds nothing";
    set("ellipsoids", "bands");
    byHand.build(molecule, picture);
    EXPECT_TRUE(byHand.octantsFace(turned));
}

}  // namespace
}  // namespace nacre::app
