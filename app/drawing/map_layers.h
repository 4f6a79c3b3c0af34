#pragma once
// Density maps and primitives drawn with a picture's molecule.

#include <optional>

#include "app/drawing/focus.h"
#include "app/picture/description.h"
#include "engine/molecule/residue_facts.h"
#include "engine/scene/build/primitives.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/build/scene_guide.h"
#include "engine/volume/density_map.h"
#include "engine/volume/read_map.h"

namespace nacre::app {

/// A contour level in the map's unit.
double contourLevel(const DensityMap& map, const MapLevel& level);

/// Maps and primitives about a scene's centre.
struct MapLayers {
    Representation shown;  ///< to be joined to the scene (map_scene.h)
    double frame = 0;      ///< radius that the camera frames, Å: of primitives, and of maps that are drawn whole
    std::optional<glm::dvec3> focus;    ///< point around which they are drawn, Å in the file's frame
    std::vector<double> sigmas;         ///< each map's level, in sigma above its mean
    std::vector<std::string> warnings;  ///< differences from the request

    std::vector<std::string> notes;  ///< of primitives, by Representation::noteNumber()
    std::vector<Primitives::Label> labels;

    bool empty() const {
        return shown.spheres.empty() && shown.cylinders.empty() && shown.wires.empty() && shown.triangles.empty() &&
               !shown.volume;
    }
};

/// A scene together with its maps and primitives.
Representation withMaps(Representation scene, const MapLayers& maps);

/// Bounds of the primitives, else of the first map, for a molecule without atoms; else empty.
/// @throws Error
std::optional<Bounds> frameWithoutAtoms(const Molecule& molecule, const PictureDescription& description);
/// A crystal's mesh without atoms is too dense as a whole: draws it around the focus, from near.
/// @returns false: the description stays as it is
bool lookIntoCrystal(const Molecule& molecule, PictureDescription& description);

/// @param seen  the camera: maps may be drawn around its focus @throws Error
MapLayers buildMapLayers(const Molecule& molecule, const PictureDescription& description, const glm::dvec3& center,
                         const Seen& seen);

/// The maps of a picture for a scene file: contours, and slices of the grid. @throws Error
std::vector<SceneVolume> sceneVolumes(const PictureDescription& picture);

/// Colours molecular surfaces by the map that a picture names for them. The first scene decides the range of values;
/// later frames of moving atoms keep it.
class SurfaceColoring {
public:
    /// @throws Error if the potential of the molecule is requested and cannot be calculated
    SurfaceColoring(const ResidueFacts& facts, const PictureDescription& picture);
    /// Warns if there is no surface. @throws Error
    void operator()(Representation& scene);

private:
    ValueMap from_;
    MapLimits limits_;
    std::shared_ptr<const DensityMap> potential_;  ///< the molecule's potential; null: a file's map
};
inline void colorByMap(const ResidueFacts& facts, const PictureDescription& picture, Representation& scene) {
    SurfaceColoring{facts, picture}(scene);
}

/// For files of triangles: adds a picture's maps as surfaces, and colours by maps. @throws Error
void addMapSurfaces(const Molecule& molecule, PictureDescription picture, Representation& scene);

}  // namespace nacre::app
