#include "app/drawing/scenes.h"

#include "app/drawing/guided.h"
#include "app/drawing/map_layers.h"
#include "app/input/color_file.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/atom_groups.h"
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

}  // namespace nacre::app
