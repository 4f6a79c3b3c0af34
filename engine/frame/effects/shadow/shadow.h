#pragma once
// Cast shadows: a depth map from the light, which shading passes sample.

#include "engine/frame/effects/shadow/choice.h"
#include "engine/frame/frame.h"
#include "engine/frame/scene.h"

namespace nacre {

/// Declares the map, Frame::shadow, if the choice has one.
void declareShadow(Frame& frame, const FrameChoice& choice);

/// The scene as the light sees it. Clipping drops primitives whose centre is in front of the near plane.
std::shared_ptr<passes::SceneView> lightScene(const Scene& scene, const RenderSettings& settings, const View& view,
                                              SceneViews& views);

/// Primitives that the light sees.
passes::PrimitiveCounts countsInLight(const Representation& representation, const RenderSettings& settings,
                                      const TranslucentParts& translucent);

/// Adds the transform from view space to the map, for shaders.
void addShadow(layout::EffectConstants& constants, const RenderSettings& settings);

}  // namespace nacre
