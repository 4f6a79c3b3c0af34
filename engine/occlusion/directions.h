#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

namespace nacre {

/// Unit directions of equal area (spherical Fibonacci, González 2010, Math. Geosci. 42), each with a right-handed frame
/// as rows u, v, w (w is the direction). Frames are rolled so that no two depth maps share a pixel raster. Directions
/// come in opposite pairs; a surface faces one of each pair. Every prefix is well spread: each axis is as far as
/// possible from the axes before it (Gonzalez 1985, Theor. Comput. Sci. 38).
std::vector<glm::dmat3> occlusionDirections(int count);

}  // namespace nacre
