#include "app/mvs/camera_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <stdexcept>

#include "app/mvs/molstar_radii.h"
#include "app/mvs/primitive_values.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app::mvs {
namespace {

constexpr double kFarthest = 1e6;      // Å
constexpr double kLeastRadius = 0.01;  // Å, of the focus

std::optional<glm::dvec3> readVector(const Node& node, const char* name) {
    const Json* value = node.param(name);
    if (!value) return std::nullopt;
    glm::dvec3 v(0);
    for (int i = 0; i < 3; ++i) {
        const std::size_t place = static_cast<std::size_t>(i);
        const bool number = value->is_array() && value->size() == 3 && (*value)[place].is_number();
        v[i] = number ? (*value)[place].get<double>() : NAN;
        if (!(std::abs(v[i]) <= kFarthest))
            throw std::invalid_argument(std::string(name) + " is no list of three numbers within 1e6");
    }
    return v;
}

/// How far a layer extends beyond the spheres of a chain's atoms, Å, by Mol*'s rules: balls count twice.
/// @param largest  van der Waals radius of the chain's atoms, Å
double computeRoom(const SceneLayer& layer, double largest) {
    const double scale = static_cast<double>(layer.atomScale);
    switch (layer.style) {
        case Style::cartoon:
            return layer.cartoon.putty ? layer.cartoon.scale : 0.2;
        case Style::ballAndStick:
            return 2 * 0.5 * scale + 0.05;
        case Style::spacefill:
            return 2 * largest * scale + 0.05;
        case Style::surface:
            return largest * scale;
        case Style::backbone:
            return 0.4;
        case Style::carbohydrate:
            return 1.75;
        default:
            return 2;
    }
}

/// Adds the extreme points of each chain's atoms, moved outwards, in all copies; a ball per copy if there are many.
/// @param atoms  of the molecule, ascending @param layer  in which they are drawn; null: only the atoms
void addChains(const Molecule& molecule, const SceneGuide& guide, std::span<const std::uint32_t> atoms,
               const SceneLayer* layer, std::vector<glm::dvec4>& balls) {
    constexpr std::size_t kManyCopies = 14;
    std::map<std::array<std::uint32_t, 3>, std::vector<glm::dvec4>> chains;
    for (const std::uint32_t index : atoms) {
        const Atom& atom = molecule.atoms[index];
        const Residue& residue = molecule.residues[atom.residue];
        const std::uint32_t list = guide.transforms.empty() ? 0 : guide.listOfResidue[atom.residue];
        if (list == UINT32_MAX) continue;
        chains[{list, residue.chain, residue.subchain}].emplace_back(glm::dvec3(atom.position),
                                                                     static_cast<double>(molstarRadius(atom.element)));
    }
    for (const auto& [key, own] : chains) {
        const Bounds sphere = extremeSphere(own);
        double largest = 0;
        for (const glm::dvec4& ball : own) largest = std::max(largest, ball.w);
        const double room = layer ? computeRoom(*layer, largest) : 0;
        std::vector<glm::dvec4> shown;
        for (const glm::dvec3& point : movedOut(extremePoints(own), sphere, room)) shown.emplace_back(point, 0.0);
        if (guide.transforms.empty()) {
            balls.insert(balls.end(), shown.begin(), shown.end());
            continue;
        }
        const std::vector<std::uint32_t>& list = guide.lists[key[0]];
        if (list.size() > kManyCopies) shown = {glm::dvec4(sphere.center, sphere.radius + room)};
        for (const std::uint32_t copy : list)
            for (const glm::dvec4& ball : shown)
                balls.emplace_back(guide.transforms[copy] * glm::dvec4(glm::dvec3(ball), 1.0), ball.w);
    }
}

/// The ball that a focus node frames; sets the camera's directions. @throws std::invalid_argument
glm::dvec4 focusBall(const Node& node, const Bounds& bounds, SceneCamera& camera) {
    const double radius =
        number(node, "radius", bounds.radius * number(node, "radius_factor", 1) + number(node, "radius_extent", 0));
    const glm::dvec3 direction = readVector(node, "direction").value_or(glm::dvec3(0, 0, -1));
    camera.up = readVector(node, "up").value_or(glm::dvec3(0, 1, 0));
    camera.direction = direction;
    return {bounds.center, std::max(radius, 0.0)};
}

}  // namespace

