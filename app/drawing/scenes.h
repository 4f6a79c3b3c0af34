#pragma once
// Builds a molecule's scene. For scene files: applies their guide, and the options that change it.

#include <algorithm>
#include <optional>
#include <string>

#include "app/picture/description.h"
#include "app/picture/saved_view.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"
#include "engine/scene/view/scene_camera.h"

namespace nacre::app {

/// PictureDescription::look.assembly for no assembly, also of a packed scene, which shows its own by default.
inline const std::string kNoAssembly = "none";

/// Whether a scene with nothing to draw is an error. In a window the user may hide all atoms.
enum class Emptiness { refused, taken };

/// The scene of a molecule, in its style and colours. @throws Error if nothing is drawn and that is refused
/// @param frame  shared by all models of the molecule's file (shared_frame.h), if known; else computed if possible
Representation buildScene(const ResidueFacts& facts, const PictureDescription& picture,
                          const std::optional<Bounds>& frame = {}, Emptiness emptiness = Emptiness::refused);

/// As above for moving atoms; framed with all models of its file, if it has others. @throws Error
MovingScene buildMovingScene(const ResidueFacts& facts, const PictureDescription& picture);

/// Enlarges a view's depth range for atoms that moved out of it; the camera stays.
/// @param radius  that contains them, Å
inline void reachTo(View& view, double radius) {
    constexpr double kNearest = 1.02;  // relative to the radius, distance to the eye
    view.radius = radius;
    if (view.projection == Projection::perspective) view.eyeDistance = std::max(view.eyeDistance, radius * kNearest);
}

/// The renderer's settings for a description, without a scene. Drawing adds the clipping before a target, the lens's
/// focus and settings of a scene file. @param radius  that the camera frames, Å
RenderSettings makeSettings(const PictureDescription& picture, const Camera& camera, const Size& size, double radius);

/// Whether a packed scene has so many spheres that baking their occlusion would take minutes.
bool tooManyToOcclude(const Representation& scene, const Molecule& molecule);

/// The camera of a scene file, if the picture has no other one; else null.
const SceneCamera* sceneCamera(const Molecule& molecule, const PictureDescription& picture);

/// Applies a scene file's camera and background to a view without its own; the user moves the camera from there.
/// @param radius  that the camera frames, Å
void takeSceneLook(const Molecule& molecule, double radius, PictureDescription& view);

}  // namespace nacre::app
