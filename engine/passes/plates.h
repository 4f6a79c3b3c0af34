#pragma once
// The opaque plates of the prepass: flat polygons that are certainly inside their sphere.

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

/// What `automatic` stands for. On a software rasteriser a triangle costs as much as some hundred fragments: squares.
/// On a GPU fragments are what counts, as long as a sphere covers enough of them: domes and pyramids; else octagons, or
/// squares where corners go through memory.
/// @param radiusPixels   mean radius of a sphere in the picture
PlateShape choosePlates(PlateShape wanted, const graph::GeometryCaps& caps, double radiusPixels);
ImpostorShape chooseImpostor(ImpostorShape wanted, const graph::GeometryCaps& caps, double radiusPixels,
                             bool perspective);

/// The radius by which shapes are chosen while a picture is zoomed: a pinch that goes to and fro across a threshold
/// would change pipelines with each turn. A threshold counts as crossed once the radius has left it a sixth behind.
/// @param before  what this returned for the frame before; 0: there was none
double steadyRadius(double before, double now, const graph::GeometryCaps& caps);

/// The polygons of a shape. More of them make a dome: smaller plates that stand nearer to the viewer.
std::span<const Plate> platesOf(PlateShape shape);

}  // namespace nacre::passes
