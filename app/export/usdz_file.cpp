// USDZ: a text layer of USD with a picture of its colours.

#include <algorithm>
#include <charconv>
#include <glm/common.hpp>
#include <map>
#include <unordered_map>

#include "app/export/scene_files.h"
#include "app/export/usdz_package.h"
#include "engine/error.h"
#include "engine/scene/color/colors.h"

namespace nacre::app {
namespace {

constexpr std::uint32_t kRgb = 0xffffff;

void write(std::string& out, double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
    out.append(text, end);
}
void write(std::string& out, std::uint32_t value) { out += std::to_string(value); }
void write(std::string& out, const glm::vec3& p) {
    out += '(';
    for (int i = 0; i < 3; ++i) {
        if (i) out += ',';
        write(out, static_cast<double>(p[i] + 0.0f));  // avoids -0
    }
    out += ')';
}

/// [a, b, ...] of the values for each index.
template <typename Value>
std::string listed(std::size_t count, const Value& value) {
    std::string out = "[";
    for (std::size_t i = 0; i < count; ++i) {
        if (i) out += i % 16 ? "," : ",\n";
        write(out, value(i));
    }
    return out + "]";
}

/// The triangles of a part that have one opacity.
struct UsdPart {
    const ExportMesh* mesh;
    std::uint32_t opacity;
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> colors;  ///< of the triangles: positions in the sheet
};

class UsdzWriter {
public:
    UsdzWriter(const ExportScene& scene, const SceneFileOptions& options) : scene_(scene), options_(options) {}

    std::string run() {
        std::size_t triangles = 0;
        for (const ExportMesh& mesh : scene_.meshes) triangles += mesh.mesh.triangles.size();
        if (triangles > kMostUsdzTriangles)
            throw Error("cannot export molecule", "",
                        "it would have " + std::to_string(triangles) + " triangles, more than the limit of .usdz, " +
                            std::to_string(kMostUsdzTriangles) + " (fewer --sides, or .glb)");
        for (const ExportMesh& mesh : scene_.meshes) addParts(mesh);
        const std::string layer = this->layer();
        return storedArchive({{"scene.usda", layer}, {"colors.png", colorSheet(colors_)}});
    }

private:
    void addParts(const ExportMesh& mesh) {
        std::map<std::uint32_t, UsdPart> parts;
        for (const glm::uvec3& t : mesh.mesh.triangles) {
            // The colour shared by two corners.
            const std::uint32_t x = mesh.mesh.atoms[t.x], y = mesh.mesh.atoms[t.y], z = mesh.mesh.atoms[t.z];
            const std::uint32_t color = y == z ? y : x;
            UsdPart& part =
                parts.try_emplace(opacitySteps(color), UsdPart{&mesh, opacitySteps(color), {}, {}}).first->second;
            part.triangles.push_back(t);
            part.colors.push_back(indexColor(color & kRgb));
        }
        for (auto& [opacity, part] : parts) parts_.push_back(std::move(part));
    }

    std::uint32_t indexColor(std::uint32_t color) {
        const auto [known, added] = places_.emplace(color, static_cast<std::uint32_t>(colors_.size()));
        if (added) colors_.push_back(color);
        if (colors_.size() > kMostUsdzColors)
            throw Error("cannot export molecule", "",
                        "it has more colours than the limit of .usdz, " + std::to_string(kMostUsdzColors));
        return known->second;
    }

    std::string layer() const {
        return "#usda 1.0\n(\n    defaultPrim = \"Molecule\"\n    doc = \"" + printable(options_.title) +
               "\"\n    metersPerUnit = 0.01\n    upAxis = \"Y\"\n)\n\n"
               "def Xform \"Molecule\" (\n    kind = \"component\"\n)\n{\n" +
               placed() + materials() + meshes() + "}\n";
    }

