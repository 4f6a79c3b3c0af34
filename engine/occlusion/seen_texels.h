#pragma once
// Selects the texels of the occlusion atlas that a single picture can show.

#include <glm/vec3.hpp>
#include <optional>

#include "engine/occlusion/hidden_triangles.h"
#include "engine/occlusion/open_texels.h"
#include "engine/settings.h"

namespace nacre {

/// Viewer at infinity.
struct ViewDirection {
    glm::dvec3 towards{};          ///< unit vector to the viewer, in the scene's frame
    double pixelsPerAngstrom = 1;  ///< of the picture
    bool operator==(const ViewDirection& other) const {
        return towards == other.towards && pixelsPerAngstrom == other.pixelsPerAngstrom;
    }
};

/// The view direction, if these settings use the bake for one picture and every visible surface faces one way.
std::optional<ViewDirection> onlyViewDirection(const RenderSettings& settings);

/// Drops sphere and mesh texels that face away from the viewer, texels of hidden triangles, and texels that are no
/// other texel's source. Cylinder texels stay. Values of the remaining texels do not change.
/// @param representation  without copies
/// @param hidden  triangles hidden from that viewer
void keepSeen(OpenTexels& open, const OcclusionLayout& layout, const Representation& representation,
              const ViewDirection& viewDirection, const occlusion::HiddenTriangles& hidden = {});

}  // namespace nacre
