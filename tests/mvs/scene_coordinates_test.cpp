// Topologies of a scene that take their positions from another file.

#include <gtest/gtest.h>

#include "tests/mvs/small_scene.h"

namespace nacre::app::mvs {
namespace {

constexpr const char* kPsf = R"(PSF EXT

         1 !NTITLE
* WATER

         3 !NATOM
         1 WAT      1        TIP3     OH2      OT     -0.834000       15.9994           0
         2 WAT      1        TIP3     H1       HT      0.417000        1.0080           0
         3 WAT      1        TIP3     H2       HT      0.417000        1.0080           0

         2 !NBOND: bonds
         1         2         1         3
)";
constexpr const char* kXyz = "3\n\nO 0 0 0\nH 1 0 0\nH 0 1 0\n3\n\nO 0 0 5\nH 1 0 5\nH 0 1 5\n";

/// CHARMM's DCD as its readers describe it: records between their lengths, little-endian.
std::string dcd(int frames) {
    std::string file;
    const auto put = [&](auto value) { file.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(84), file += "CORD";
    for (int i = 0; i < 20; ++i) put(i == 0 ? frames : i == 2 ? 1 : i == 19 ? 24 : 0);
    put(84);
    put(84), put(1), file += std::string(80, ' '), put(84);
    put(4), put(3), put(4);
    for (int frame = 0; frame < frames; ++frame)
        for (int axis = 0; axis < 3; ++axis) {
            put(12);
            for (int atom = 0; atom < 3; ++atom) put(static_cast<float>(100 * frame + 10 * axis + atom));
            put(12);
        }
    return file;
}

Molecule placed(const std::string& coordinates, const std::string& params, const std::string& topology = kPsf) {
    const std::string file = R"({"kind": "download", "params": {"url": "c.xyz"}, "children": [{"kind": "parse",
        "params": {"format": "dcd"}, "children": [{"kind": "coordinates", "ref": "places"}]}]})";
    const std::string json = R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "t.xyz"},
        "children": [{"kind": "parse", "params": {"format": "psf"}, "children": [{"kind": "structure", "params":
        {"type": "model")" + params +
                             R"(}, "children": [)" + component(R"("all")", balls()) + "]}]}]}," + file + "]}}";
    SceneSources sources;
    sources.fetch = [&](const std::string& uri) { return uri == "t.xyz" ? topology : coordinates; };
    return buildScene(parseScene(json, "a.mvsj"), 0, "a.mvsj", sources);
}

TEST(SceneCoordinates, ATopologyTakesAFrameOfATrajectory) {
    const Molecule molecule = placed(dcd(3), R"(, "coordinates_ref": "places", "model_index": 2)");
    ASSERT_EQ(molecule.atoms.size(), 3u);
    EXPECT_EQ(molecule.atoms[1].position, glm::vec3(201, 211, 221));
    EXPECT_EQ(molecule.bonds.size(), 2u);
    EXPECT_EQ(molecule.guide->layers.at(0).atoms.size(), 3u);
    EXPECT_TRUE(molecule.guide->warnings.empty());
}

TEST(SceneCoordinates, AGromacsTopologyHasAsManyMoleculesAsItSays) {
    const std::string topology =
        "[ moleculetype ]\nH2 1\n[ atoms ]\n1 H 1 H2 HA 1\n2 H 1 H2 HB 1\n[ bonds ]\n1 2\n"
        "[ moleculetype ]\nHE 1\n[ atoms ]\n1 He 1 HE HE 1\n"
        "[ molecules ]\nHE 1\nH2 1\n";
    const Molecule gas = placed(dcd(1), R"(, "coordinates_ref": "places")", topology);
    ASSERT_EQ(gas.atoms.size(), 3u);
    EXPECT_EQ(gas.atoms[2].position, glm::vec3(2, 12, 22));
    EXPECT_EQ(gas.atoms[0].element, 2);
    ASSERT_EQ(gas.bonds.size(), 1u);
    EXPECT_EQ(gas.bonds[0].a, 1u);
}

TEST(SceneCoordinates, ModelsOfAStructureFileAreFramesAsWell) {
    EXPECT_EQ(placed(kXyz, R"(, "coordinates_ref": "places", "model_index": 1)").atoms[2].position, glm::vec3(0, 1, 5));
    EXPECT_EQ(placed(dcd(1), R"(, "coordinates_ref": "places")", kXyz).atoms[2].position, glm::vec3(2, 12, 22));
}

TEST(SceneCoordinates, FaultsAreTold) {
    const auto fault = [](const std::string& coordinates, const std::string& params) -> std::string {
        try {
            placed(coordinates, params);
            return "none";
        } catch (const Error& error) {
            return error.what();
        }
    };
    const std::string ref = R"(, "coordinates_ref": "places")";
    EXPECT_NE(fault(dcd(1), "").find("structure 1: it is a topology without positions: it needs coordinates_ref"),
              std::string::npos);
    EXPECT_NE(fault(dcd(1), R"(, "coordinates_ref": "x")").find("there are no coordinates 'x'"), std::string::npos);
    EXPECT_NE(fault(dcd(1), ref + R"(, "model_index": 1)").find("there is no frame 2; it has 1"), std::string::npos);
    EXPECT_NE(fault("2\n\nO 0 0 0\nH 1 0 0\n", ref).find("it has 2 atoms, the structure 3"), std::string::npos);
    EXPECT_NE(fault(kPsf, ref).find("it is a topology without positions"), std::string::npos);
    EXPECT_NE(fault(dcd(1).substr(0, 60), ref), "none");
    const auto warnings = placed(dcd(1), R"(, "coordinates_ref": "x")", kXyz).guide->warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("structure 1: there are no coordinates 'x'"), std::string::npos);
}

}  // namespace
}  // namespace nacre::app::mvs