    /// Stands the molecule on the ground, in the middle: viewers put the origin where the user points.
    std::string placed() const {
        glm::dvec3 low(1e300), high(-1e300);
        for (const ExportMesh& mesh : scene_.meshes)
            for (const glm::dmat4x3& transform : mesh.transforms)
                for (const glm::vec3& p : mesh.mesh.positions) {
                    const glm::dvec3 at = transform * glm::dvec4(p, 1.0);
                    low = glm::min(low, at), high = glm::max(high, at);
                }
        const glm::dvec3 to = scene_.meshes.empty()
                                  ? glm::dvec3(0)
                                  : -glm::dvec3(low.x + high.x, 2 * low.y, low.z + high.z) * 0.5 * options_.scale;
        std::string out = "    double3 xformOp:translate = ";
        write(out, glm::vec3(to));
        out += "\n    double3 xformOp:scale = ";
        write(out, glm::vec3(static_cast<float>(options_.scale)));
        return out + "\n    uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:scale\"]\n\n";
    }

    /// One material per opacity; all take their colour from the sheet.
    std::string materials() const {
        std::map<std::uint32_t, bool> opacities;
        for (const UsdPart& part : parts_) opacities[part.opacity] = true;
        std::string out = "    def Scope \"Materials\"\n    {\n";
        for (const auto& [opacity, used] : opacities) {
            const std::string name = materialName(opacity), path = "/Molecule/Materials/" + name;
            out += "        def Material \"" + name + "\"\n        {\n            token outputs:surface.connect = <" +
                   path +
                   "/Surface.outputs:surface>\n\n"
                   "            def Shader \"Surface\"\n            {\n"
                   "                uniform token info:id = \"UsdPreviewSurface\"\n"
                   "                color3f inputs:diffuseColor.connect = <" +
                   path +
                   "/Sheet.outputs:rgb>\n"
                   "                float inputs:metallic = 0\n"
                   "                float inputs:opacity = ";
            write(out, static_cast<double>(opacity) / kOpacitySteps);
            out +=
                "\n                float inputs:roughness = 0.6\n                token outputs:surface\n"
                "            }\n\n"
                "            def Shader \"Sheet\"\n            {\n"
                "                uniform token info:id = \"UsdUVTexture\"\n"
                "                asset inputs:file = @colors.png@\n"
                "                token inputs:sourceColorSpace = \"sRGB\"\n"
                "                float2 inputs:st.connect = <" +
                path +
                "/Place.outputs:result>\n"
                "                token inputs:wrapS = \"clamp\"\n                token inputs:wrapT = \"clamp\"\n"
                "                float3 outputs:rgb\n            }\n\n"
                "            def Shader \"Place\"\n            {\n"
                "                uniform token info:id = \"UsdPrimvarReader_float2\"\n"
                "                string inputs:varname = \"st\"\n                float2 outputs:result\n"
                "            }\n        }\n\n";
        }
        return out + "    }\n\n";
    }

    /// A group per copy. Copies refer to the mesh of the first, and each binds its own material: a reference does not
    /// include relationships that leave its target.
    std::string meshes() const {
        std::string out;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const UsdPart& part = parts_[i];
            const std::string name = identifier(part.mesh->name) + "_" + std::to_string(i + 1);
            for (std::size_t copy = 0; copy < part.mesh->transforms.size(); ++copy) {
                out += "    def Xform \"" + name + (copy ? "_copy_" + std::to_string(copy + 1) : "") +
                       "\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n"
                       "        rel material:binding = </Molecule/Materials/" +
                       materialName(part.opacity) + ">\n" + formatTransform(part.mesh->transforms[copy]);
                if (copy)
                    out += "\n        def Mesh \"Mesh\" (\n            prepend references = </Molecule/" + name +
                           "/Mesh>\n        )\n        {\n        }\n    }\n\n";
                else
                    out += "\n        def Mesh \"Mesh\"\n        {\n" + writeGeometry(part) + "        }\n    }\n\n";
            }
        }
        return out;
    }

