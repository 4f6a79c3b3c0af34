// STL, PLY and OBJ: with all copies, and vertices merged by position.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "app/export/scene_files.h"
#include "app/files/output_file.h"

namespace nacre::app {
namespace {

struct PlaceHash {
    std::size_t operator()(const std::array<float, 3>& p) const {
        std::size_t h = 0;
        for (const float v : p) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &v, sizeof bits);
            h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        }
        return h ^ h >> 32;
    }
};

/// Positions of a triangle's corners, their normals, and its colour.
struct PlainTriangle {
    std::array<glm::vec3, 3> corners, normals;
    std::uint32_t color = 0;
};

/// Visits each triangle of each copy that has three distinct corners.
template <typename BeginPart, typename Visit>
void eachTriangle(const ExportScene& scene, double scale, const BeginPart& beginPart, const Visit& visit) {
    for (const ExportMesh& part : scene.meshes) {
        beginPart(part.name);
        for (const glm::dmat4x3& transform : part.transforms)
            for (const glm::uvec3& t : part.mesh.triangles) {
                PlainTriangle triangle;
                for (int i = 0; i < 3; ++i) {
                    const glm::dvec3 p = transform * glm::dvec4(part.mesh.positions[t[i]], 1.0) + scene.center;
                    triangle.corners[static_cast<std::size_t>(i)] = glm::vec3(p * scale) + 0.0f;  // avoids -0
                    triangle.normals[static_cast<std::size_t>(i)] =
                        glm::vec3(transform * glm::dvec4(part.mesh.normals[t[i]], 0.0));
                }
                const auto& [a, b, c] = triangle.corners;
                if (a == b || b == c || c == a) continue;
                // The colour shared by two corners.
                const std::uint32_t x = part.mesh.atoms[t.x], y = part.mesh.atoms[t.y], z = part.mesh.atoms[t.z];
                triangle.color = y == z ? y : x;
                visit(triangle);
            }
    }
}

/// Numbers positions, from 0.
class Places {
public:
    /// @param isNew  receives whether the position is new
    std::uint32_t number(const glm::vec3& p, bool& isNew) {
        const auto [found, added] =
            known_.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(known_.size()));
        isNew = added;
        return found->second;
    }
    std::size_t size() const { return known_.size(); }

private:
    std::unordered_map<std::array<float, 3>, std::uint32_t, PlaceHash> known_;
};

template <typename T>
void append(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}
void append(std::string& out, const glm::vec3& p) {
    for (const float v : {p.x, p.y, p.z}) append(out, v);
}

}  // namespace

std::vector<std::string> sceneEndings() { return {".glb", ".usdz", ".ply", ".stl", ".obj"}; }

bool isSceneName(const std::string& path) { return std::ranges::count(sceneEndings(), fileExtension(path)) > 0; }

std::string sceneFile(const ExportScene& scene, const std::string& ending, const SceneFileOptions& options) {
    if (ending == ".glb") return glbFile(scene, options);
    if (ending == ".usdz") return usdzFile(scene, options);
    if (ending == ".ply") return plyFile(scene, options);
    if (ending == ".stl") return stlFile(scene, options);
    return objFile(scene, options);
}

std::string stlFile(const ExportScene& scene, const SceneFileOptions& options) {
    std::string out(80, ' ');
    // Readers mistake a header that begins with "solid" for a text file.
    const std::string title = ("nacre: " + options.title).substr(0, 80);
    std::copy(title.begin(), title.end(), out.begin());
    std::uint32_t count = 0;
    append(out, count);
    eachTriangle(
        scene, options.scale, [](const std::string&) {},
        [&](const PlainTriangle& t) {
            const glm::dvec3 across = glm::cross(glm::dvec3(t.corners[1]) - glm::dvec3(t.corners[0]),
                                                 glm::dvec3(t.corners[2]) - glm::dvec3(t.corners[0]));
            const double length = glm::length(across);
            append(out, length > 0 ? glm::vec3(across / length) : glm::vec3(0));
            for (const glm::vec3& corner : t.corners) append(out, corner);
            out.append(2, '\0');
            ++count;
        });
    std::memcpy(out.data() + 80, &count, sizeof count);
    return out;
}

std::string plyFile(const ExportScene& scene, const SceneFileOptions& options) {
    std::string vertices, faces;
    Places places;
    std::size_t count = 0;
    eachTriangle(
        scene, options.scale, [](const std::string&) {},
        [&](const PlainTriangle& t) {
            faces.push_back(3);
            for (const glm::vec3& corner : t.corners) {
                bool isNew = false;
                append(faces, places.number(corner, isNew));
                if (isNew) append(vertices, corner);
            }
            for (int i = 0; i < 3; ++i) faces.push_back(static_cast<char>(t.color >> 8 * i & 255));
            ++count;
        });
    std::string title = options.title;
    std::replace_if(
        title.begin(), title.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return "ply\nformat binary_little_endian 1.0\ncomment nacre: " + title + "\nelement vertex " +
           std::to_string(places.size()) + "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(count) +
           "\nproperty list uchar uint vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
           "end_header\n" +
           vertices + faces;
}

std::string objFile(const ExportScene& scene, const SceneFileOptions& options) {
    std::string title = options.title, out;
    std::replace_if(
        title.begin(), title.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    out = "# nacre: " + title + "\n";
    Places places, normals;
    char line[160];
    eachTriangle(
        scene, options.scale,
        [&](std::string name) {
            std::replace_if(
                name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
            out += "g " + name + "\n";
        },
        [&](const PlainTriangle& t) {
            std::string face = "f";
            for (std::size_t i = 0; i < 3; ++i) {
                bool isNew = false;
                const glm::vec3 &p = t.corners[i], &n = t.normals[i];
                const std::uint32_t place = places.number(p, isNew);
                if (isNew) {
                    const auto share = [&](int shift) { return static_cast<double>(t.color >> shift & 255) / 255; };
                    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g %.4g %.4g %.4g\n", static_cast<double>(p.x),
                                  static_cast<double>(p.y), static_cast<double>(p.z), share(0), share(8), share(16));
                    out += line;
                }
                const std::uint32_t normal = normals.number(n, isNew);
                if (isNew) {
                    std::snprintf(line, sizeof line, "vn %.5g %.5g %.5g\n", static_cast<double>(n.x),
                                  static_cast<double>(n.y), static_cast<double>(n.z));
                    out += line;
                }
                face += ' ' + std::to_string(place + 1) + "//" + std::to_string(normal + 1);
            }
            out += face + '\n';
        });
    return out;
}

}  // namespace nacre::app
