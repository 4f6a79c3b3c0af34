// A view file is one camera: neither what is drawn nor how moves it.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "app/picture/saved_view.h"
#include "engine/error.h"
#include "engine/molecule/read.h"
#include "tests/support/run_program.h"
#include "tests/support/test_data.h"

namespace nacre::app {
namespace {

using Options = std::initializer_list<std::pair<const char*, const char*>>;
using test::nacreDone;
using test::TemporaryFolder;

PictureDescription cameraPicture(Options options) {
    PictureDescription picture;
    picture.input.path = "sample:dna";
    picture.input.cache = "off";
    picture.size = {640, 480};
    for (const auto& [key, value] : options) setOption(option(key), value, picture);
    return picture;
}

/// A patch of lipids in the plane across an axis, in two leaflets.
Molecule bilayer(int axis) {
    std::string text;
    int number = 0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 6; ++j)
            for (const double height : {-18.0, -9.0, 9.0, 18.0}) {
                double place[3] = {8.0 * i, 8.0 * j, height};
                std::rotate(place, place + 2 - axis, place + 3);
                char line[100];
                ++number;
                std::snprintf(line, sizeof line, "HETATM%5d  P   POPC%5d    %8.3f%8.3f%8.3f  1.00  0.00           P\n",
                              number, number, place[0], place[1], place[2]);
                text += line;
            }
    return readMolecule("membrane.pdb", text);
}

TEST(Camera, BilayersAreSeenFromTheirEdge) {
    for (const int axis : {0, 1, 2}) {
        const Molecule molecule = bilayer(axis);
        ASSERT_EQ(molecule.atoms.size(), 192u);
        glm::dvec3 normal(0);
        normal[axis] = 1;
        Drawing drawing;
        drawing.prepare(molecule, cameraPicture({{"orient", "principal"}}));
        const glm::dvec3 seen = drawing.settings.view.rotation * normal;
        EXPECT_NEAR(std::abs(seen.y), 1, 1e-6) << "the normal points up, not at the viewer: " << axis;
    }
}

/// The pixel of a place of the file, by the formulas of the reference.
glm::dvec2 cameraPixel(const glm::dvec3& place, const Drawing& drawing) {
    const View& view = drawing.settings.view;
    const glm::dvec3 v = view.rotation * (place - drawing.run.center);
    const double magnify = view.projection == Projection::perspective ? view.eyeDistance / (view.eyeDistance - v.z) : 1;
    const glm::dvec2 at = (glm::dvec2(v) * magnify + view.pan) * view.pixelsPerAngstrom;
    return {view.width / 2.0 + at.x, view.height / 2.0 - at.y};
}

void expectAt(const glm::dvec2& pixel, double x, double y, const std::string& what) {
    EXPECT_NEAR(pixel.x, x, 1e-6) << what;
    EXPECT_NEAR(pixel.y, y, 1e-6) << what;
}

TEST(Camera, ASavedViewKeepsItsPlacesWhateverIsDrawn) {
    const Molecule molecule = sampleMolecule("dna");
    const std::initializer_list<Options> cameras{
        {{"rotate", "30,40,0"}},
        {{"rotate", "30,40,0"}, {"projection", "perspective"}, {"title", "DNA"}, {"legend", "on"}},
        {{"zoom-to", "chain A and resi 4"}, {"projection", "perspective"}},
        {{"orient", "principal"}, {"style", "surface"}}};
    for (const Options& camera : cameras) {
        Drawing first;
        first.prepare(molecule, cameraPicture(camera));
        const PictureDescription view = parseSavedView(savedViewJson(first.placed()), "v.json");
        const std::initializer_list<Options> others{{},
                                                    {{"style", "cartoon"}},
                                                    {{"style", "surface"}},
                                                    {{"style", "licorice"}, {"hide", "chain B"}},
                                                    {{"style", "ball-and-stick"}, {"title", "Another title"}}};
        for (const Options& other : others) {
            PictureDescription again = view;
            again.input.cache = "off";
            again.size = {640, 480};
            again.aim.uncovers = false;
            again.aim.uncover.reset();
            for (const auto& [key, value] : other) setOption(option(key), value, again);
            Drawing drawing;
            drawing.prepare(molecule, again);
            for (const std::size_t atom : {std::size_t{0}, molecule.atoms.size() / 2, molecule.atoms.size() - 1}) {
                const glm::dvec3 place(molecule.atoms[atom].position);
                const glm::dvec2 was = cameraPixel(place, first);
                expectAt(cameraPixel(place, drawing), was.x, was.y, camera.begin()->first);
            }
        }
    }
}

TEST(Camera, CenterAndScaleAreAbsolute) {
    const Molecule molecule = sampleMolecule("dna");
    const glm::dvec3 place(molecule.atoms[10].position);
    for (const char* projection : {"ortho", "perspective"})
        for (const char* style : {"spacefill", "cartoon"}) {
            Drawing drawing;
            drawing.prepare(molecule, cameraPicture({{"center", "id 11"},
                                                     {"scale", "8"},
                                                     {"projection", projection},
                                                     {"style", style},
                                                     {"title", "DNA"}}));
            expectAt(cameraPixel(place, drawing), 320, 240, style);
            const glm::dvec3 right = glm::transpose(drawing.settings.view.rotation) * glm::dvec3(2, -1, 0);
            expectAt(cameraPixel(place + right, drawing), 320 + 16, 240 + 8, style);
        }
    Drawing across;
    across.prepare(molecule, cameraPicture({{"center", "1,2,3"}, {"scale", "60A"}, {"zoom", "2"}}));
    EXPECT_EQ(across.run.center, glm::dvec3(1, 2, 3));
    EXPECT_DOUBLE_EQ(across.settings.view.pixelsPerAngstrom, 480.0 / 60 * 2);
    Drawing none;
    EXPECT_THROW(none.prepare(molecule, cameraPicture({{"center", "resn XXX"}})), Error);
}

TEST(Camera, ACentreAloneStillShowsEverything) {
    const Molecule molecule = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(molecule, cameraPicture({{"center", "chain A and resi 1"}}));
    double nearest = 1e9;
    for (const Sphere& sphere : drawing.scene().spheres) {
        const glm::dvec2 at = cameraPixel(glm::dvec3(sphere.center) + drawing.run.center, drawing);
        const double reach = static_cast<double>(sphere.radius) * drawing.settings.view.pixelsPerAngstrom;
        nearest = std::min({nearest, at.x - reach, at.y - reach, 640 - at.x - reach, 480 - at.y - reach});
    }
    EXPECT_GT(nearest, 0);
    EXPECT_LT(nearest, 0.03 * 480);  // as large as fits
}

TEST(Camera, OrientTakesTheAxesOfASelection) {
    const Molecule molecule = sampleMolecule("dna");
    Drawing all, base;
    all.prepare(molecule, cameraPicture({{"orient", "principal"}}));
    base.prepare(molecule, cameraPicture({{"orient", "chain A and resi 4 and not backbone"}}));
    EXPECT_NE(all.settings.view.rotation, base.settings.view.rotation);
    // A base is flat: the picture shows its face.
    double low = 1e9, high = -1e9;
    const std::vector<bool> chosen = selectAtoms(
        ResidueFacts(molecule), parseSelection("chain A and resi 4 and not backbone and name N*+C2+C4+C5+C6"));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!chosen[i]) continue;
        const double z = (base.settings.view.rotation * glm::dvec3(molecule.atoms[i].position)).z;
        low = std::min(low, z);
        high = std::max(high, z);
    }
    EXPECT_LT(high - low, 1.2);
}

