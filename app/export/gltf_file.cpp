#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/export/scene_files.h"
#include "engine/baked_occlusion.h"
#include "engine/scene/color/colors.h"
#include "engine/srgb.h"

namespace nacre::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedInt = 5125, kUnsignedShort = 5123;  // componentType
constexpr int kVertices = 34962, kIndices = 34963;                        // target

float toLinear(std::uint32_t color, int channel) {
    return srgbToLinear(static_cast<float>(color >> 8 * channel & 255) / 255.0f);
}

/// The two chunks of the file under construction.
class GltfWriter {
public:
    GltfWriter(const ExportScene& scene, const SceneFileOptions& options) : scene_(scene), options_(options) {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "nacre"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", {0}}}})},
                 {"nodes", Json::array()},
                 {"meshes", Json::array()},
                 {"materials", Json::array()},
                 {"accessors", Json::array()},
                 {"bufferViews", Json::array()}};
    }

    std::string run() {
        const glm::dvec3 at = scene_.center * options_.scale;
        json_["nodes"].push_back({{"name", options_.title},
                                  {"translation", {at.x, at.y, at.z}},
                                  {"scale", {options_.scale, options_.scale, options_.scale}},
                                  {"children", Json::array()}});
        for (const ExportMesh& part : scene_.meshes) addMesh(part);
        for (const ExportInstances& part : scene_.instances) addInstances(part);
        if (!scene_.instances.empty())
            json_["extensionsUsed"] = json_["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
        return file();
    }

private:
    template <typename T>
    int addAccessor(const std::vector<T>& values, int component, const char* type, int target) {
        while (binary_.size() % 4) binary_.push_back('\0');
        const std::size_t bytes = values.size() * sizeof(T);
        Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes}};
        if (target) view["target"] = target;
        json_["bufferViews"].push_back(view);
        binary_.append(reinterpret_cast<const char*>(values.data()), bytes);
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", values.size()},
                                      {"type", type}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    int addPositions(const std::vector<glm::vec3>& positions) {
        const int accessor = addAccessor(positions, kFloat, "VEC3", kVertices);
        glm::vec3 low(positions.front()), high(positions.front());
        for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
        json_["accessors"].back()["min"] = {low.x, low.y, low.z};
        json_["accessors"].back()["max"] = {high.x, high.y, high.z};
        return accessor;
    }

    /// Vertex colours in linear light, darkened as the renderer does.
    int addColors(const Mesh& mesh, const std::vector<float>& occlusion) {
        std::vector<std::array<std::uint16_t, 4>> colors;
        for (std::size_t v = 0; v < mesh.atoms.size(); ++v) {
            const std::uint32_t c = mesh.atoms[v];
            const glm::vec3 base(toLinear(c, 0), toLinear(c, 1), toLinear(c, 2));
            const glm::vec3 lit = occlusion.empty() ? base : base * reachingLight(base, occlusion[v]);
            std::array<std::uint16_t, 4> linear{};
            for (int i = 0; i < 3; ++i)
                linear[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(lit[i] * 65535.0f + 0.5f);
            linear[3] = static_cast<std::uint16_t>(65535u * opacitySteps(c) / kOpacitySteps);
            colors.push_back(linear);
        }
        const int accessor = addAccessor(colors, kUnsignedShort, "VEC4", kVertices);
        json_["accessors"].back()["normalized"] = true;
        return accessor;
    }

    /// @param color  for the whole mesh; empty: per vertex @param occlusion  per vertex, or empty
    std::size_t addGeometry(const std::string& name, const Mesh& mesh, std::optional<std::uint32_t> color,
                            const std::vector<float>& occlusion = {}) {
        Json attributes = {{"POSITION", addPositions(mesh.positions)},
                           {"NORMAL", addAccessor(mesh.normals, kFloat, "VEC3", kVertices)}};
        if (!color) attributes["COLOR_0"] = addColors(mesh, occlusion);
        if (!occlusion.empty()) attributes["_OCCLUSION"] = addAccessor(occlusion, kFloat, "SCALAR", kVertices);
        const auto translucentColor = [](std::uint32_t c) { return !isOpaque(c); };
        const bool translucent = color ? translucentColor(*color) : std::ranges::any_of(mesh.atoms, translucentColor);
        const int indices = addAccessor(mesh.triangles, kUnsignedInt, "SCALAR", kIndices);
        json_["accessors"].back()["count"] = mesh.triangles.size() * 3;
        const Json primitive = {
            {"attributes", attributes}, {"indices", indices}, {"material", addMaterial(color, translucent)}};
        json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
        return json_["meshes"].size() - 1;
    }

    std::size_t addMaterial(std::optional<std::uint32_t> color, bool translucent) {
        const auto [known, added] = materials_.emplace(std::pair(color, translucent), json_["materials"].size());
        if (added) {
            Json shade = {{"metallicFactor", 0}, {"roughnessFactor", 0.6}};
            if (color)
                shade["baseColorFactor"] = {toLinear(*color, 0), toLinear(*color, 1), toLinear(*color, 2),
                                            opacitySteps(*color) / double{kOpacitySteps}};
            json_["materials"].push_back({{"pbrMetallicRoughness", shade}});
            if (translucent) json_["materials"].back().update({{"alphaMode", "BLEND"}, {"doubleSided", true}});
        }
        return known->second;
    }

    void addNodes(const std::string& name, std::size_t mesh, const std::vector<glm::dmat4x3>& transforms,
                  const Json& extensions) {
        for (const glm::dmat4x3& t : transforms) {
            Json node = {{"name", name}, {"mesh", mesh}};
            if (t != glm::dmat4x3(1.0))
                node["matrix"] = {t[0].x, t[0].y, t[0].z, 0, t[1].x, t[1].y, t[1].z, 0,
                                  t[2].x, t[2].y, t[2].z, 0, t[3].x, t[3].y, t[3].z, 1};
            if (!extensions.empty()) node["extensions"] = extensions;
            json_["nodes"].push_back(node);
            json_["nodes"][0]["children"].push_back(json_["nodes"].size() - 1);
        }
    }

    void addMesh(const ExportMesh& part) {
        if (part.mesh.triangles.empty()) return;
        addNodes(part.name, addGeometry(part.name, part.mesh, {}, part.occlusion), part.transforms, {});
    }

    void addInstances(const ExportInstances& part) {
        const auto [shape, added] = shapes_.emplace(std::pair(part.shape, part.color), 0);
        if (added)
            shape->second = addGeometry(part.shape == ExportInstances::Shape::ball ? "ball" : "stick",
                                        unitShape(part.shape, scene_.sides), part.color);
        std::vector<glm::vec3> at, scale;
        std::vector<std::array<float, 4>> turn;
        for (const ExportInstances::Place& place : part.places) {
            at.push_back(place.at);
            scale.push_back(place.scale);
            turn.push_back({place.turn.x, place.turn.y, place.turn.z, place.turn.w});
        }
        Json attributes = {{"TRANSLATION", addAccessor(at, kFloat, "VEC3", 0)},
                           {"SCALE", addAccessor(scale, kFloat, "VEC3", 0)}};
        if (part.shape == ExportInstances::Shape::stick) attributes["ROTATION"] = addAccessor(turn, kFloat, "VEC4", 0);
        addNodes(part.name, shape->second, part.transforms,
                 {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}});
    }

    /// Header, then each chunk with its length and kind, padded to whole words.
    std::string file() {
        std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
        while (text.size() % 4) text.push_back(' ');
        while (binary_.size() % 4) binary_.push_back('\0');
        std::string out = "glTF";
        const auto word = [&](std::size_t value) {
            for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> 8 * i & 255));
        };
        word(2);
        word(12 + 8 + text.size() + 8 + binary_.size());
        word(text.size());
        out += "JSON" + text;
        word(binary_.size());
        out.append("BIN\0", 4);
        return out + binary_;
    }

    const ExportScene& scene_;
    const SceneFileOptions& options_;
    Json json_;
    std::string binary_;
    std::map<std::pair<std::optional<std::uint32_t>, bool>, std::size_t> materials_;
    std::map<std::pair<ExportInstances::Shape, std::uint32_t>, std::size_t> shapes_;
};

}  // namespace

std::string glbFile(const ExportScene& scene, const SceneFileOptions& options) {
    return GltfWriter(scene, options).run();
}

}  // namespace nacre::app
