#pragma once
// The renderer's scene, and the part of it that a view sees.

#include <memory>

#include "engine/gpu/pool.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"
#include "engine/settings.h"

namespace nacre {

struct Scene {
    Representation representation;  ///< its streams in spatial order
    passes::SceneBuffers buffers;
    double meanRadius = 0;      ///< of spheres, Å
    double smallestRadius = 0;  ///< of spheres and cylinders, Å
    double thinnestWire = 1e9;  ///< half its width, pixels
    Chunks chunks;
    TranslucentRuns translucent;  ///< of the translucent triangles
    StreamOrder order;            ///< maps to the caller's order
    bool solid = false;           ///< from outside, backs of triangles are behind fronts
};

/// A scene as it is, without a better order. @throws Error
Scene makeOrderedScene(const gpu::Device& device, Representation representation);

/// Uploads the streams. @throws Error
Scene makeScene(const gpu::Device& device, Representation representation);

/// Gives the scene the looks of a representation with the same shapes, if it is one. Only when no device reads it.
bool recolor(Scene& scene, Representation& representation);

/// Whether a representation can be the scene with moved primitives: the same number of each kind.
bool isMoved(const Scene& scene, const Representation& representation);
/// As above, with primitives in the order of the scene that they moved from. @throws Error
Scene makeMovedScene(const gpu::Device& device, Representation representation, const Scene& before);

/// Size of the image that holds a view: the view's own, possibly turned by 90°.
graph::Extent imageExtent(const View& view);

/// Parameters of the shading effects, for shaders.
layout::EffectConstants effectConstants(const RenderSettings& settings, const Scene& scene);

/// Allowed error of a view's meshes, Å.
double meshErrorOf(const RenderSettings& settings, const View& view);

/// Width of the shadow map, pixels; 0 if the settings ask for no shadows.
std::uint32_t shadowPixels(const RenderSettings& settings);

using SceneViews = gpu::Pool<passes::SceneView>;

/// An empty view.
std::shared_ptr<passes::SceneView> nextView(SceneViews& views);

/// The scene as a view sees it. @param scene  outlives the result
std::shared_ptr<passes::SceneView> viewScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                             const passes::Atlas& atlas, SceneViews& views);

}  // namespace nacre
