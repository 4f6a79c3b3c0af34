#pragma once
// What the host's lists need of a scene as a frame shows it.

#include "engine/passes/scene_view.h"
#include "engine/scene/view/camera.h"
#include "engine/software/tile_view.h"

namespace nacre::passes {

/// The view for the host's lists. @param centers  only pixel centres are sampled
TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers);

}  // namespace nacre::passes
