#include "app/drawing/guided.h"

#include <glm/gtc/quaternion.hpp>

#include "engine/scene/scene_guide.h"
#include "engine/scene/scene_layers.h"

namespace nacre::app {

Representation guidedSceneOf(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                             const RepresentationOptions& look) {
    const SceneGuide& guide = *facts.molecule().guide;
    const GuidedLayers layers = guidedLayers(facts, drawn, look);
    const Bounds frame = guide.camera            ? Bounds{guide.camera->target, guide.camera->radius}
                         : layers.layers.empty() ? frameOfGuide(guide)
                                                 : boundsOf(facts.molecule(), layers.layers);
    return representLayers(facts, layers, look, frame);
}

Bounds frameOfGuide(const SceneGuide& guide) {
    if (guide.camera) return {guide.camera->target, guide.camera->radius};
    return boundsOf(guide.primitives).value_or(Bounds{{}, 1});
}

const SceneCamera* sceneCamera(const Molecule& molecule, const PictureDescription& picture) {
    const bool placed = picture.aim.any() || picture.aim.placed || picture.camera.orientation != glm::dquat(1, 0, 0, 0);
    return molecule.guide && molecule.guide->camera && !placed ? &*molecule.guide->camera : nullptr;
}

void takeGuide(const Molecule& molecule, const PictureDescription& picture, RenderSettings& settings) {
    if (!molecule.guide) return;
    const SceneGuide& guide = *molecule.guide;
    if (guide.background && !picture.given.contains("background") &&
        picture.background == PictureDescription{}.background)
        settings.background = *guide.background;
}

void takeSceneLook(const Molecule& molecule, double radius, PictureDescription& view) {
    const SceneCamera* camera = sceneCamera(molecule, view);
    if (!molecule.guide) return;
    if (molecule.guide->background && view.background == PictureDescription{}.background)
        view.background = *molecule.guide->background;
    if (!camera) return;
    const SceneView seen = viewOf(*camera, {}, false, radius, 100, 100);
    view.camera = {};
    view.camera.projection = Projection::perspective;
    view.camera.fovDegrees = camera->fovDegrees;
    view.camera.orientation = glm::quat_cast(seen.view.rotation);
    const View whole = viewOf(view.camera, radius, 100, 100);
    view.camera.zoom = seen.view.pixelsPerAngstrom / whole.pixelsPerAngstrom;
}

}  // namespace nacre::app
