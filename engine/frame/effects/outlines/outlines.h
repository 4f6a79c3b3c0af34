#pragma once
// Outlines by groups of atoms. One pass over the primitives draws them and halos: the densest rim of a pixel stays.
// Plain outlines are a few instructions of the shading (ViewConstants::contourWidth).

#include "engine/frame/frame.h"
#include "engine/frame/scene.h"

namespace nacre {

/// Draws effects that compare a pixel's nearest primitive with its neighbours'.
constexpr const char* kRimPass = "lines and halos";

/// Declares the pass of `deferred` that draws outlines and halos around the nearest primitives.
/// @returns the image that the shading composites
graph::Image declareRims(Frame& frame, const FrameShape& shape);

/// Widths of outlines by groups and of halos, Å at z = 0.
passes::Rims makeRims(const RenderSettings& settings);

/// Adds the outlines of a view for shaders; `view` may have more pixels than the picture.
void addOutlines(layout::ViewConstants& constants, const RenderSettings& settings);
void addOutlines(layout::EffectConstants& constants, const RenderSettings& settings);

}  // namespace nacre
