#include "app/drawing/scenes.h"

#include <glm/gtc/quaternion.hpp>

#include "app/drawing/map_layers.h"
#include "app/input/color_file.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/scene/view/shared_frame.h"
#include "engine/scene/view/uncover.h"

namespace nacre::app {
namespace {

std::vector<std::uint32_t> someDrawnAtoms(const Molecule& molecule, const std::string& name,
                                          const DrawnAtomsOptions& options) {
    std::vector<std::uint32_t> drawn = drawnAtoms(molecule, options);
    if (drawn.empty())
        throw Error("cannot draw molecule", name,
                    "none of its " + std::to_string(molecule.atoms.size()) +
                        " atoms is drawn: they are water or hydrogens, which are hidden");
    return drawn;
}

/// A scene without atoms, where they would be.
Representation nothingOf(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                         const std::optional<Bounds>& frame) {
    const Molecule& molecule = facts.molecule();
    std::vector<glm::dvec4> balls;
    for (const std::uint32_t atom : drawn)
        balls.emplace_back(glm::dvec3(molecule.atoms[atom].position), vanDerWaalsRadius(molecule.atoms[atom].element));
    const Bounds bounds = frame ? *frame : balls.empty() ? Bounds{} : boundsOf(balls);
    Representation scene;
    scene.atomGroups = atomGroups(facts);
    scene.center = bounds.center;
    scene.radius = bounds.radius;
    return scene;
}

}  // namespace

MovingScene movingSceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawn,
                          const RepresentationOptions& look) {
    return {facts, someDrawnAtoms(facts.molecule(), name, drawn), withTables(look), sharedFrame(facts, drawn, look)};
}

Representation sceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawnOptions,
                       const RepresentationOptions& asked, const std::optional<Bounds>& frame, bool orNothing) {
    const RepresentationOptions look = withTables(asked);
    const Molecule& molecule = facts.molecule();
    if (molecule.guide && molecule.atoms.empty()) return nothingOf(facts, {}, frameOfGuide(*molecule.guide));
    if (orNothing && molecule.atoms.empty()) return nothingOf(facts, {}, frame);
    const std::vector<std::uint32_t> drawn = someDrawnAtoms(molecule, name, drawnOptions);
    if (molecule.guide) return guidedSceneOf(facts, drawn, look);
    if (orNothing && appearanceOf(facts, drawn, look).seen == 0) return nothingOf(facts, drawn, frame);
    Representation scene = represent(facts, drawn, look, frame ? frame : sharedFrame(facts, drawnOptions, look));
    if (!look.ownFrame && !molecule.othersMissing.empty())
        scene.warnings.push_back("the camera is this model's own, not that of all models: " + molecule.othersMissing);
    return scene;
}

RenderSettings shadingOf(const PictureDescription& picture) {
    RenderSettings settings;
    settings.background = picture.background;
    settings.lighting = picture.lighting;
    settings.effects = picture.effects;
    settings.occlusion.directions = picture.occlusion.directions;
    settings.occlusion.bytes = picture.occlusion.bytes();
    settings.occlusion.detail = picture.occlusion.detail;
    return settings;
}

void uncoverIn(Representation& scene, const ResidueFacts& facts, const PictureDescription& view) {
    if (!view.aim.uncover) return;
    constexpr std::uint32_t kAnySize = 256;
    uncover(scene, selectAtoms(facts, *view.aim.uncover), viewOf(view.camera, scene.radius, kAnySize, kAnySize),
            view.effects.clip.near);
}

Representation sceneOfView(const ResidueFacts& facts, const PictureDescription& view) {
    Representation scene = sceneOf(facts, view.input.path, view.drawn, view.look,
                                   frameOfPrimitives(facts.molecule(), view), view.drawsBeside());
    colorByMap(view, scene);
    uncoverIn(scene, facts, view);
    return scene;
}

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
