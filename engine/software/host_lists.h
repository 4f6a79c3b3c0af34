#pragma once
// The view that the host's lists are made for.

#include "engine/passes/scene_view.h"
#include "engine/scene/view/camera.h"
#include "engine/software/tile_view.h"

namespace nacre::passes {

/// @param centers  only pixel centres are sampled
TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers);

}  // namespace nacre::passes