    std::string writeGeometry(const UsdPart& part) const {
        // Parts of a mesh with several opacities keep only their own vertices.
        const Mesh& mesh = part.mesh->mesh;
        std::vector<std::uint32_t> kept, numbers(mesh.positions.size(), ~0u);
        for (const glm::uvec3& t : part.triangles)
            for (const std::uint32_t v : {t.x, t.y, t.z})
                if (numbers[v] == ~0u) {
                    numbers[v] = static_cast<std::uint32_t>(kept.size());
                    kept.push_back(v);
                }
        glm::vec3 low(mesh.positions[kept.front()]), high = low;
        for (const std::uint32_t v : kept)
            low = glm::min(low, mesh.positions[v]), high = glm::max(high, mesh.positions[v]);
        const std::vector<glm::uvec3>& t = part.triangles;
        const auto corner = [&](std::size_t i) { return t[i / 3][static_cast<int>(i % 3)]; };
        std::map<std::uint32_t, std::uint32_t> places;  // in this part's list of texture coordinates
        for (const std::uint32_t color : part.colors) places.emplace(color, 0);
        std::vector<std::uint32_t> used;
        for (auto& [color, place] : places) place = static_cast<std::uint32_t>(used.size()), used.push_back(color);
        std::string out = "            float3[] extent = [";
        write(out, low);
        out += ", ";
        write(out, high);
        return out + "]\n            bool doubleSided = " + (part.opacity < kOpacitySteps ? "1" : "0") +
               "\n            int[] faceVertexCounts = " + listed(t.size(), [](std::size_t) { return 3u; }) +
               "\n            int[] faceVertexIndices = " +
               listed(t.size() * 3, [&](std::size_t i) { return numbers[corner(i)]; }) +
               "\n            normal3f[] normals = " +
               listed(kept.size(), [&](std::size_t i) { return mesh.normals[kept[i]]; }) +
               " (\n                interpolation = \"vertex\"\n            )"
               "\n            point3f[] points = " +
               listed(kept.size(), [&](std::size_t i) { return mesh.positions[kept[i]]; }) +
               "\n            texCoord2f[] primvars:st = " + coordinates(used) +
               " (\n                interpolation = \"faceVarying\"\n            )"
               "\n            int[] primvars:st:indices = " +
               listed(t.size() * 3, [&](std::size_t i) { return places.at(part.colors[i / 3]); }) +
               "\n            uniform token subdivisionScheme = \"none\"\n";
    }

    /// Middles of blocks of the sheet; v grows upward.
    std::string coordinates(const std::vector<std::uint32_t>& colors) const {
        const std::uint32_t side = sheetSide(colors_.size());
        std::string out = "[";
        for (std::size_t i = 0; i < colors.size(); ++i) {
            out += i ? ", (" : "(";
            write(out, (colors[i] % side + 0.5) / side);
            out += ", ";
            write(out, 1 - (colors[i] / side + 0.5) / side);
            out += ')';
        }
        return out + "]";
    }

    static std::string formatTransform(const glm::dmat4x3& t) {
        if (t == glm::dmat4x3(1.0)) return {};
        std::string out = "        matrix4d xformOp:transform = (";
        for (int column = 0; column < 4; ++column) {
            out += column ? ", (" : " (";
            for (int row = 0; row < 3; ++row) {
                write(out, t[column][row] + 0.0);
                out += ", ";
            }
            out += column < 3 ? "0)" : "1)";
        }
        return out + " )\n        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n";
    }

    static std::string materialName(std::uint32_t opacity) {
        return opacity == kOpacitySteps ? "Opaque" : "Translucent_" + std::to_string(opacity);
    }

    static std::string identifier(std::string name) {
        std::replace_if(
            name.begin(), name.end(),
            [](char c) { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')); }, '_');
        return name;
    }

    /// Escapes text for quotes.
    static std::string printable(std::string text) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c < ' ' || c > '~' || c == '"' || c == '\\'; }, ' ');
        return text;
    }

    const ExportScene& scene_;
    const SceneFileOptions& options_;
    std::vector<UsdPart> parts_;
    std::vector<std::uint32_t> colors_;  ///< of the sheet
    std::unordered_map<std::uint32_t, std::uint32_t> places_;
};

}  // namespace

std::string usdzFile(const ExportScene& scene, const SceneFileOptions& options) {
    return UsdzWriter(scene, options).run();
}

}  // namespace nacre::app
