// Files of triangles: that they hold what is drawn, closed, and in the form that others read.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/export/scene_files.h"
#include "app/export/usdz_package.h"
#include "engine/error.h"
#include "engine/mesh/ellipsoids.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/color/colors.h"
#include "tests/mesh/mesh_checks.h"
#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

ExportScene exported(const Molecule& molecule, Style style, const ExportOptions& options = {}, Coloring color = {}) {
    const Representation scene = represent(molecule, drawnAtoms(molecule), {style, color, {}});
    return exportScene(molecule, scene, options);
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

nlohmann::json glbJson(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(wordAt(file, 4), 2u);
    EXPECT_EQ(wordAt(file, 8), file.size());
    EXPECT_EQ(file.substr(16, 4), "JSON");
    const std::size_t length = wordAt(file, 12), binary = 20 + length;
    EXPECT_EQ(length % 4, 0u);
    EXPECT_EQ(file.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(wordAt(file, binary), file.size() - binary - 8);
    return nlohmann::json::parse(file.substr(20, length));
}

TEST(Export, RefusesInstancesInVeryManyCopies) {
    const Molecule glucose = sampleMolecule("glucose");
    Representation scene = represent(glucose, drawnAtoms(glucose), {Style::spacefill, ColorScheme::element, {}});
    scene.copies.transforms = {glm::dmat4x3(1.0)};
    scene.copies.lists = {{0}};
    scene.copies.spheres = {{0, static_cast<std::uint32_t>(scene.spheres.size()), 0, {}, 10}};
    ExportOptions options{.instances = true};
    EXPECT_EQ(exportScene(glucose, scene, options).instances.size(), 3u);
    // Carbon, hydrogen and oxygen.
    scene.copies.lists[0].resize(kMostExportCopies / 3 + 1);
    EXPECT_THROW(exportScene(glucose, scene, options), Error);
}

TEST(Export, MeshesOfEllipsoidsAreAsFineAsTheirNumberAllows) {
    const Molecule glucose = sampleMolecule("glucose");
    Representation scene = represent(glucose, drawnAtoms(glucose), {Style::spacefill, ColorScheme::element, {}});
    scene.spheres.resize(3000, scene.spheres.front());
    scene.sphereLooks.resize(3000, scene.sphereLooks.front());
    scene.ellipsoids.resize(3000);
    const EllipsoidRows rows = ellipsoidRows({glm::dvec3(1, 0, 0), glm::dvec3(0, 0.5, 0), glm::dvec3(0, 0, 0.3)});
    const auto triangles = [&](int sides) { return triangleCount(exportScene(glucose, scene, {.sides = sides})); };
    const std::size_t plain = triangles(8);
    scene.ellipsoids.back() = rows;  // one
    EXPECT_EQ(triangles(8) - plain, trianglesPerEllipsoid(32) - 8 * 6);
    // Each of very many copies counts.
    scene.copies.transforms = {glm::dmat4x3(1.0)};
    scene.copies.lists = {std::vector<std::uint32_t>(kMostExportTriangles / trianglesPerEllipsoid(4) + 1)};
    scene.copies.spheres = {{2999, 1, 0, {}, 10}};
    EXPECT_THROW(exportScene(glucose, scene, {}), Error);
}

TEST(Export, BallsAndSticksAreClosedSolidsInTheirColours) {
    const Molecule glucose = sampleMolecule("glucose");
    const ExportScene scene = exported(glucose, Style::ballAndStick);
    ASSERT_EQ(scene.meshes.size(), 2u);
    for (const ExportMesh& part : scene.meshes) {
        EXPECT_EQ(test::openEdges(part.mesh), 0u) << part.name;
        EXPECT_GT(measure(part.mesh).volume, 1);
    }
    // 24 atoms of 24 sides: each 24 x 22 triangles.
    EXPECT_EQ(scene.meshes[0].mesh.triangles.size(), 24u * 24u * 22u);
}

/// The colours of a triangle's corners would be blended across it.
TEST(Export, EachTriangleOfASurfaceHasOneColour) {
    const ExportScene scene = exported(sampleMolecule("dna"), Style::surface, {}, ColorScheme::element);
    for (const ExportMesh& part : scene.meshes) {
        std::set<std::uint32_t> colors;
        for (const glm::uvec3& t : part.mesh.triangles) {
            ASSERT_EQ(part.mesh.atoms[t.x], part.mesh.atoms[t.y]) << part.name;
            ASSERT_EQ(part.mesh.atoms[t.x], part.mesh.atoms[t.z]) << part.name;
            colors.insert(part.mesh.atoms[t.x]);
        }
        EXPECT_GT(colors.size(), 2u) << part.name;
    }
}

TEST(Export, AnStlIsWhatItsHeaderSays) {
    const Molecule dna = sampleMolecule("dna");
    const ExportScene scene = exported(dna, Style::cartoon);
    const std::string stl = stlFile(scene, {"DNA", 2});
    EXPECT_NE(stl.substr(0, 5), "solid");
    const std::uint32_t count = wordAt(stl, 80);
    EXPECT_EQ(stl.size(), 84 + std::size_t{50} * count);
    EXPECT_LE(count, triangleCount(scene));
    // Twice as large, and closed: what it encloses is eight times as much.
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::array<float, 12> values{};
        std::memcpy(values.data(), stl.data() + 84 + std::size_t{50} * i, sizeof values);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::size_t c = 3; c < 12; c += 3) mesh.positions.emplace_back(values[c], values[c + 1], values[c + 2]);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    EXPECT_EQ(test::openEdges(mesh), 0u);
    double volume = 0;
    for (const ExportMesh& part : scene.meshes) volume += measure(part.mesh).volume;
    EXPECT_NEAR(measure(mesh).volume, 8 * volume, 0.01 * 8 * volume);
}

TEST(Export, PlyAndObjHaveEachPlaceOnce) {
    const Molecule dna = sampleMolecule("dna");
    const ExportScene scene = exported(dna, Style::cartoon);
    const std::string ply = plyFile(scene, {"a\nb", 1});
    const std::size_t vertexAt = ply.find("element vertex ") + 15, faceAt = ply.find("element face ") + 13;
    const std::size_t vertices = std::stoul(ply.substr(vertexAt)), faces = std::stoul(ply.substr(faceAt));
    const std::size_t header = ply.find("end_header\n") + 11;
    EXPECT_EQ(ply.size(), header + vertices * 12 + faces * 16);
    EXPECT_NE(ply.find("comment nacre: a b\n"), std::string::npos);

    std::istringstream obj(objFile(scene, {"DNA", 1}));
    std::map<std::string, std::size_t> lines;
    std::map<std::array<double, 3>, int> places;
    for (std::string line; std::getline(obj, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        ++lines[kind];
        if (kind != "v") continue;
        std::array<double, 3> place{};
        words >> place[0] >> place[1] >> place[2];
        EXPECT_EQ(++places[place], 1);
    }
    EXPECT_EQ(lines["v"], vertices);
    EXPECT_EQ(lines["f"], faces);
    EXPECT_EQ(lines["g"], scene.meshes.size());
}

TEST(Export, AGlbHasChainsColoursAndInstances) {
    const Molecule dna = sampleMolecule("dna");
    const nlohmann::json plain = glbJson(glbFile(exported(dna, Style::cartoon, {}, ColorScheme::chain), {"DNA", 1}));
    EXPECT_EQ(plain["nodes"][0]["name"], "DNA");
    EXPECT_EQ(plain["nodes"][1]["name"], "chain A, fold");
    EXPECT_FALSE(plain.contains("extensionsUsed"));
    EXPECT_TRUE(plain["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));

    const ExportScene scene = exported(dna, Style::licorice, ExportOptions{.instances = true});
    const nlohmann::json instanced = glbJson(glbFile(scene, {"DNA", 1}));
    EXPECT_EQ(instanced["extensionsRequired"][0], "EXT_mesh_gpu_instancing");
    std::size_t balls = 0;
    for (const auto& node : instanced["nodes"]) {
        if (!node.contains("extensions")) continue;
        const auto& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        const std::size_t count = instanced["accessors"][attributes["TRANSLATION"].get<int>()]["count"];
        EXPECT_EQ(instanced["accessors"][attributes["SCALE"].get<int>()]["count"], count);
        if (!attributes.contains("ROTATION")) balls += count;
    }
    EXPECT_EQ(balls, dna.atoms.size());
    EXPECT_EQ(triangleCount(scene), 0u);
}

/// Colours of the first mesh of a file: linear, with alpha.
std::vector<std::array<double, 4>> readColors(const std::string& file) {
    const nlohmann::json json = glbJson(file);
    const nlohmann::json& accessor =
        json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].get<std::size_t>()];
    const std::size_t offset = json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"];
    std::vector<std::array<double, 4>> colors(accessor["count"].get<std::size_t>());
    std::size_t at = 20 + wordAt(file, 12) + 8 + offset;
    for (auto& color : colors)
        for (double& channel : color) {
            std::uint16_t value = 0;
            std::memcpy(&value, file.data() + at, sizeof value);
            channel = value / 65535.0;
            at += sizeof value;
        }
    return colors;
}

/// As the listing of Jimenez et al. (2016) has it, for a visibility that never falls below 0.08.
double bounced(double visibility, double albedo) {
    const double a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    const double closed = std::max(0.16 - visibility, 0.0), v = visibility + closed * closed / 0.32;
    return std::max(v, ((v * a + b) * v + c) * v);
}

TEST(Export, OcclusionDarkensColoursAndIsAnAttribute) {
    const Molecule glucose = sampleMolecule("glucose");
    const auto bright = readColors(glbFile(exported(glucose, Style::spacefill), {"glucose", 1}));
    BakedOcclusion baked;  // everything as open as 51 of 255
    baked.sphereEdge = baked.around = baked.along = 4;
    baked.width = baked.sphereRows = baked.cylinderRows = 64;
    baked.texels.assign(64 * 256, 51);
    ExportOptions options{.occlusion = &baked};
    for (const Style style : {Style::spacefill, Style::licorice, Style::surface}) {
        const std::string file = glbFile(exported(glucose, style, options), {"glucose", 1});
        const nlohmann::json json = glbJson(file);
        for (const auto& mesh : json["meshes"]) {
            const auto& attributes = mesh["primitives"][0]["attributes"];
            ASSERT_TRUE(attributes.contains("_OCCLUSION"));
            EXPECT_EQ(json["accessors"][attributes["_OCCLUSION"].get<int>()]["count"],
                      json["accessors"][attributes["POSITION"].get<int>()]["count"]);
        }
        if (style != Style::spacefill) continue;
        const auto dark = readColors(file);
        ASSERT_EQ(dark.size(), bright.size());
        for (std::size_t v = 0; v < dark.size(); ++v)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto& b = bright[v];
                ASSERT_NEAR(dark[v][c], bright[v][c] * bounced(0.2, (b[0] + b[1] + b[2]) / 3), 4.0 / 65535);
            }
    }
}

TEST(Export, WhatIsTranslucentIsBlended) {
    const Molecule glucose = sampleMolecule("glucose");
    RepresentationOptions look{.style = Style::surface};
    for (const double opacity : {1.0, 0.25}) {
        look.surfaceOpacity = opacity;
        const Representation scene = represent(glucose, drawnAtoms(glucose), look);
        const std::string file = glbFile(exportScene(glucose, scene, {}), {"glucose", 1});
        for (const auto& color : readColors(file)) ASSERT_NEAR(color[3], opacity, 1.0 / 65535);
        EXPECT_EQ(glbJson(file)["materials"][0].value("alphaMode", "OPAQUE"), opacity < 1 ? "BLEND" : "OPAQUE");
    }
    look.style = Style::ballAndStick;
    look.atomOpacity = 0.25;
    ExportOptions options{.instances = true};
    const Representation scene = represent(glucose, drawnAtoms(glucose), look);
    for (const auto& material : glbJson(glbFile(exportScene(glucose, scene, options), {"glucose", 1}))["materials"]) {
        EXPECT_EQ(material["alphaMode"], "BLEND");
        EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][3], 0.25);
    }
}

