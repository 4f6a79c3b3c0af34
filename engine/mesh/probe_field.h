#pragma once
// Where the centre of a probe that touches atoms can be, and how far that is from a point: the field of the
// solvent-excluded surface.

#include <memory>
#include <vector>

#include "engine/mesh/surface_field.h"

namespace nacre {

/// The distance to the nearest place where the probe's centre can be, less the probe's radius. Exact up to a step
/// beyond the surface; farther inside, somewhat positive.
/// The boundary of those places is that of a union of balls: parts of spheres, circles where two meet, points where
/// three do. From a point inside, the nearest of it is straight away from a ball's centre, or on a circle, or such a
/// point; each is asked only where it can be the nearest.
std::unique_ptr<SurfaceField> probeField(const std::vector<SurfaceBall>& balls, double probe, double step);

/// sum exp(-s d^2 / r^2) / exp(-s) - 1.
std::unique_ptr<SurfaceField> gaussianField(const std::vector<SurfaceBall>& balls);

}  // namespace nacre
