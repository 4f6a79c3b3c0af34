#pragma once
// Density maps in a scene: isosurfaces as wires, surfaces or dots.

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "engine/mesh/isosurface.h"
#include "engine/scene/map_style.h"
#include "engine/scene/representation.h"

namespace nacre {

struct MapContour {
    double level = 0;
    bool above = true;  ///< encloses higher values; false: lower ones
    MapStyle style = MapStyle::mesh;
    std::uint32_t color = 0;  ///< as SphereLook has it
    double opacity = 1;       ///< of surfaces
    double width = 1.5;       ///< of lines and dots, pixels
};

/// Adds a map's contour to a scene of maps alone, about its centre. Its pixels name no atom. Enlarges the scene's
/// radius to hold it. @throws Error if it is too large
void addContour(const MapRegion& region, const MapContour& contour, Representation& maps);

/// Draws beside what a scene shows what another does about the same centre, as maps and primitives: it stands still,
/// whatever copies or models the scene has, and the numbers of its looks follow the scene's. The radius holds both.
/// What of a scene is asked for by its atoms must have been done by then.
void joinScenes(Representation& scene, const Representation& others);

}  // namespace nacre
