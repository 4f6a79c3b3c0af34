#include "app/drawing/scenes.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/drawing/default_look.h"
#include "app/drawing/map_layers.h"
#include "app/files/output_file.h"
#include "app/input/color_file.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/scene/build/atom_groups.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/scene/build/scene_layers.h"
#include "engine/scene/instances/sphere_levels.h"
#include "engine/scene/view/shared_frame.h"

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

/// A scene without atoms, with the centre and radius that they would give.
Representation emptyScene(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                          const std::optional<Bounds>& frame, const std::optional<glm::dvec3>& center) {
    const Molecule& molecule = facts.molecule();
    std::vector<glm::dvec4> balls;
    for (const std::uint32_t atom : drawn)
        balls.emplace_back(glm::dvec3(molecule.atoms[atom].position), vanDerWaalsRadius(molecule.atoms[atom]));
    const Bounds bounds = frame           ? movedTo(center, *frame)
                          : balls.empty() ? Bounds{center.value_or(glm::dvec3(0)), 0}
                                          : computeBounds(balls, center);
    Representation scene;
    scene.atomGroups = atomGroups(facts);
    scene.center = bounds.center;
    scene.radius = bounds.radius;
    return scene;
}

Representation nothingShown(Representation scene, const Molecule& molecule) {
    if (!molecule.atoms.empty()) scene.warnings.emplace_back("all atoms are hidden");
    return scene;
}

/// Of a scene without atoms.
Bounds guideBounds(const SceneGuide& guide) {
    if (guide.camera) return {guide.camera->target, guide.camera->radius};
    return computeBounds(guide.primitives).value_or(Bounds{{}, 1});
}

Representation guidedScene(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                           const RepresentationOptions& look) {
    const SceneGuide& guide = *facts.molecule().guide;
    const GuidedLayers layers = guidedLayers(facts, drawn, look);
    const Bounds frame = guide.camera            ? Bounds{guide.camera->target, guide.camera->radius}
                         : layers.layers.empty() ? guideBounds(guide)
                                                 : computeBounds(facts.molecule(), layers.layers);
    return representLayers(facts, layers, look, movedTo(look.center, frame));
}

/// The representation of a picture, about its centre. @throws Error if the centre's selection matches no atom. Packed
/// scenes are drawn as their assembly and by entities, unless an option says otherwise.
RepresentationOptions placedLook(const ResidueFacts& facts, const PictureDescription& picture) {
    RepresentationOptions look = picture.look;
    const std::string& packed = facts.molecule().file.packed;
    if (!packed.empty() && look.color == Coloring()) look.color = ColorScheme::entity;
    if (look.assembly.empty()) look.assembly = packed;
    if (look.assembly == kNoAssembly) look.assembly.clear();
    look.center = picture.camera.center;
    if (look.center || !picture.aim.center) return look;
    const Selection& selection = *picture.aim.center;
    const std::vector<bool> chosen = selectAtoms(facts, selection);
    Box box;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) box.add(glm::dvec3(facts.molecule().atoms[i].position));
    look.center = box.center();
    if (!std::isfinite(look.center->x)) throw Error("cannot centre", selection.text, "the molecule has no such atoms");
    return look;
}

}  // namespace

MovingScene buildMovingScene(const ResidueFacts& facts, const PictureDescription& picture) {
    RepresentationOptions look = placedLook(facts, picture);
    const std::vector<std::uint32_t> drawn = someDrawnAtoms(facts.molecule(), picture.input.path, picture.drawn);
    takeDefaultLook(facts, drawn, picture, look);
    return {facts, drawn, withTables(look), sharedFrame(facts, picture.drawn, look)};
}

