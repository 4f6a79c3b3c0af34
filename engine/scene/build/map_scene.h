#pragma once
// Density maps in a scene: isosurfaces as wires, surfaces or dots.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>

#include "engine/mesh/isosurface.h"
#include "engine/scene/build/map_style.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/value_colors.h"

namespace nacre {

struct MapContour {
    double level = 0;
    bool above = true;  ///< encloses higher values; false: lower ones
    MapStyle style = MapStyle::mesh;
    std::uint32_t color = 0;                           ///< packed as in colors.h
    double opacity = 1;                                ///< of surfaces
    double width = 1.5;                                ///< of lines and dots, pixels
    const ValueColoring* values = nullptr;             ///< colours the contour by values of another map; null: `color`
    std::function<bool(const glm::dvec3&)> cuts = {};  ///< whether a part at a place is left out; empty: none is
};

/// Adds a map's contour to a scene that contains only maps, about its centre. Its pixels have no atom. Enlarges the
/// scene's radius to contain it. @throws Error if it is too large
void addContour(const MapRegion& region, const MapContour& contour, Representation& maps);

/// A plane of a map's grid, across one of its axes.
struct MapSlice {
    int axis = 2;        ///< 0, 1, 2: across a, b, c
    double place = 0.5;  ///< along the axis, 0..1 of the region
    double opacity = 1;
    double least = -std::numeric_limits<double>::infinity();  ///< parts with lower values are omitted
    std::function<bool(const glm::dvec3&)> cuts = {};         ///< whether a part at a place is left out; empty: none is
};
constexpr std::size_t kMostSliceNodes = 4'000'000;

/// Adds a slice through a region, coloured by its values, in the same way. It has holes where values are unknown.
/// @throws Error if it is too large
void addSlice(const MapRegion& region, const MapSlice& slice, const ValueColoring& values, Representation& maps);

/// Adds a static second scene about the same centre, such as maps and primitives: copies and models of the scene do not
/// apply to it. The numbers of its looks follow the scene's. The radius covers both. Search the scene by atom before
/// this call: afterwards some looks are not atoms'.
void joinScenes(Representation& scene, const Representation& others);

/// As above for a part of the scene: looks keep the numbers of its atoms.
void joinPart(Representation& scene, const Representation& part);

}  // namespace nacre
