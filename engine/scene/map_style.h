#pragma once

#include <cstdint>

namespace nacre {

/// How a density map's isosurface is drawn: the lines in which it crosses the planes of the grid ("chicken wire"), the
/// surface itself, or its vertices.
enum class MapStyle : std::uint8_t { automatic, mesh, surface, dots };

}  // namespace nacre
