#include "app/mvs/scene_shapes.h"

#include <algorithm>

#include "app/mvs/clip_nodes.h"
#include "app/mvs/value_palette.h"
#include "engine/error.h"
#include "engine/molecule/text.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

std::vector<glm::dvec4> outermost(const Primitives::Mesh& mesh) {
    std::vector<glm::dvec4> points;
    for (const glm::dvec3& at : mesh.positions) points.emplace_back(at, 0.0);
    std::vector<glm::dvec4> extreme;
    for (const glm::dvec3& point : extremePoints(points)) extreme.emplace_back(point, 0.0);
    return extreme;
}

PrimitiveLook readLook(const Node& node, SceneWarnings& warnings) {
    for (const Node& child : node.children)
        if ((child.kind == "color" || child.kind == "opacity") && child.param("selector"))
            warnings.add(child, "its parameter 'selector' is not used");
    PrimitiveLook look{.color = 0xffffffffu};
    takeLook(node, look.color, look.opacity, warnings);
    return look;
}

/// The extensions of a shape node that concern the colours of its format: "obj_coloring".
class ColoringReader {
public:
    ColoringReader(const Node& node, const std::string& format, SceneWarnings& warnings)
        : node_(node), warnings_(warnings) {
        using enum MeshColoring::Source;
        const std::string name = format + "_coloring", kind = text(name);
        if (format == "vtp")
            takeArray();
        else if (kind == "vertex")
            coloring_.source = vertices;
        else if (kind == (format == "obj" ? "custom" : "material"))
            coloring_.source = materials;
        else if (!kind.empty() && kind != "uniform")
            tell("there is no " + name, kind);
        const Json* colors = find("obj_material_colors");
        if (!colors || !colors->is_object()) return;
        for (const auto& [material, value] : colors->items())
            if (const auto color = readColor(&value))
                coloring_.materials[material] = *color;
            else
                tell("there is no colour of material", material);
    }
    const MeshColoring& coloring() const { return coloring_; }

private:
    const Json* find(const std::string& key) const {
        if (!node_.custom.is_object()) return nullptr;
        const auto found = node_.custom.find(key);
        return found == node_.custom.end() || found->is_null() ? nullptr : &*found;
    }
    std::string text(const std::string& key) const {
        const Json* value = find(key);
        return value && value->is_string() ? value->get<std::string>() : std::string();
    }
    void tell(const std::string& what, const std::string& name) {
        warnings_.add(node_, what + " '" + nacre::printable(name, 40) + "'");
    }
    void takeArray() {
        coloring_.array = text("vtp_attribute");
        if (coloring_.array.empty()) return;
        coloring_.source = MeshColoring::Source::array;
        coloring_.arrayOfCells = text("vtp_attribute_source") == "cell";
        const std::string palette = text("vtp_palette");
        coloring_.scale = molstarColorList(palette.empty() ? "viridis" : palette);
        if (coloring_.scale.empty()) {
            tell("there is no vtp_palette", palette);
            coloring_.scale = molstarColorList("viridis");
        }
        const Json* domain = find("vtp_domain");
        if (!domain) return;
        if (domain->is_array() && domain->size() == 2 && (*domain)[0].is_number() && (*domain)[1].is_number())
            coloring_.domain = {(*domain)[0].get<double>(), (*domain)[1].get<double>()};
        else
            warnings_.add(node_, "its vtp_domain is not two numbers");
    }

    const Node& node_;
    SceneWarnings& warnings_;
    MeshColoring coloring_;
};

}  // namespace

void addShape(const Node& parse, const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide,
              CameraNodes& camera, SceneWarnings& warnings) {
    files.bytes(uri);  // throws, which ends the scene, if it cannot be fetched
    PrimitiveLook look = readLook(node, warnings);
    const std::string format = lowerCase(nodeText(parse, "format"));
    const MeshColoring coloring = ColoringReader(node, format, warnings).coloring();
    Primitives::Mesh mesh;
    try {
        mesh = files.mesh(uri, format, coloring);
    } catch (const Error& error) {
        return warnings.add(node, std::string("it is left out: ") + error.what());
    }
    const std::vector<glm::dvec4> around = outermost(mesh);
    const std::vector<glm::dmat4x3> motions = readMotions(node, extremeSphere(around).center);
    const auto size = [](const Primitives::Mesh& one) { return std::max(one.triangles.size(), one.positions.size()); };
    std::size_t before = 0;
    for (const Primitives::Mesh& other : guide.primitives.meshes) before += size(other);
    if (before + motions.size() * size(mesh) > kMostPrimitiveTriangles)
        return warnings.add(node, "it is left out: the scene's meshes have more than " +
                                      std::to_string(kMostPrimitiveTriangles) + " triangles or vertices");
    std::vector<glm::dvec4> balls;
    Primitives shown;
    const bool faint = look.opacity < kLeastOpacity;
    look.opacity = std::max(look.opacity, kLeastOpacity);
    if (mesh.looks.empty()) {
        if (coloring.source != MeshColoring::Source::scene) warnings.add(node, "its file has no such colours");
        mesh.looks = {look};
    }
    for (PrimitiveLook& each : mesh.looks) each.opacity = look.opacity;
    for (const glm::dmat4x3& motion : motions) {
        files.step();
        for (const glm::dvec4& ball : around) balls.emplace_back(motion * glm::dvec4(glm::dvec3(ball), 1.0), 0.0);
        if (faint) continue;
        Primitives::Mesh& copy = shown.meshes.emplace_back(mesh);
        for (glm::dvec3& at : copy.positions) at = motion * glm::dvec4(at, 1.0);
    }
    clipPrimitives(ClipRegions(node, warnings), shown);
    guide.primitives.append(std::move(shown));
    camera.addDrawn(balls);
    for (const Node& child : node.children)
        if (child.kind == "focus") camera.takeFocus(child, balls);
}

}  // namespace nacre::app::mvs
