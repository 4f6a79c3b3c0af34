#pragma once
// Pictures of scene files: what their guide says, and what options change of it.

#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/scene_camera.h"

namespace nacre::app {

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
