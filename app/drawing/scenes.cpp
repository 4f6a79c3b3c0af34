#include "app/drawing/scenes.h"

#include "engine/error.h"
#include "engine/scene/shared_frame.h"
#include "engine/scene/uncover.h"

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

}  // namespace

MovingScene movingSceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawn,
                          const RepresentationOptions& look) {
    const ResidueFacts facts(molecule);
    return {facts, someDrawnAtoms(molecule, name, drawn), look, sharedFrame(facts, drawn, look)};
}

Representation sceneOf(const Molecule& molecule, const std::string& name, const DrawnAtomsOptions& drawnOptions,
                       const RepresentationOptions& look, const std::optional<Bounds>& frame) {
    const std::vector<std::uint32_t> drawn = someDrawnAtoms(molecule, name, drawnOptions);
    const ResidueFacts facts(molecule);
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

void uncoverIn(Representation& scene, const Molecule& molecule, const PictureDescription& view) {
    if (!view.aim.uncover) return;
    constexpr std::uint32_t kAnySize = 256;
    uncover(scene, selectAtoms(molecule, *view.aim.uncover), viewOf(view.camera, scene.radius, kAnySize, kAnySize),
            view.effects.clip.near);
}

Representation sceneOfView(const Molecule& molecule, const PictureDescription& view) {
    Representation scene = sceneOf(molecule, view.input.path, view.drawn, view.look);
    uncoverIn(scene, molecule, view);
    return scene;
}

}  // namespace nacre::app
