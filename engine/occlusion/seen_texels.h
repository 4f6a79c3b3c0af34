#pragma once
// The texels of the occlusion atlas that one picture can show: a picture that is drawn alone needs no others.

#include <glm/vec3.hpp>
#include <optional>

#include "engine/occlusion/hidden_triangles.h"
#include "engine/occlusion/open_texels.h"
#include "engine/settings.h"

namespace nacre {

/// A viewer infinitely far away.
struct Onlooker {
    glm::dvec3 towards{};          ///< to the viewer, in the scene's frame; unit
    double pixelsPerAngstrom = 1;  ///< of the picture
    bool operator==(const Onlooker& other) const {
        return towards == other.towards && pixelsPerAngstrom == other.pixelsPerAngstrom;
    }
};

/// Who sees the pictures of these settings, if they are all that the bake is for and every surface that they show is
/// turned to one side.
std::optional<Onlooker> onlookerOf(const RenderSettings& settings);

/// Drops the texels of spheres and meshes that a picture can only show from behind, those of hidden triangles, and all
/// that nothing takes its value from. Texels of cylinders stay. Values of the others do not change.
/// @param representation  without copies
/// @param hidden  for that viewer
void keepSeen(OpenTexels& open, const OcclusionLayout& layout, const Representation& representation,
              const Onlooker& onlooker, const occlusion::HiddenTriangles& hidden = {});

}  // namespace nacre