/// From the middle of chain A to that of chain B, as the picture of their interface shows it.
glm::dvec3 wayAcross(const Molecule& molecule) {
    Drawing drawing;
    drawing.prepare(molecule, cameraPicture({{"interface", "A,B"}}));
    EXPECT_FALSE(drawing.scene().contacts.empty());
    const auto middle = [&](const char* chain) {
        const std::vector<bool> chosen = selectAtoms(ResidueFacts(molecule), parseSelection(chain));
        glm::dvec3 sum(0);
        double count = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (chosen[i]) sum += glm::dvec3(molecule.atoms[i].position), ++count;
        return drawing.settings.view.rotation * (sum / count);
    };
    return middle("chain B") - middle("chain A");
}

TEST(Camera, AnInterfaceIsSeenFromItsSide) {
    EXPECT_GT(wayAcross(sampleMolecule("dna")).x, 0);
    EXPECT_THROW(cameraPicture({{"interface", "A"}}), std::invalid_argument);
}

// The interface of 4HHB's chains A and B is flat: its normal is within 11 degrees of the way between the chains (by
// numpy's eigenvectors of the residues within 4 Å), and lies in the picture, to the right.
TEST(Camera, AFlatInterfaceStandsUpright) {
    NACRE_NEEDS_DATA();
    const glm::dvec3 way = wayAcross(readMoleculeFile(test::dataFile("4hhb.pdb")));
    EXPECT_GT(way.x, 0.97 * glm::length(way));
}

/// Depth of an atom's centre, Å from the scene's centre away from the viewer.
double depthIn(const Drawing& drawing, const Molecule& molecule, std::size_t atom) {
    const glm::dvec3 place = glm::dvec3(molecule.atoms[atom].position) - drawing.run.center;
    return -(drawing.settings.view.rotation * place).z;
}

