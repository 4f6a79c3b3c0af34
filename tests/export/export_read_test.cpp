// Files of triangles as other programs read them: Khronos' glTF validator, ADMesh for what is to be printed, and
// Assimp, which hands ADMesh what stands in PLY files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "tests/support/run_program.h"

namespace nacre::app {
namespace {

struct Exported {
    const char *name, *options;
};
/// Every kind of thing that is drawn, and every form of it.
constexpr Exported kKinds[] = {
    {"balls", "sample:glucose --style spacefill"},
    {"balls_instanced", "sample:glucose --style spacefill --atoms instanced"},
    {"sticks", "sample:glucose --style ball-and-stick --occlusion 8"},
    {"sticks_instanced", "sample:dna --style licorice --atoms instanced --color chain"},
    {"cartoon", "sample:dna --style cartoon --color chain --occlusion 8"},
    {"surface", "sample:glucose --style surface --surface-opacity 0.5 --occlusion 8"},
    {"gaussian", "sample:glucose --style surface --surface gaussian"},
    {"mixed", "sample:dna --style cartoon --show 'chain A=ball-and-stick' --scale 0.1"},
};

std::string captureOutput(const std::string& command, int& code) {
    const test::TemporaryFolder folder;
    const int status = std::system((command + " >'" + (folder / "out") + "' 2>&1").c_str());
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return test::readContents(folder / "out");
}

TEST(ExportRead, TheValidatorOfGltfFindsNothing) {
    const std::string validator = NACRE_SOURCE_DIR "/build/gltf_validator/node_modules/gltf-validator/index.js";
    if (!std::filesystem::exists(validator))
        GTEST_SKIP() << "no glTF validator here: tools/gltf_validator installs it into build/gltf_validator";
    const test::TemporaryFolder folder;
    const std::string validate =
        "cd '" + folder.path() + "' && node '" NACRE_SOURCE_DIR "/tests/export/validate_gltf.js' '" + validator + "'";
    std::string names;
    for (const Exported& kind : kKinds) {
        const std::string name = std::string(kind.name) + ".glb";
        const test::Outcome outcome = test::nacreIn(folder, "export " + std::string(kind.options) + " -o " + name);
        ASSERT_EQ(outcome.code, 0) << kind.name << ": " << outcome.err;
        names += " " + name;
    }
    int code = -1;
    const std::string said = captureOutput(validate + names, code);
    EXPECT_EQ(code, 0) << said;
    for (const Exported& kind : kKinds)
        EXPECT_NE(said.find(std::string(kind.name) + ".glb: 0 errors, 0 warnings"), std::string::npos) << said;
    // It reads what is in the buffers: indices of no vertex are found.
    std::string file = test::readContents(folder / "balls.glb");
    std::fill(file.end() - 8, file.end(), '\x7f');
    std::ofstream(folder / "spoilt.glb", std::ios::binary) << file;
    EXPECT_NE(captureOutput(validate + " spoilt.glb", code), "");
    EXPECT_EQ(code, 1);
}

TEST(ExportRead, UsdzPackagesKeepTheRulesOfUsdchecker) {
    const test::TemporaryFolder folder;
    const std::string check = "python3 '" NACRE_SOURCE_DIR "/tests/export/check_usdz.py' ";
    int code = -1;
    for (const Exported& kind : kKinds) {
        std::string options = kind.options;
        for (const char* glbOnly : {" --atoms instanced", " --occlusion 8"})
            if (const auto at = options.find(glbOnly); at != std::string::npos)
                options.erase(at, std::string(glbOnly).size());
        const test::Outcome outcome =
            test::nacreIn(folder, "export " + options + " --sides 8 --stats s.json -o a.usdz");
        ASSERT_EQ(outcome.code, 0) << kind.name << ": " << outcome.err;
        const std::string said = captureOutput(check + "'" + (folder / "a.usdz") + "'", code);
        ASSERT_EQ(code, 0) << kind.name << ": " << said;
        const auto read = nlohmann::json::parse(said);
        const auto parts = nlohmann::json::parse(test::readContents(folder / "s.json"))["parts"];
        EXPECT_EQ(read["metersPerUnit"], 0.01);
        EXPECT_EQ(read["scale"][0], std::string(kind.name) == "mixed" ? 0.1 : 1.0);
        ASSERT_EQ(read["parts"].size(), parts.size()) << kind.name;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const double volume = parts[i]["volume"];
            EXPECT_EQ(read["parts"][i]["triangles"], parts[i]["triangles"]) << kind.name;
            EXPECT_NEAR(read["parts"][i]["volume"].get<double>(), volume, 1e-4 * volume) << kind.name;
            EXPECT_EQ(read["parts"][i]["opacity"], std::string(kind.name) == "surface" ? 0.5 : 1.0);
        }
        if (std::string(kind.name) != "balls") continue;
        // Glucose, C6H12O6: 8 x 6 triangles per atom, in the colours of carbon, hydrogen and oxygen.
        std::vector<int> counts;
        for (const auto& [color, count] : read["parts"][0]["colors"].items()) counts.push_back(count);
        std::sort(counts.begin(), counts.end());
        EXPECT_EQ(counts, (std::vector<int>{6 * 48, 6 * 48, 12 * 48}));
    }
    // The judge finds what is packed otherwise, and a layer that was changed.
    const std::string repack = "cd '" + folder.path() +
                               "' && python3 -c \"import zipfile; a = zipfile.ZipFile('a.usdz'); b = "
                               "zipfile.ZipFile('b.usdz', 'w', zipfile.ZIP_";
    const std::string write = "); [b.writestr(n, a.read(n)) for n in a.namelist()]; b.close()\"";
    for (const char* how : {"DEFLATED", "STORED"}) {
        captureOutput(repack + how + write, code);
        ASSERT_EQ(code, 0);
        const std::string said = captureOutput(check + "'" + (folder / "b.usdz") + "'", code);
        EXPECT_EQ(code, 1) << said;
        EXPECT_NE(said.find(how[0] == 'D' ? "is compressed" : "begins at byte"), std::string::npos) << said;
    }
}

/// What ADMesh says of a file as it is, by the words of its report.
double numberIn(const std::string& report, const std::string& words) {
    std::smatch found;
    return std::regex_search(report, found, std::regex(words + " *: *([0-9.]+)")) ? std::stod(found[1]) : -1;
}

/// @param volume  what it encloses @param options  of ADMesh
void expectClosed(const std::string& file, const std::string& what, double volume, const std::string& options = "") {
    int code = -1;
    const std::string report = captureOutput("admesh --exact --normal-directions " + options + " '" + file + "'", code);
    ASSERT_EQ(code, 0) << what << ": " << report;
    EXPECT_GT(numberIn(report, "Number of facets"), 100) << what << ": " << report;
    for (const char* fault :
         {"Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"})
        EXPECT_EQ(numberIn(report, fault), 0) << what << ", " << fault << ": " << report;
    for (const char* open :
         {"Facets with 1 disconnected edge", "Facets with 2 disconnected edges", "Facets with 3 disconnected edges"})
        EXPECT_EQ(numberIn(report, open), 0) << what << ", " << open << ": " << report;
    EXPECT_NEAR(numberIn(report, "Volume"), volume, 1e-3 * volume) << what;
}

/// Triangles with places as they stand in a file, as the STL that ADMesh reads.
void writeStl(const std::string& path, const std::vector<glm::vec3>& places, const std::vector<glm::uvec3>& faces) {
    std::ofstream out(path);
    out.precision(9);
    out << "solid\n";
    for (const glm::uvec3& face : faces) {
        const glm::vec3 a = places.at(face.x), across = glm::cross(places.at(face.y) - a, places.at(face.z) - a);
        const glm::vec3 n = across / std::max(glm::length(across), 1e-12f);
        out << "facet normal " << n.x << " " << n.y << " " << n.z << "\nouter loop\n";
        for (const std::uint32_t corner : {face.x, face.y, face.z}) {
            const glm::vec3& p = places.at(corner);
            out << "vertex " << p.x << " " << p.y << " " << p.z << "\n";
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid\n";
}

void objAsStl(const std::string& from, const std::string& to) {
    std::vector<glm::vec3> places;
    std::vector<glm::uvec3> faces;
    std::istringstream obj(test::readContents(from));
    for (std::string line; std::getline(obj, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            glm::vec3& p = places.emplace_back();
            words >> p.x >> p.y >> p.z;
        } else if (kind == "f") {
            glm::uvec3& f = faces.emplace_back();
            std::string corner;
            for (int i = 0; i < 3 && words >> corner; ++i) f[i] = static_cast<std::uint32_t>(std::stoul(corner)) - 1;
        }
    }
    writeStl(to, places, faces);
}

TEST(ExportRead, AdmeshFindsNoOpenEdge) {
    const test::TemporaryFolder folder;
    for (const char* options : {"sample:glucose --style surface", "sample:glucose --style surface --surface gaussian",
                                "sample:dna --style cartoon"})
        for (const char* name : {"a.stl", "a.obj", "a.ply"}) {
            const test::Outcome outcome =
                test::nacreIn(folder, "export " + std::string(options) + " --stats s.json -o " + std::string(name));
            ASSERT_EQ(outcome.code, 0) << outcome.err;
            double volume = 0;
            const auto stats = nlohmann::json::parse(test::readContents(folder / "s.json"));
            for (const auto& part : stats["parts"]) volume += part["volume"].get<double>();
            std::string file = folder / name;
            std::string ofAdmesh;
            if (file.ends_with(".ply")) {
                const std::string ply = std::exchange(file, folder / "of_ply.stl");
                int code = -1;
                const std::string said = captureOutput("assimp export '" + ply + "' '" + file + "' -fstlb", code);
                ASSERT_EQ(code, 0) << said;
                ofAdmesh = "--normal-values";  // Assimp writes the mean of its corners' normals
            }
            if (file.ends_with(".obj")) {
                const std::string obj = std::exchange(file, folder / "of_obj.stl");
                objAsStl(obj, file);
            }
            expectClosed(file, std::string(options) + " " + name, volume, ofAdmesh);
        }
}

}  // namespace
}  // namespace nacre::app
