#pragma once
// The density maps of a picture in its scene.

#include "app/picture/description.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/representation.h"
#include "engine/volume/density_map.h"

namespace nacre::app {

/// A contour level as a map's file has it. Of a difference map's negative contour it is mirrored about the mean.
double levelOf(const DensityMap& map, const MapLevel& level);

/// What a picture shows of its maps, about a scene's centre.
struct MapLayers {
    Representation shown;               ///< to be joined to the scene (map_scene.h)
    double frame = 0;                   ///< Å from the centre that the camera takes in: of maps that are drawn whole
    std::vector<double> sigmas;         ///< each map's level, in sigma above its mean
    std::vector<std::string> warnings;  ///< what is not as it was asked for

    bool empty() const { return shown.wires.empty() && shown.triangles.empty(); }
};

/// What is drawn of a scene and its maps.
Representation withMaps(Representation scene, const MapLayers& maps);

/// @throws Error
MapLayers mapLayersOf(const Molecule& molecule, const PictureDescription& description, const glm::dvec3& center);

}  // namespace nacre::app
