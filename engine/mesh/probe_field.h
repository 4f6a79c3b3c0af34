#pragma once
// Field of the solvent-excluded surface: distance to the possible centres of a probe that touches atoms.

#include <memory>
#include <vector>

#include "engine/mesh/surface_field.h"

namespace nacre {

/// The distance to the nearest possible probe centre, minus the probe's radius. Exact up to one step beyond the
/// surface; roughly positive farther inside. The possible centres bound a union of balls: parts of spheres, circles
/// where two spheres meet, and points where three meet. The nearest one is radially outward from a ball's centre, on a
/// circle, or such a point; each candidate is tested only where it can be the nearest.
std::unique_ptr<SurfaceField> probeField(const std::vector<SurfaceBall>& balls, double probe, double step);

/// The field sum exp(-s d^2 / r^2) / exp(-s) - 1.
std::unique_ptr<SurfaceField> gaussianField(const std::vector<SurfaceBall>& balls);

}  // namespace nacre
