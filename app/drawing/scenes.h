#pragma once
// From a molecule to its scene. For scene files: what their guide says, and what options change of it.

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

/// The scene of a molecule, in its style and colours. @throws Error if it is empty
/// @param frame  that all models of its file share (shared_frame.h), if that is known; else it is found, if it can be
/// @param orNothing  there may be no atom, or rules may hide each, since something is drawn beside them
Representation sceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawn,
                       const RepresentationOptions& look, const std::optional<Bounds>& frame = {},
                       bool orNothing = false);

/// As above for moving atoms; framed with all models of its file, if it has others. @throws Error
MovingScene movingSceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawn,
                          const RepresentationOptions& look);

/// Enlarges a view's depth range for atoms that moved beyond it; the camera stays.
/// @param radius  that holds them, Å
inline void reachTo(View& view, double radius) {
    constexpr double kNearest = 1.02;  // of it, to the eye
    view.radius = radius;
    if (view.projection == Projection::perspective) view.eyeDistance = std::max(view.eyeDistance, radius * kNearest);
}

/// Shading settings, independent of scene and camera.
RenderSettings shadingOf(const PictureDescription& picture);

/// Removes what hides the atoms to uncover; `scene` shows the molecule at its current positions.
void uncoverIn(Representation& scene, const ResidueFacts& facts, const PictureDescription& view);
/// The representation of a view's molecule. @throws Error if it is empty
Representation sceneOfView(const ResidueFacts& facts, const PictureDescription& view);

/// The scene of a molecule that has a guide. @param drawn  what rules may show @throws Error
Representation guidedSceneOf(const ResidueFacts& facts, std::span<const std::uint32_t> drawn,
                             const RepresentationOptions& look);

/// Bounds of a scene without atoms.
Bounds frameOfGuide(const SceneGuide& guide);

/// The camera of a scene file, if the picture has no other one; else null.
const SceneCamera* sceneCamera(const Molecule& molecule, const PictureDescription& picture);

/// Takes settings that no option gives from a scene file.
void takeGuide(const Molecule& molecule, const PictureDescription& picture, RenderSettings& settings);

/// Puts a scene file's camera and background into a view that has none of its own, for a hand that turns on from there.
/// @param radius  that the camera goes by, Å about the scene's centre
void takeSceneLook(const Molecule& molecule, double radius, PictureDescription& view);

}  // namespace nacre::app
