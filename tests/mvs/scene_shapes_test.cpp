// Meshes of OBJ and PLY files in scenes.

#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "app/mvs/mesh_files.h"
#include "engine/error.h"
#include "tests/mvs/small_scene.h"
#include "tests/support/error_text.h"

namespace nacre::app::mvs {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::string kObj =
    "# a square and a triangle\r\nmtllib a.mtl\nv 0 0 0\nv 4 0 0 0.5 0.5 0.5\nv 4 4 0\nv 0 4 0\n"
    "vn 0 0 1\nf 1/1/1 2//1 3/3 4\nv 0 0 9\nf -1 1 2\n";
const std::string kPly =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property uchar red\nproperty double z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 255 7\n4 0 255 7\n4 4 0 7\n0 4 0 7\n4 0 1 2 3\n";

template <typename Value>
std::string bytesOf(Value value, bool big) {
    std::string bytes(sizeof(Value), '\0');
    std::memcpy(bytes.data(), &value, sizeof(Value));
    return big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;  // on a little-endian machine
}

/// A triangle, with an edge before its faces.
std::string binaryPly(bool big, std::int32_t corner) {
    std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty double z\nproperty float32 x\nproperty short y\n"
                       "element edge 1\nproperty int vertex1\nelement face 1\nproperty char flags\n"
                       "property list uchar int32 vertex_index\nend_header\n";
    for (int i = 0; i < 3; ++i)
        text += bytesOf(0.5, big) + bytesOf(float(i), big) + bytesOf(static_cast<std::int16_t>(i * i), big);
    text += bytesOf(std::int32_t{7}, big) + 'f' + '\3';
    for (const std::int32_t i : {0, 1, corner}) text += bytesOf(i, big);
    return text;
}

TEST(MeshFiles, ObjFacesBecomeFans) {
    const Primitives::Mesh mesh = readObj("a.obj", kObj);
    ASSERT_EQ(mesh.positions.size(), 5u);
    EXPECT_EQ(mesh.positions[4], glm::dvec3(0, 0, 9));
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 0, 1}}));
}

TEST(MeshFiles, PlyMayBeTextOrBinary) {
    const Primitives::Mesh text = readPly("a.ply", kPly);
    ASSERT_EQ(text.positions.size(), 4u);
    EXPECT_EQ(text.positions[2], glm::dvec3(4, 4, 7));
    EXPECT_EQ(text.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    for (const bool big : {false, true}) {
        const Primitives::Mesh binary = readPly("b.ply", binaryPly(big, 2));
        ASSERT_EQ(binary.positions.size(), 3u);
        EXPECT_EQ(binary.positions[2], glm::dvec3(2, 4, 0.5));
        EXPECT_EQ(binary.triangles, (Triangles{{0, 1, 2}}));
    }
}

TEST(MeshFiles, FaultsNameTheirPlace) {
    const auto obj = [](const std::string& text) { return test::errorText([&] { readObj("a.obj", text); }); };
    EXPECT_EQ(obj("v 0 0 0\nf 1 2 3\n"), "cannot read mesh: a.obj: line 2: a face names a vertex that is not there");
    EXPECT_EQ(obj("v 0 0 0\nf 1 1\n"), "cannot read mesh: a.obj: line 2: a face has fewer than three corners");
    EXPECT_EQ(obj("v 0 0 nan\n"), "cannot read mesh: a.obj: line 1: a vertex needs three numbers within 1e6 Å");
    EXPECT_EQ(obj("v 0 0 0\n"), "cannot read mesh: a.obj: it has no faces");
    EXPECT_EQ(obj("f " + std::string(1'000'000, '1')), "cannot read mesh: a.obj: line 1: it is too long");
    const auto ply = [](const std::string& text) { return test::errorText([&] { readPly("a.ply", text); }); };
    EXPECT_EQ(ply("plyx\n"), "cannot read mesh: a.ply: it does not begin with 'ply'");
    EXPECT_EQ(ply("ply\nformat ascii 1.0\n"), "cannot read mesh: a.ply: its header has no end");
    EXPECT_EQ(ply("ply\nformat text 1.0\n"), "cannot read mesh: a.ply: line 2: its format is unknown");
    EXPECT_EQ(ply(binaryPly(false, 3)), "cannot read mesh: a.ply: face 1: a face names a vertex that is not there");
    std::string odd = kPly;
    odd.replace(odd.find("4 0 1 2 3"), 9, "3 0 1 nan");
    EXPECT_EQ(ply(odd), "cannot read mesh: a.ply: face 1: a face names a vertex that is not there");
    EXPECT_EQ(ply(kPly.substr(0, kPly.size() - 4)), "cannot read mesh: a.ply: face 1: a number is missing");
    std::string many = kPly;  // states more than it holds, which takes no memory
    many.replace(many.find("vertex 4"), 8, "vertex 4000000000000000000");
    EXPECT_EQ(ply(many), "cannot read mesh: a.ply: vertex 6: a number is missing");
    const auto listOf = [](std::uint32_t count, const std::string& name) {
        return "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint uchar " + name +
               "\nend_header\n" + bytesOf(count, false) + std::string(count, '\0');
    };
    EXPECT_EQ(ply(listOf(10'000'003, "vertex_indices")), "cannot read mesh: a.ply: face 1: a list is too long");
    EXPECT_EQ(ply(listOf(10'000'003, "flags")), "cannot read mesh: a.ply: it has no faces");
}

Molecule shown(const std::string& children, const std::string& file = kObj, const std::string& format = "obj") {
    SceneSources sources;
    sources.fetch = [&](const std::string&) { return file; };
    const std::string json = R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "a"},
        "children": [{"kind": "parse", "params": {"format": ")" +
                             format + R"("}, "children": [{"kind": "shape", "children": [)" + children + "]}]}]}]}}";
    return buildScene(parseScene(json, "scene.mvsj"), 0, "scene.mvsj", sources);
}

