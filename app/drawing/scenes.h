#pragma once
// From a molecule to the scene that is drawn of it.

#include <algorithm>
#include <optional>
#include <string>

#include "app/picture/saved_view.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// What is drawn of a molecule, in its style and colours. @throws Error if that is nothing
/// @param frame  that all models of its file share (shared_frame.h), if that is known; else it is found, if it can be
/// @param orNothing  there may be no atom, or rules may hide each, since something is drawn beside them
Representation sceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawn,
                       const RepresentationOptions& look, const std::optional<Bounds>& frame = {},
                       bool orNothing = false);

/// The same of one whose atoms move; seen as all models of its file are, if it has others. @throws Error
MovingScene movingSceneOf(const ResidueFacts& facts, const std::string& name, const DrawnAtomsOptions& drawn,
                          const RepresentationOptions& look);

/// Atoms that moved may reach farther than what a view goes by: it sees them all, from where it is.
/// @param radius  that holds them, Å
inline void reachTo(View& view, double radius) {
    constexpr double kNearest = 1.02;  // of it, to the eye
    view.radius = radius;
    if (view.projection == Projection::perspective) view.eyeDistance = std::max(view.eyeDistance, radius * kNearest);
}

/// How pixels are shaded, of whatever scene and from wherever it is seen.
RenderSettings shadingOf(const PictureDescription& picture);

/// Leaves out what hides the atoms that a view wants uncovered; `scene` shows its molecule, as it stands now.
void uncoverIn(Representation& scene, const ResidueFacts& facts, const PictureDescription& view);
/// What is drawn of a view's molecule. @throws Error if that is nothing
Representation sceneOfView(const ResidueFacts& facts, const PictureDescription& view);

}  // namespace nacre::app
