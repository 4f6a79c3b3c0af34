#include "engine/graph/visibility.h"

namespace nacre::graph {

VisibilityChoice chooseVisibility(DeviceKind kind, const PlanCaps& caps) {
    switch (kind) {
        case DeviceKind::tiler:
            if (!caps.tileSubpasses)
                return {Visibility::fragdepth,
                        "subpasses do not stay on the tile here: one subpass, and no encoded depth in memory"};
            if (caps.rasterOrder && caps.blendsByShader)
                return {Visibility::rasterOrder,
                        "tile-based GPU whose MIN is a shader: one pass over the impostors, in raster order"};
            return {Visibility::encoded, "tile-based GPU: depth stays fixed-function, encoded depth on the tile"};
        case DeviceKind::layered:
            return {Visibility::fragdepth, "Vulkan over Metal leaves the tile between subpasses"};
        case DeviceKind::software:
            if (caps.tiles)
                return {Visibility::tiles,
                        "software rasteriser: compute over lists of primitives costs less than triangles"};
            return {Visibility::encoded,
                    "software rasteriser: early tests against plates save more than a second pass costs"};
        case DeviceKind::immediate:
            break;
    }
    return {Visibility::fragdepth, "immediate-mode GPU: no tile memory to keep encoded depth in"};
}

bool platesReject(Visibility path, const PlanCaps& caps) {
    return caps.conservativeDepth || (path != Visibility::fragdepth && path != Visibility::deferred);
}

}  // namespace nacre::graph
