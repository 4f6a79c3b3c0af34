#include "app/mvs/camera_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/error.h"
#include "engine/scene/scene_camera.h"

namespace nacre::app::mvs {
namespace {

constexpr double kFarthest = 1e6;   // Å
constexpr double kLeastRadius = 5;  // Å, of what is focused on

std::optional<glm::dvec3> vectorOf(const Node& node, const char* name) {
    const Json* value = node.param(name);
    if (!value) return std::nullopt;
    glm::dvec3 v(0);
    for (int i = 0; i < 3; ++i) {
        const std::size_t place = static_cast<std::size_t>(i);
        const bool number = value->is_array() && value->size() == 3 && (*value)[place].is_number();
        v[i] = number ? (*value)[place].get<double>() : NAN;
        if (!(std::abs(v[i]) <= kFarthest))
            throw Error("cannot draw scene", node.place, std::string(name) + " is no list of three numbers within 1e6");
    }
    return v;
}

double numberOf(const Node& node, const char* name, double otherwise) {
    const Json* value = node.param(name);
    if (!value) return otherwise;
    if (!value->is_number() || !(std::abs(value->get<double>()) <= kFarthest))
        throw Error("cannot draw scene", node.place, std::string(name) + " is no number within 1e6");
    return value->get<double>();
}

/// What a layer's atoms take up beyond their centres, Å, as Mol* counts it.
double roomOf(const SceneLayer& layer) {
    switch (layer.style) {
        case Style::cartoon:
            return 0.2;
        case Style::ballAndStick:
            return 0.5;
        default:
            return 1.0;
    }
}

}  // namespace

void CameraNodes::takeCamera(const Node& node, SceneWarnings& warnings) {
    const auto target = vectorOf(node, "target"), position = vectorOf(node, "position");
    if (!target || !position) return warnings.add(node, "it has no target or no position");
    const double distance = glm::distance(*target, *position);
    if (!(distance > 1e-3)) return warnings.add(node, "its position is its target");
    SceneCamera camera;
    camera.target = *target;
    camera.direction = *target - *position;
    camera.up = vectorOf(node, "up").value_or(glm::dvec3(0, 1, 0));
    // The position is that of a camera to which a ball of half its distance fills the picture.
    camera.radius = distance / 2;
    camera.distance = camera.radius / std::sin(glm::radians(camera.fovDegrees) / 2);
    camera_ = camera;
}

void CameraNodes::takeFocus(const Node& node, std::size_t structure, std::vector<std::uint32_t> atoms) {
    if (!atoms.empty()) focuses_.push_back({&node, structure, std::move(atoms), false});
}

void CameraNodes::focusAll(const Node& node) { focuses_.push_back({&node, 0, {}, true}); }

std::optional<SceneCamera> CameraNodes::camera(const Molecule& molecule, const SceneGuide& guide,
                                               const std::vector<std::uint32_t>& firsts,
                                               SceneWarnings& warnings) const {
    if (camera_) {
        if (!focuses_.empty()) warnings.add(*focuses_.front().node, "the scene's camera node overrides it");
        return camera_;
    }
    const auto put = [&](std::uint32_t atom, double radius, std::vector<glm::dvec4>& balls) {
        const glm::dvec3 at(molecule.atoms[atom].position);
        if (guide.transforms.empty()) return balls.emplace_back(at, radius), void();
        const std::uint32_t list = guide.listOfResidue[molecule.atoms[atom].residue];
        if (list == UINT32_MAX) return;
        for (const std::uint32_t copy : guide.lists[list])
            balls.emplace_back(guide.transforms[copy] * glm::dvec4(at, 1.0), radius);
    };
    const auto whole = [&] {
        std::vector<glm::dvec4> balls;
        for (const SceneLayer& layer : guide.layers)
            for (const std::uint32_t atom : layer.atoms) put(atom, roomOf(layer), balls);
        if (const auto beside = boundsOf(guide.primitives)) balls.emplace_back(beside->center, beside->radius);
        return balls;
    };
    std::vector<glm::dvec4> spheres;
    SceneCamera camera;
    for (const Focus& focus : focuses_) {
        std::vector<glm::dvec4> balls;
        if (focus.all) balls = whole();
        for (const std::uint32_t atom : focus.atoms) put(firsts[focus.structure] + atom, 0, balls);
        if (balls.empty()) continue;
        const Node& node = *focus.node;
        const Bounds bounds = extremeSphere(balls);
        const double radius = numberOf(
            node, "radius", bounds.radius * numberOf(node, "radius_factor", 1) + numberOf(node, "radius_extent", 0));
        spheres.emplace_back(bounds.center, std::max(radius, 0.0));
        camera.direction = vectorOf(node, "direction").value_or(glm::dvec3(0, 0, -1));
        camera.up = vectorOf(node, "up").value_or(glm::dvec3(0, 1, 0));
    }
    if (spheres.empty()) spheres = whole();
    if (spheres.empty()) return std::nullopt;
    const Bounds bounds = spheres.size() == 1 ? Bounds{glm::dvec3(spheres[0]), spheres[0].w} : extremeSphere(spheres);
    camera.target = bounds.center;
    camera.radius = std::max(bounds.radius, kLeastRadius);
    return camera;
}

}  // namespace nacre::app::mvs