Representation buildScene(const ResidueFacts& facts, const PictureDescription& picture,
                          const std::optional<Bounds>& shared, Emptiness emptiness) {
    RepresentationOptions look = withTables(placedLook(facts, picture));
    const Molecule& molecule = facts.molecule();
    const bool orNothing = picture.drawsBeside() || emptiness == Emptiness::taken;
    const std::optional<Bounds> frame = shared ? shared : frameWithoutAtoms(molecule, picture);
    if (molecule.guide && molecule.atoms.empty())
        return emptyScene(facts, {}, guideBounds(*molecule.guide), look.center);
    if (orNothing && molecule.atoms.empty()) return emptyScene(facts, {}, frame, look.center);
    if (emptiness == Emptiness::taken && drawnAtoms(molecule, picture.drawn).empty())
        return nothingShown(emptyScene(facts, {}, frame, look.center), molecule);
    const std::vector<std::uint32_t> drawn = someDrawnAtoms(molecule, picture.input.path, picture.drawn);
    if (molecule.guide) return guidedScene(facts, drawn, look);
    takeDefaultLook(facts, drawn, picture, look);
    if (orNothing && makeAppearance(facts, drawn, look).seen == 0) {
        Representation scene = emptyScene(facts, drawn, frame, look.center);
        return picture.drawsBeside() ? scene : nothingShown(std::move(scene), molecule);
    }
    Representation scene = represent(facts, drawn, look, frame ? frame : sharedFrame(facts, picture.drawn, look));
    if (!look.ownFrame && !molecule.othersMissing.empty())
        scene.warnings.push_back("the camera is this model's own, not that of all models: " + molecule.othersMissing);
    if (picture.occlusion.directions > 0 && tooManyToOcclude(scene, molecule))
        scene.warnings.push_back("no ambient occlusion: the scene has " + std::to_string(spheresInCopies(scene)) +
                                 " spheres");
    return scene;
}

namespace {

/// Converts a length to pixels, within the limits of effects.
void takeWidth(const std::optional<ScreenLength>& length, const PictureDescription& picture, const View& view,
               double& width) {
    if (!length || width <= 0) return;
    const double pixels =
        length->pixels(std::min(view.width, view.height), picture.dpi.value_or(kScreenDpi), view.pixelsPerAngstrom);
    width = std::clamp(pixels, kThinnestRim, kWidestRim);
}

}  // namespace

RenderSettings makeSettings(const PictureDescription& picture, const Camera& camera, const Size& size, double radius) {
    RenderSettings settings;
    settings.view = makeView(camera, radius, size.width, size.height);
    settings.supersample = picture.supersample;
    settings.background = picture.background;
    settings.fine = picture.bits == 16 || fileExtension(picture.output) == ".exr";
    settings.lighting = picture.lighting;
    settings.effects = picture.effects;
    takeWidth(picture.contourWidth, picture, settings.view, settings.effects.contours.width);
    takeWidth(picture.haloWidth, picture, settings.view, settings.effects.halos.width);
    settings.meshError = picture.meshError;
    settings.debug = picture.debug;
    settings.occlusion.directions = picture.occlusion.directions;
    settings.occlusion.bytes = picture.occlusion.bytes();
    settings.occlusion.detail = picture.occlusion.detail;
    settings.occlusion.bounce = picture.occlusion.bounce;
    settings.tuning = picture.tuning;
    return settings;
}

bool tooManyToOcclude(const Representation& scene, const Molecule& molecule) {
    constexpr std::uint64_t kMost = 1'000'000;
    return !molecule.file.packed.empty() && spheresInCopies(scene) > kMost;
}

const SceneCamera* sceneCamera(const Molecule& molecule, const PictureDescription& picture) {
    const bool placed = picture.aim.any() || picture.aim.placed || picture.camera.orientation != glm::dquat(1, 0, 0, 0);
    return molecule.guide && molecule.guide->camera && !placed ? &*molecule.guide->camera : nullptr;
}

void takeSceneLook(const Molecule& molecule, double radius, PictureDescription& view) {
    const SceneCamera* camera = sceneCamera(molecule, view);
    if (!molecule.guide) return;
    if (molecule.guide->background && view.background == PictureDescription{}.background)
        view.background = *molecule.guide->background;
    if (!camera) return;
    const SceneView seen = makeView(*camera, {}, false, radius, 100, 100);
    view.camera = {};
    view.camera.projection = Projection::perspective;
    view.camera.fovDegrees = camera->fovDegrees;
    view.camera.orientation = glm::quat_cast(seen.view.rotation);
    const View whole = makeView(view.camera, radius, 100, 100);
    view.camera.zoom = seen.view.pixelsPerAngstrom / whole.pixelsPerAngstrom;
}

}  // namespace nacre::app
