#pragma once
// The renderer's scene, and how one view sees it.

#include <memory>
#include <vector>

#include "engine/gpu/pool.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/translucency.h"
#include "engine/settings.h"

namespace nacre {

struct Scene {
    Representation representation;  ///< its streams in the order of space
    passes::SceneBuffers buffers;
    double meanRadius = 0;      ///< of the spheres, Å
    double smallestRadius = 0;  ///< of spheres and cylinders, Å
    double thinnestWire = 1e9;  ///< half of its width, pixels
    Chunks chunks;
    TranslucentRuns translucent;  ///< of its triangles
    StreamOrder order;            ///< from how they were handed in
};

/// Uploads the streams. @throws Error
Scene makeScene(const gpu::Device& device, Representation representation);

/// Whether a representation may be another scene's at other places: it has as many primitives of each kind.
bool isMoved(const Scene& scene, const Representation& representation);
/// The same, its primitives in the order of the scene that it moved from. @throws Error
Scene makeMovedScene(const gpu::Device& device, Representation representation, const Scene& before);

/// Of the image that holds a view: the view's own, or turned.
graph::Extent imageExtent(const View& view);

/// What the effects of shading work with, for shaders.
layout::EffectConstants effectConstants(const RenderSettings& settings, const Scene& scene);

/// Å that a view's meshes may be off by.
double meshErrorOf(const RenderSettings& settings, const View& view);

/// Pixels across the map of what the light sees of a scene; 0 if the settings ask for no shadows.
std::uint32_t shadowPixels(const RenderSettings& settings);

using SceneViews = gpu::Pool<passes::SceneView>;

/// An empty view.
std::shared_ptr<passes::SceneView> nextView(SceneViews& views);

/// The scene as a view sees it. @param scene  outlives what is returned
std::shared_ptr<passes::SceneView> viewScene(const gpu::Device& device, const Scene& scene,
                                             const RenderSettings& settings, const View& view,
                                             const passes::Atlas& atlas, SceneViews& views);

}  // namespace nacre