void CameraNodes::takeCamera(const Node& node, SceneWarnings& warnings) try {
    const auto target = readVector(node, "target"), position = readVector(node, "position");
    if (!target || !position) return warnings.add(node, "it has no target or no position");
    const double distance = glm::distance(*target, *position);
    if (!(distance > 1e-3)) return warnings.add(node, "its position is its target");
    SceneCamera camera;
    camera.target = *target;
    camera.direction = *target - *position;
    camera.up = readVector(node, "up").value_or(glm::dvec3(0, 1, 0));
    // The position refers to a camera that fills the picture with a ball of half its distance.
    camera.radius = distance / 2;
    camera.distance = camera.radius / std::sin(glm::radians(camera.fovDegrees) / 2);
    camera.nearest = std::max(number(node, "near", 0), 0.0);
    camera_ = camera;
} catch (const std::invalid_argument& why) {
    warnings.add(node, why.what() + std::string(": it is left out"));
}

void CameraNodes::takeFocus(const Node& node, std::size_t structure, std::vector<std::uint32_t> atoms) {
    if (!atoms.empty()) focuses_.push_back({&node, structure, std::move(atoms), {}, false});
}

void CameraNodes::takeFocus(const Node& node, std::vector<glm::dvec4> balls) {
    if (!balls.empty()) focuses_.push_back({&node, 0, {}, std::move(balls), false});
}

std::size_t CameraNodes::takeFocusLater(const Node& node) {
    focuses_.push_back({&node, 0, {}, {}, false});
    return focuses_.size() - 1;
}

void CameraNodes::focusAll(const Node& node) { focuses_.push_back({&node, 0, {}, {}, true}); }

std::optional<SceneCamera> CameraNodes::camera(const Molecule& molecule, const SceneGuide& guide,
                                               const std::vector<std::uint32_t>& firsts,
                                               SceneWarnings& warnings) const {
    if (camera_) {
        if (!focuses_.empty()) warnings.add(*focuses_.front().node, "the scene's camera node overrides it");
        return camera_;
    }
    const auto whole = [&] {
        std::vector<glm::dvec4> balls = drawn_;
        for (const SceneLayer& layer : layers_) addChains(molecule, guide, layer.atoms, &layer, balls);
        for (const SceneVolume& volume : guide.volumes) balls.emplace_back(volume.ball.center, volume.ball.radius);
        return balls;
    };
    std::vector<glm::dvec4> spheres;
    SceneCamera camera;
    for (const Focus& focus : focuses_) {
        std::vector<glm::dvec4> balls = focus.balls;
        if (focus.all) balls = whole();
        std::vector<std::uint32_t> atoms = focus.atoms;
        for (std::uint32_t& atom : atoms) atom += firsts[focus.structure];
        addChains(molecule, guide, atoms, nullptr, balls);
        if (balls.empty()) continue;
        try {
            spheres.push_back(focusBall(*focus.node, extremeSphere(balls), camera));
        } catch (const std::invalid_argument& why) {
            warnings.add(*focus.node, why.what() + std::string(": it is left out"));
        }
    }
    if (spheres.empty()) spheres = whole();
    if (spheres.empty()) return std::nullopt;
    const Bounds bounds = spheres.size() == 1 ? Bounds{glm::dvec3(spheres[0]), spheres[0].w} : extremeSphere(spheres);
    camera.target = bounds.center;
    camera.radius = std::max(bounds.radius, kLeastRadius);
    return camera;
}

}  // namespace nacre::app::mvs
