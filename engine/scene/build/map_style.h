#pragma once

#include <cstdint>

namespace nacre {

/// Style of a density map. An isosurface: the lines where it crosses the planes of the grid ("chicken wire"), the
/// surface, or its vertices. Or a translucent volume.
enum class MapStyle : std::uint8_t { automatic, mesh, surface, dots, volume };

}  // namespace nacre
