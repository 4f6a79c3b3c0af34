#include "app/mvs/scene_shapes.h"

#include <algorithm>

#include "app/mvs/clip_nodes.h"
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

}  // namespace

void addShape(const Node& parse, const Node& node, const std::string& uri, SceneFiles& files, SceneGuide& guide,
              CameraNodes& camera, SceneWarnings& warnings) {
    files.bytes(uri);  // throws, which ends the scene, if it cannot be fetched
    PrimitiveLook look = readLook(node, warnings);
    Primitives::Mesh mesh;
    try {
        mesh = files.mesh(uri, lowerCase(nodeText(parse, "format")));
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
    mesh.looks = {look};
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
