#pragma once
// The opaque plates of the prepass: flat polygons fully inside their sphere.

#include <cstdint>
#include <span>

#include "engine/device_options.h"
#include "engine/graph/plan.h"

namespace nacre::passes {

/// One polygon per sphere: corners at `rim` sphere radii from its axis, sqrt(1 - rim^2) radii in front of the centre.
struct Plate {
    std::uint32_t corners = 8;  ///< 8 or 4
    float rim = 0.98516f;       ///< the original app's octagon: 0.91017 of the circumscribed one
};

/// Resolves `automatic`. On a software rasteriser a triangle costs some hundred fragments: squares. On a GPU, fragments
/// dominate if spheres cover enough of them: domes and pyramids; else octagons, or squares where vertex outputs go
/// through memory.
/// @param radiusPixels  mean radius of a sphere in the picture @param flat  no pyramid (SceneView::flat())
PlateShape choosePlates(PlateShape wanted, const graph::GeometryCaps& caps, double radiusPixels);
ImpostorShape chooseImpostor(ImpostorShape wanted, const graph::GeometryCaps& caps, double radiusPixels, bool flat);

/// The radius used to choose shapes during a zoom. Hysteresis: a threshold counts as crossed only when the radius is a
/// sixth beyond it, so that a pinch around a threshold does not change pipelines each time.
/// @param before  result for the previous frame; 0: none
double steadyRadius(double before, double now, const graph::GeometryCaps& caps);

/// The polygons of a shape. Several form a dome: smaller plates that lie nearer to the viewer.
std::span<const Plate> listPlates(PlateShape shape);

}  // namespace nacre::passes