TEST(Clipping, PlanesCountFromTheMiddleOfWhatIsZoomedTo) {
    const Molecule molecule = sampleMolecule("dna");
    const std::vector<bool> chosen = selectAtoms(ResidueFacts(molecule), parseSelection("chain A and resi 2"));
    for (const char* rotate : {"0,0,0", "0,90,0", "40,200,10"}) {
        Drawing drawing;
        drawing.prepare(molecule, cameraPicture({{"zoom-to", "chain A and resi 2"},
                                                 {"rotate", rotate},
                                                 {"clip", "-2,3"},
                                                 {"style", "ball-and-stick"}}));
        double low = 1e9, high = -1e9;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (!chosen[i]) continue;
            low = std::min(low, depthIn(drawing, molecule, i));
            high = std::max(high, depthIn(drawing, molecule, i));
        }
        const Clip& clip = drawing.settings.effects.clip;
        EXPECT_DOUBLE_EQ(clip.far - clip.near, 5) << rotate;
        EXPECT_NEAR(clip.near + 2, (low + high) / 2, 2) << rotate;
    }
}

TEST(Clipping, APlaneStandsInFrontOfASelection) {
    const Molecule molecule = sampleMolecule("dna");
    const std::vector<bool> chosen = selectAtoms(ResidueFacts(molecule), parseSelection("chain A and resi 6"));
    Drawing drawing;
    drawing.prepare(molecule, cameraPicture({{"clip", "chain A and resi 6"}, {"rotate", "20,30,0"}}));
    double nearest = 1e9;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) nearest = std::min(nearest, depthIn(drawing, molecule, i));
    const double near = drawing.settings.effects.clip.near;
    EXPECT_LT(near, nearest - 1);
    EXPECT_GT(near, nearest - 3);
    EXPECT_EQ(drawing.settings.effects.clip.far, Clip::kNone);
}

TEST(Clipping, SparesASelection) {
    const Molecule molecule = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(molecule, cameraPicture({{"clip", "0"}, {"clip-spare", "chain A"}, {"style", "spacefill"}}));
    std::size_t spared = 0, ofChain = 0, others = 0;
    const std::vector<bool> chosen = selectAtoms(ResidueFacts(molecule), parseSelection("chain A"));
    for (std::size_t i = 0; i < chosen.size(); ++i) ofChain += chosen[i];
    for (const SphereLook& look : drawing.scene().sphereLooks) {
        const bool isSpared = chosen[look.atom - 1];
        spared += isSpared;
        if (isSpared) continue;
        ++others;
        EXPECT_GE(depthIn(drawing, molecule, look.atom - 1), 0);
    }
    EXPECT_EQ(spared, ofChain);
    EXPECT_GT(others, 50u);
    EXPECT_FALSE(drawing.settings.effects.clip.on());
    // A view saved of it cuts as before.
    EXPECT_EQ(drawing.placed().effects.clip.near, 0);
    EXPECT_TRUE(drawing.placed().aim.spares);
}

TEST(AutomaticFog, EndsWithWhatIsSeenOfAClosedShell) {
    const Molecule shell = sampleMolecule("buckyball");
    Drawing closed;
    closed.prepare(shell, cameraPicture({{"fog", "auto"}, {"style", "spacefill"}}));
    const Fog& fog = closed.settings.effects.fog;
    ASSERT_EQ(fog.range, Fog::Range::given);
    EXPECT_LT(fog.start, -closed.settings.view.radius * 0.7);  // its nearest atoms are clear
    EXPECT_LT(fog.end, closed.settings.view.radius * 0.5);     // its rim is not
    EXPECT_GT(fog.end, fog.start + 2);
}

nlohmann::json viewOfStats(const TemporaryFolder& folder, const std::string& arguments) {
    nacreDone(folder, "render " + arguments + " -o a.png --size 160x120 --stats s.json");
    return nlohmann::json::parse(test::readContents(folder / "s.json"))["view"];
}

TEST(Camera, ViewsAreWrittenByTheCommandLineAndStatsAreViews) {
    const TemporaryFolder folder;
    const nlohmann::json first = viewOfStats(
        folder, "sample:dna --style cartoon --orient principal --projection perspective --save-view v.json");
    std::filesystem::rename(folder / "s.json", folder / "camera.json");
    for (const char* other :
         {"--view v.json --style surface", "sample:dna --view v.json --style licorice --hide 'chain B'",
          "sample:dna --view camera.json --style spacefill --occlusion off"}) {
        const nlohmann::json view = viewOfStats(folder, other);
        EXPECT_NEAR(view["pixels_per_angstrom"].get<double>(), first["pixels_per_angstrom"].get<double>(), 1e-9)
            << other;
        EXPECT_NEAR(view["eye_distance"].get<double>(), first["eye_distance"].get<double>(), 1e-9) << other;
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(view["center"][i].get<double>(), first["center"][i].get<double>(), 1e-9) << other;
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(view["orientation"][i].get<double>(), first["orientation"][i].get<double>(), 1e-9) << other;
    }
}

}  // namespace
}  // namespace nacre::app
