#pragma once
// Field of the solvent-excluded surface: distance to the possible centres of a probe that touches atoms.

#include <memory>
#include <vector>

#include "engine/mesh/surface_field.h"

namespace nacre {

/// The distance to the nearest possible probe centre, less the probe's radius. Exact up to a step beyond the surface;
/// farther inside, roughly positive. Possible centres are bounded by a union of balls: parts of spheres, circles where
/// two meet, points where three meet. From a point inside, the nearest of it is radially outward from a ball's centre,
/// or on a circle, or such a point; each is tested only where it can be the nearest.
std::unique_ptr<SurfaceField> probeField(const std::vector<SurfaceBall>& balls, double probe, double step);

/// sum exp(-s d^2 / r^2) / exp(-s) - 1.
std::unique_ptr<SurfaceField> gaussianField(const std::vector<SurfaceBall>& balls);

}  // namespace nacre
