#pragma once
// The scene as one view sees it: what every pass of a frame draws with.

#include "engine/device_options.h"
#include "engine/passes/fragment_counter.h"
#include "engine/passes/placed_copies.h"
#include "engine/passes/scene_buffers.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

struct SceneView {
    const SceneBuffers* buffers = nullptr;
    layout::ViewConstants constants{};  ///< those of a copy are left 0
    PlacedCopies copies;
    gpu::Buffer copyRows;  ///< copies.rows on the device, for `deferred` shading
    bool perspective = false;
    int quarterTurns = 0;  ///< as in View
    PlateShape plates = PlateShape::automatic;
    ImpostorShape impostor = ImpostorShape::automatic;
    double radiusPixels = 0;                     ///< mean radius of the spheres in the picture
    std::shared_ptr<FragmentCounter> fragments;  ///< null: none are counted
};

}  // namespace nacre::passes