TEST(Export, SticksOfInstancesStandWhereThoseOfTrianglesDo) {
    const Molecule glucose = sampleMolecule("glucose");
    const ExportScene scene = exported(glucose, Style::licorice, ExportOptions{.instances = true});
    double length = 0;
    for (const ExportInstances& part : scene.instances)
        for (const ExportInstances::Place& place : part.places) {
            EXPECT_NEAR(glm::length(glm::vec4(place.turn.x, place.turn.y, place.turn.z, place.turn.w)), 1, 1e-5);
            if (part.shape != ExportInstances::Shape::stick) continue;
            // A stick's far end is an atom, or the middle of a bond.
            const glm::vec3 end = place.at + place.turn * glm::vec3(0, 0, place.scale.z);
            length += place.scale.z;
            float nearest = 1e9f;
            for (const Bond& bond : glucose.bonds) {
                const glm::vec3 a = glucose.atoms[bond.a].position - glm::vec3(scene.center);
                const glm::vec3 b = glucose.atoms[bond.b].position - glm::vec3(scene.center);
                for (const glm::vec3& p : {a, b, (a + b) / 2.0f}) nearest = std::min(nearest, glm::distance(p, end));
            }
            EXPECT_LT(nearest, 1e-3f);
        }
    double bonds = 0;
    for (const Bond& bond : glucose.bonds)
        bonds += glm::distance(glucose.atoms[bond.a].position, glucose.atoms[bond.b].position);
    EXPECT_NEAR(length, bonds, 1e-3);
}

