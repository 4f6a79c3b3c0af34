// VTP meshes in each of the codings that VTK writes.

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "app/mvs/mesh_files.h"
#include "app/mvs/value_palette.h"
#include "engine/error.h"
#include "tests/support/error_text.h"

namespace nacre::app::mvs {
namespace {

std::string base64(const std::string& bytes) {
    constexpr std::string_view kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kSigns[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// How a file keeps its arrays.
struct Coding {
    std::string format = "ascii";
    bool base64 = true;  ///< of appended data
    bool compressed = false, longHeaders = false, big = false, padded = true;
};

/// A square pyramid of triangles around a quadrilateral, with values of points and of cells.
class VtpWriter {
public:
    explicit VtpWriter(const Coding& coding) : coding_(coding) {}

    std::string write() {
        const std::string points = array<float>("Float32", "Points", 3, {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 2, 2, 3}),
                          height = array<double>("Float64", "height", 1, {0, 0, 5, 0, 10}),
                          normals =
                              array<float>("Float32", "normals", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1}),
                          area = array<std::int16_t>("Int16", "area", 1, {-1, 16, 4, 4}),
                          corners = array<std::int64_t>("Int64", "connectivity", 1, {0, 3, 2, 1, 0, 1, 4}),
                          ends = array<std::int32_t>("Int32", "offsets", 1, {4, 7}),
                          strip = array<std::uint32_t>("UInt32", "connectivity", 1, {1, 2, 4, 3}),
                          stripEnds = array<std::uint8_t>("UInt8", "offsets", 1, {4});
        std::string file = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"" +
                           std::string(coding_.big ? "BigEndian" : "LittleEndian") + "\" header_type=\"" +
                           (coding_.longHeaders ? "UInt64" : "UInt32") + "\"" +
                           (coding_.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") +
                           ">\n<PolyData>\n<Piece NumberOfPoints=\"5\" NumberOfVerts=\"1\" NumberOfStrips=\"1\" "
                           "NumberOfPolys=\"2\">\n<PointData>" +
                           height + normals + "</PointData>\n<CellData>" + area + "</CellData>\n<Points>" + points +
                           "</Points>\n<Polys>" + corners + ends + "</Polys>\n<Strips>" + strip + stripEnds +
                           "</Strips>\n</Piece>\n</PolyData>\n";
        if (coding_.format == "appended")
            file += "<AppendedData encoding=\"" + std::string(coding_.base64 ? "base64" : "raw") + "\">\n _" +
                    appended_ + "\n</AppendedData>\n";
        return file + "</VTKFile>\n";
    }

private:
    template <typename Value>
    std::string bytesOf(Value value) const {
        std::string bytes(reinterpret_cast<const char*>(&value), sizeof(Value));
        return coding_.big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;  // on a little-endian machine
    }
    std::string header(const std::vector<std::size_t>& sizes) const {
        std::string bytes;
        for (const std::size_t size : sizes)
            bytes += coding_.longHeaders ? bytesOf(std::uint64_t{size}) : bytesOf(static_cast<std::uint32_t>(size));
        return bytes;
    }

    template <typename Value>
    std::string array(const std::string& type, const std::string& name, int components,
                      const std::vector<Value>& values) {
        std::string text, bytes;
        for (const Value value : values) {
            text += std::to_string(value) + ' ';
            bytes += bytesOf(value);
        }
        std::string head = header({bytes.size()});
        if (coding_.compressed) {
            constexpr std::size_t kBlock = 16;
            std::vector<std::size_t> sizes{(bytes.size() + kBlock - 1) / kBlock, kBlock, bytes.size() % kBlock};
            std::string packed;
            for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
                const std::string block = bytes.substr(at, kBlock);
                std::string out(compressBound(static_cast<uLong>(block.size())), '\0');
                auto size = static_cast<uLongf>(out.size());
                compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
                         static_cast<uLong>(block.size()));
                packed.append(out, 0, size);
                sizes.push_back(size);
            }
            head = header(sizes);
            bytes = packed;
        }
        if (coding_.format == "binary" || coding_.base64)
            bytes = coding_.padded ? base64(head) + base64(bytes) : base64(head + bytes);
        else
            bytes = head + bytes;
        const std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                                std::to_string(components) + "\" format=\"" + coding_.format + "\"";
        const std::string key = "<InformationKey name=\"L2_NORM_RANGE\">1 2 3</InformationKey>";
        if (coding_.format == "ascii") return tag + ">\n" + text + key + "\n</DataArray>\n";
        if (coding_.format == "binary") return tag + ">\n  " + bytes + key + "\n</DataArray>\n";
        const std::string offset = std::to_string(appended_.size());
        appended_ += bytes;
        return tag + " offset=\"" + offset + "\"/>\n";
    }

    Coding coding_;
    std::string appended_;
};

std::string square(const Coding& coding = {}) { return VtpWriter(coding).write(); }

MeshColoring byArray(const std::string& name, bool ofCells = false) {
    MeshColoring coloring;
    coloring.source = MeshColoring::Source::array;
    coloring.array = name;
    coloring.arrayOfCells = ofCells;
    coloring.scale = {packedColor(0), packedColor(0xffffff)};
    return coloring;
}
/// Blue of each vertex, 0 to 255.
std::vector<int> shades(const MeshColoring& coloring, const std::string& file = square()) {
    std::vector<int> shades;
    for (const PrimitiveLook& look : readVtp("a.vtp", file, coloring).looks)
        shades.push_back(static_cast<int>(look.color >> 16 & 0xff));
    return shades;
}

TEST(VtpFiles, ReadInEachCoding) {
    std::vector<Coding> codings{{}};
    for (const bool compressed : {false, true})
        for (const bool longHeaders : {false, true})
            for (const bool big : {false, true}) {
                codings.push_back({"binary", true, compressed, longHeaders, big, true});
                codings.push_back({"appended", true, compressed, longHeaders, big, true});
                codings.push_back({"appended", false, compressed, longHeaders, big, true});
                if (!compressed) codings.push_back({"binary", true, false, longHeaders, big, false});
            }
    for (const Coding& coding : codings) {
        SCOPED_TRACE(coding.format + (coding.base64 ? " base64" : " raw") + (coding.compressed ? " compressed" : "") +
                     (coding.longHeaders ? " long" : "") + (coding.big ? " big" : "") +
                     (coding.padded ? "" : " whole"));
        const Primitives::Mesh mesh = readVtp("a.vtp", square(coding), byArray("height"));
        ASSERT_EQ(mesh.positions.size(), 5u);
        EXPECT_EQ(mesh.positions[4], glm::dvec3(2, 2, 3));
        EXPECT_EQ(mesh.triangles,
                  (std::vector<std::array<std::uint32_t, 3>>{{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}}));
        EXPECT_TRUE(mesh.blends);
        EXPECT_EQ(shades(byArray("height"), square(coding)), (std::vector<int>{0, 0, 128, 0, 255}));
    }
}

TEST(VtpFiles, ColoursByPointsAndCells) {
    MeshColoring narrow = byArray("height");
    narrow.domain = {5, 7};
    EXPECT_EQ(shades(narrow), (std::vector<int>{0, 0, 0, 0, 255}));
    // Cells after the vertex: the quadrilateral 16 with two triangles, 4, and the strip 4.
    EXPECT_EQ(shades(byArray("area", true)), (std::vector<int>{255, 128, 191, 191, 0}));
    EXPECT_EQ(shades(byArray("normals")), (std::vector<int>(5, 255))) << "equal lengths, from 0";
    EXPECT_TRUE(readVtp("a.vtp", square(), byArray("area")).looks.empty()) << "an array of cells";
    EXPECT_TRUE(readVtp("a.vtp", square()).looks.empty());
}

TEST(VtpFiles, PiecesBecomeOneMesh) {
    std::string file = square();
    const std::size_t begin = file.find("<Piece"), end = file.find("</PolyData>");
    file.insert(end, file.substr(begin, end - begin));
    const Primitives::Mesh mesh = readVtp("a.vtp", file, byArray("area", true));
    ASSERT_EQ(mesh.positions.size(), 10u);
    ASSERT_EQ(mesh.triangles.size(), 10u);
    EXPECT_EQ(mesh.triangles[5], (std::array<std::uint32_t, 3>{5, 8, 7}));
    EXPECT_EQ(mesh.looks[9].color, mesh.looks[4].color);
}

TEST(VtpFiles, FaultsNameTheirPlace) {
    const auto fault = [](const std::string& from, const std::string& to, const std::string& file = square()) {
        std::string text = file;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        return test::errorText([&] { readVtp("a.vtp", text, byArray("height")); }).substr(25);
    };
    EXPECT_EQ(fault("PolyData", "ImageData"), "it is no VTP file: no VTKFile of type PolyData");
    EXPECT_EQ(fault("</Points>", ""), "line 34: it is no XML: mismatched tag");
    EXPECT_EQ(fault("<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile"), "line 2: it has a document type");
    EXPECT_EQ(fault("byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order"),
              "line 2: it is compressed by vtkLZ4DataCompressor, not by zlib");
    EXPECT_EQ(fault("NumberOfPoints=\"5\"", "NumberOfPoints=\"6\""), "points: it has 15 of 18 values");
    EXPECT_EQ(fault("NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\""), "line 4: NumberOfPoints is not usable");
    EXPECT_EQ(fault("\n0 3 2 1", "\n0 3 2 5"), "polygon 1: a face names a vertex that is not there");
    EXPECT_EQ(fault("\n4 7 ", "\n4 8 "), "polygon 2: its offset is not usable");
    EXPECT_EQ(fault("\n4 7 ", "\n2 7 "), "polygon 1: a face has fewer than three corners");
    EXPECT_EQ(fault("\n0.000000 0.000000 5", "\n0.000000 x 5"), "values: 'x' is no number");
    EXPECT_EQ(fault("\"Float64\"", "\"Float16\""), "line 5: an array of unknown type");
    EXPECT_EQ(fault("Name=\"offsets\"", "Name=\"offset\""), "polygons, offsets: it is missing");
    const std::string binary = square({"appended", false, true, false, false, true});
    EXPECT_EQ(fault("offset=\"0\"", "offset=\"9000\"", binary), "points: it begins after the appended data");
    std::string large(binary);
    large[binary.find("\n _") + 3 + 6] = '\x7f';  // size of each block
    EXPECT_EQ(fault("<VTKFile", "<VTKFile", large).find("points: "), 0u);
}

// Each is a mesh or an error; run under sanitizers.
TEST(VtpFiles, DamagedFilesAreMeshesOrErrors) {
    std::mt19937 random(7);
    for (const Coding& coding :
         {Coding{}, Coding{"binary", true, true, false, false, true},
          Coding{"appended", false, true, true, false, true}, Coding{"appended", true, false, false, true, true}}) {
        const std::string whole = square(coding);
        for (int i = 0; i < 3000; ++i) {
            std::string file = whole;
            for (unsigned changes = random() % 4 + 1; changes > 0; --changes)
                file[random() % file.size()] =
                    random() % 2 ? static_cast<char>(random()) : "0123456789\"<>="[random() % 14];
            if (i % 10 == 0) file.resize(random() % file.size());
            try {
                const Primitives::Mesh mesh = readVtp("a.vtp", file, byArray("area", true));
                EXPECT_FALSE(mesh.triangles.empty());
            } catch (const Error&) {
            }
        }
    }
}

TEST(VtpFiles, PalettesHaveMolstarsNames) {
    EXPECT_EQ(molstarColorList("viridis"), namedColorList("Viridis"));
    EXPECT_EQ(molstarColorList("red-yellow-blue"), namedColorList("RdYlBu"));
    EXPECT_EQ(molstarColorList("set-1"), namedColorList("Set1"));
    EXPECT_FALSE(molstarColorList("cubehelix-default").empty());
    EXPECT_TRUE(molstarColorList("no-such").empty());
}

}  // namespace
}  // namespace nacre::app::mvs
