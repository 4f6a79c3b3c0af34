#pragma once
// The renderer's scene, and its primitives in a view.

#include <memory>

#include "engine/frame/choose.h"
#include "engine/gpu/pool.h"
#include "engine/graph/graph.h"
#include "engine/passes/scene_view.h"
#include "engine/scene/build/translucency.h"
#include "engine/settings.h"

namespace nacre {

/// Sizes of a scene's primitives.
struct SceneSizes {
    double meanRadius = 0;        ///< of spheres, Å
    double smallestRadius = 1e9;  ///< of spheres and cylinders, Å
    double thinnestWire = 1e9;    ///< half its width, pixels
};
SceneSizes measureSizes(const Representation& representation);

struct Scene {
    Representation representation;  ///< its streams in spatial order
    passes::SceneBuffers buffers;
    SceneSizes sizes;
    Chunks chunks;
    TranslucentParts translucent;
    StreamOrder order;           ///< maps to the caller's order
    bool solid = false;          ///< closed: from outside, triangles' backs are behind fronts
    double layersPerLength = 0;  ///< of translucent primitives
};

/// A scene in the representation's own order. @throws Error
Scene makeOrderedScene(const gpu::Device& device, Representation representation);

/// Uploads the streams. @throws Error
Scene makeScene(const gpu::Device& device, Representation representation);

/// Gives the scene the looks of a representation if its shapes are equal. Call only when no device reads the scene.
bool recolor(Scene& scene, Representation& representation);

/// Whether a representation can be the scene with moved primitives: it has as many of each kind.
bool isMoved(const Scene& scene, const Representation& representation);
/// As above, with primitives in the order of the earlier scene. @throws Error
Scene makeMovedScene(const gpu::Device& device, Representation representation, const Scene& before);

/// Size of the image that holds a view: the view's own, possibly turned by 90°.
graph::Extent imageExtent(const View& view);

/// Facts of a scene for choose(), without those of a view.
SceneFacts collectFacts(const Representation& representation, const Chunks& chunks,
                        const TranslucentParts& translucent);

/// Margin around the picture, in pixels, from which primitives may reach into it.
double cullingMargin(const RenderSettings& settings, const View& view, bool wires);

/// Half the width of the narrowest primitive or outline in a picture, pixels.
double smallestPixels(const SceneSizes& sizes, bool wires, const RenderSettings& settings, const View& view);

/// Parameters of the shading effects, for shaders.
layout::EffectConstants effectConstants(const RenderSettings& settings, const Scene& scene);

/// Allowed error of a view's meshes, Å.
double computeMeshError(const RenderSettings& settings, const View& view);

using SceneViews = gpu::Pool<passes::SceneView>;

/// An empty view.
std::shared_ptr<passes::SceneView> nextView(SceneViews& views);

/// The scene as a view sees it. @param scene  outlives the result
std::shared_ptr<passes::SceneView> viewScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                             const passes::Atlas& atlas, SceneViews& views);

}  // namespace nacre