TEST(Export, CopiesOfAnAssemblyAreNodesOrWrittenOut) {
    Molecule molecule = sampleMolecule("glucose");
    molecule.subchains = {"A"};
    AssemblyPart part{{glm::mat4x3(1.0f), glm::mat4x3(1.0f)}, {0}};
    part.transforms[1][3] = {30, 0, 0};
    molecule.assemblies.push_back({"1", "", {part}});
    RepresentationOptions look{.style = Style::spacefill, .color = ColorScheme::copy, .rules = {}, .assembly = "1"};
    const Representation scene = represent(molecule, drawnAtoms(molecule), look);
    const ExportScene both = exportScene(molecule, scene, {});
    // Each copy has its own colour: two meshes, one node each.
    ASSERT_EQ(both.meshes.size(), 2u);
    EXPECT_NE(both.meshes[0].mesh.atoms, both.meshes[1].mesh.atoms);
    for (const ExportMesh& mesh : both.meshes)
        for (const std::uint32_t color : mesh.mesh.atoms) EXPECT_FALSE(isCopyTint(color));
    EXPECT_EQ(wordAt(stlFile(both, {"", 1}), 80), triangleCount(both));
    look.color = ColorScheme::element;
    const ExportScene same = exportScene(molecule, represent(molecule, drawnAtoms(molecule), look), {});
    ASSERT_EQ(same.meshes.size(), 1u);
    EXPECT_EQ(same.meshes[0].transforms.size(), 2u);
    EXPECT_TRUE(glbJson(glbFile(same, {"", 1}))["nodes"][2].contains("matrix"));
}