SceneGuide shownWith(const std::string& custom, const std::string& file, const std::string& format) {
    SceneSources sources;
    sources.fetch = [&](const std::string&) { return file; };
    const std::string json = R"({"root": {"kind": "root", "children": [{"kind": "download", "params": {"url": "a"},
        "children": [{"kind": "parse", "params": {"format": ")" +
                             format + R"("}, "children": [{"kind": "shape", "custom": )" + custom +
                             R"(, "children": [{"kind": "opacity", "params": {"opacity": 0.5}}]}]}]}]}})";
    return *buildScene(parseScene(json, "scene.mvsj"), 0, "scene.mvsj", sources).guide;
}

TEST(SceneShapes, HaveAColourAnOpacityAndInstances) {
    const Molecule plain = shown("");
    ASSERT_EQ(plain.guide->primitives.meshes.size(), 1u);
    EXPECT_TRUE(plain.guide->warnings.empty());
    EXPECT_EQ(plain.guide->primitives.meshes[0].looks.at(0).color, 0xffffffffu);
    ASSERT_TRUE(plain.guide->camera);
    EXPECT_NEAR(plain.guide->camera->target.z, 3, 2);
    const Molecule drawn = shown(R"({"kind": "color", "params": {"color": "red"}},
        {"kind": "color", "params": {"color": "#00ff00"}}, {"kind": "opacity", "params": {"opacity": 0.5}},
        {"kind": "transform", "params": {"translation": [1,0,0]}},
        {"kind": "instance", "params": {"translation": [0,0,0]}},
        {"kind": "instance", "params": {"translation": [0,10,0]}})");
    EXPECT_TRUE(drawn.guide->warnings.empty());
    ASSERT_EQ(drawn.guide->primitives.meshes.size(), 2u);
    EXPECT_EQ(drawn.guide->primitives.meshes[0].positions[0], glm::dvec3(1, 0, 0));
    EXPECT_EQ(drawn.guide->primitives.meshes[1].positions[0], glm::dvec3(1, 10, 0));
    EXPECT_EQ(drawn.guide->primitives.meshes[1].looks.at(0).color, 0xff00ff00u);
    EXPECT_EQ(drawn.guide->primitives.meshes[1].looks.at(0).opacity, 0.5);
}

std::vector<std::uint32_t> colorsOf(const Primitives::Mesh& mesh) {
    std::vector<std::uint32_t> colors;
    for (const PrimitiveLook& look : mesh.looks) colors.push_back(look.color);
    return colors;
}

constexpr std::uint32_t kMeshGrey = packedColor(0x808080), kMeshBlue = packedColor(0x0000ff),
                        kMeshWhite = packedColor(0xffffff);

TEST(SceneShapes, TakeColoursOfVertices) {
    const std::string obj =
        "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 9\nv 0 1 0\nv 0 0 1 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
    const Primitives::Mesh tetrahedron = shownWith(R"({"obj_coloring": "vertex"})", obj, "obj").primitives.meshes.at(0);
    EXPECT_TRUE(tetrahedron.blends);
    EXPECT_EQ(colorsOf(tetrahedron),
              (std::vector<std::uint32_t>{packedColor(0xff0000), packedColor(0x0080ff), kMeshWhite, kMeshBlue}));
    std::string ply = kPly;
    ply.replace(ply.find("property uchar red"), 18, "property uchar red\nproperty uchar green\nproperty uchar blue");
    for (std::size_t at; (at = ply.find(" 255 7")) != std::string::npos;) ply.replace(at, 6, " 9 8 7 7");
    ply.replace(ply.find("4 4 0 7\n0 4 0 7"), 15, "4 4 0 0 255 7\n0 4 0 0 255 7");
    const Primitives::Mesh square = shownWith(R"({"ply_coloring": "vertex"})", ply, "ply").primitives.meshes.at(0);
    EXPECT_EQ(colorsOf(square),
              (std::vector<std::uint32_t>{packedColor(0x090807), packedColor(0x090807), kMeshBlue, kMeshBlue}));
    EXPECT_EQ(shownWith(R"({"ply_coloring": "uniform"})", ply, "ply").primitives.meshes.at(0).looks.size(), 1u);
    // Shares, in a file of floating-point numbers.
    std::string shares = ply;
    for (const char* channel : {"red", "green", "blue"})
        shares.replace(shares.find(std::string("uchar ") + channel), 5, "float");
    EXPECT_EQ(colorsOf(shownWith(R"({"ply_coloring": "vertex"})", shares, "ply").primitives.meshes.at(0))[2],
              kMeshBlue);
}

TEST(SceneShapes, TakeValuesOfVtp) {
    const std::string vtp =
        "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='3' NumberOfPolys='1'><PointData>"
        "<DataArray type='Float32' Name='q'>0 5 10</DataArray></PointData><Points>"
        "<DataArray type='Float32' NumberOfComponents='3'>0 0 0 1 0 0 0 1 0</DataArray></Points><Polys>"
        "<DataArray type='Int32' Name='connectivity'>0 1 2</DataArray>"
        "<DataArray type='Int32' Name='offsets'>3</DataArray></Polys></Piece></PolyData></VTKFile>";
    const SceneGuide plain = shownWith("{}", vtp, "vtp");
    EXPECT_EQ(colorsOf(plain.primitives.meshes.at(0)), std::vector<std::uint32_t>{kMeshWhite});
    const SceneGuide shaded =
        shownWith(R"({"vtp_attribute": "q", "vtp_palette": "greys", "vtp_domain": [0, 5]})", vtp, "vtp");
    EXPECT_TRUE(shaded.warnings.empty());
    EXPECT_EQ(colorsOf(shaded.primitives.meshes.at(0)),
              (std::vector<std::uint32_t>{kMeshWhite, packedColor(0), packedColor(0)}));
    const SceneGuide odd = shownWith(R"({"vtp_attribute": "p", "vtp_palette": "pink", "vtp_domain": 1})", vtp, "vtp");
    EXPECT_EQ(odd.warnings.size(), 3u);
    EXPECT_EQ(colorsOf(odd.primitives.meshes.at(0)), std::vector<std::uint32_t>{kMeshWhite});
}

TEST(SceneShapes, TakeColoursOfMaterials) {
    const std::string obj =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nusemtl shell\nf 1 2 3 4\nusemtl core\nf 1 2 3\n";
    const std::string custom =
        R"({"obj_coloring": "custom", "obj_material_colors": {"shell": "blue", "core": "#fff"}})";
    const Primitives::Mesh mesh = shownWith(custom, obj, "obj").primitives.meshes.at(0);
    EXPECT_FALSE(mesh.blends);
    EXPECT_EQ(colorsOf(mesh), (std::vector<std::uint32_t>{kMeshGrey, kMeshBlue, kMeshBlue, kMeshWhite}));
    EXPECT_EQ(mesh.looks[1].opacity, 0.5);
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property int material_index\nelement face 1\nproperty list uchar int vertex_indices\n"
        "element material 2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
        "0 0 0 1\n1 0 0 0\n0 1 0 7\n3 0 1 2\n0 0 255\n255 255 255\n";
    EXPECT_EQ(colorsOf(shownWith(R"({"ply_coloring": "material"})", ply, "ply").primitives.meshes.at(0)),
              (std::vector<std::uint32_t>{kMeshWhite, kMeshBlue, kMeshGrey}));
}

TEST(SceneShapes, TellOfColoursThatAreNotThere) {
    const auto told = [](const std::string& custom, const std::string& format) {
        const SceneGuide guide = shownWith(custom, format == "ply" ? kPly : kObj, format);
        return guide.warnings.empty() ? "" : guide.warnings[0];
    };
    EXPECT_NE(told(R"({"ply_coloring": "vertex"})", "ply").find("its file has no such colours"), std::string::npos);
    EXPECT_NE(told(R"({"ply_coloring": "custom"})", "ply").find("there is no ply_coloring 'custom'"),
              std::string::npos);
    EXPECT_NE(told(R"({"obj_coloring": "custom", "obj_material_colors": {"a": "none"}})", "obj")
                  .find("there is no colour of material 'a"),
              std::string::npos);
    EXPECT_EQ(told(R"({"obj_coloring": "vertex", "molstar_mesh_params": {}})", "obj"), "");
}

TEST(SceneShapes, TellOfSelectors) {
    const Molecule drawn = shown(R"({"kind": "color", "params": {"color": "red", "selector": "all"}})");
    ASSERT_EQ(drawn.guide->warnings.size(), 1u);
    EXPECT_NE(drawn.guide->warnings[0].find("color 1: its parameter 'selector' is not used"), std::string::npos);
}

TEST(SceneShapes, AreClippedAndFocused) {
    const Molecule cut = shown(R"({"kind": "clip", "params": {"type": "plane", "normal": [0,0,1], "point": [0,0,1]}},
        {"kind": "focus", "params": {"radius": 77}})");
    EXPECT_TRUE(cut.guide->warnings.empty());
    EXPECT_EQ(cut.guide->primitives.meshes.at(0).triangles.size(), 2u);
    EXPECT_EQ(cut.guide->camera->radius, 77);
}

// A triangle among a million vertices, 5000 times: 120 GB, were it not refused.
TEST(SceneShapes, InstancesTakeNoMoreThanTheLimit) {
    std::string file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", instances;
    for (int i = 0; i < 1'000'000; ++i) file += "v 0 0 0\n";
    for (int i = 0; i < 5000; ++i) instances += R"({"kind": "instance", "params": {"translation": [0,0,9]}},)";
    const std::string why =
        test::errorText([&] { shown(instances + R"({"kind": "color", "params": {"color": "red"}})", file); });
    EXPECT_NE(why.find("more than 20000000 triangles or vertices"), std::string::npos) << why;
}

TEST(SceneShapes, FilesThatCannotBeReadAreLeftOut) {
    const auto why = [](const std::string& file, const std::string& format) {
        return test::errorText([&] { shown("", file, format); });
    };
    EXPECT_NE(why("v 1 2\n", "obj").find("shape 1: it is left out: cannot read mesh: a: line 1"), std::string::npos);
    EXPECT_NE(why("solid", "stl").find("its format is not obj, ply or vtp"), std::string::npos);
    EXPECT_EQ(shown("", kPly, "ply").guide->primitives.meshes.at(0).triangles.size(), 2u);
}

}  // namespace
}  // namespace nacre::app::mvs