bool refused(const std::function<void()>& work, const std::string& why) {
    try {
        work();
    } catch (const Error& error) {
        return std::string(error.what()).find(why) != std::string::npos;
    }
    return false;
}

/// Triangles apart from each other, each in its own colour.
ExportScene coloredTriangles(std::size_t count) {
    ExportScene scene;
    ExportMesh& part = scene.meshes.emplace_back();
    part.transforms = {glm::dmat4x3(1.0)};
    const auto corners = static_cast<std::uint32_t>(count * 3);
    part.mesh.positions.resize(corners);
    part.mesh.normals.resize(corners, glm::vec3(0, 0, 1));
    for (std::uint32_t i = 0; i < corners; ++i) part.mesh.atoms.push_back(0xff000000 | i / 3);
    for (std::uint32_t i = 0; i < corners; i += 3) part.mesh.triangles.emplace_back(i, i + 1, i + 2);
    return scene;
}

TEST(Export, UsdzHoldsAsManyColorsAndTrianglesAsItStates) {
    ExportScene scene = coloredTriangles(kMostUsdzColors);
    const std::string file = usdzFile(scene, {"", 1});
    // The width of the picture of colours, behind its signature and the name of its first chunk.
    const std::size_t png = file.find("IHDR");
    ASSERT_NE(png, std::string::npos);
    EXPECT_EQ(file.substr(png + 4, 4), std::string("\0\0\x08\0", 4)) << "2048 pixels";
    scene = coloredTriangles(kMostUsdzColors + 1);
    EXPECT_TRUE(refused([&] { usdzFile(scene, {"", 1}); }, "more colours than the limit of .usdz"));
    scene.meshes[0].mesh.triangles.assign(kMostUsdzTriangles + 1, glm::uvec3(0, 1, 2));
    EXPECT_TRUE(refused([&] { usdzFile(scene, {"", 1}); }, "5000001 triangles, more than the limit"));
}

TEST(Export, AnArchiveEndsBeforeItsOffsetsOverflow) {
    const std::vector<PackedFile> files{{"a", std::string(1000, 'x')}, {"b", std::string(500, 'y')}};
    constexpr std::size_t kEnd = 1152 + 500;  // they begin at 64 and at 1152
    EXPECT_EQ(storedArchive(files, kEnd), storedArchive(files));
    EXPECT_TRUE(refused([&] { storedArchive(files, kEnd - 1); }, "limited to 4 GiB"));
}

TEST(Export, TheProgramWritesThemAndRefusesTheRest) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.glb", "a.usdz", "a.ply", "a.stl", "a.obj"}) {
        const test::Outcome outcome =
            test::nacreIn(folder, "export sample:dna --style cartoon --stats s.json -o " + std::string(name));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const auto stats = nlohmann::json::parse(test::readContents(folder / "s.json"));
        EXPECT_EQ(stats["bytes"], test::readContents(folder / name).size());
        EXPECT_GT(stats["parts"][0]["volume"], 10);
    }
    EXPECT_EQ(test::nacreIn(folder, "export sample:dna -o a.png").code, 2);
    EXPECT_EQ(test::nacreIn(folder, "export sample:dna -o b.stl --atoms instanced").code, 2);
    EXPECT_EQ(test::nacreIn(folder, "export sample:dna -o b.stl --sides 7").code, 2);
    const test::Outcome nothing = test::nacreIn(folder, "export sample:dna -o b.stl --hide all");
    EXPECT_EQ(nothing.code, 1);
    EXPECT_NE(nothing.err.find("no atom is left"), std::string::npos) << nothing.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "b.stl"));
}

}  // namespace
}  // namespace nacre::app
