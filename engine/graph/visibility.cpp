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

std::string lacksMultisampling(Visibility path, const PlanCaps& caps) {
    constexpr std::uint32_t kColor = 4, kNearest = 4;  // bytes of a sample
    if (path == Visibility::encoded)
        return "--visibility encoded settles depth in one sample per pixel; fragdepth and raster-order take more";
    if (path == Visibility::deferred) return "--visibility deferred numbers one primitive per pixel";
    if (path == Visibility::tiles) return "--visibility tiles draws by compute: --supersample auto refines its edges";
    if (!caps.placesSamples) return "the device places samples of its own";
    const std::uint32_t bytes = kMultisamples * (path == Visibility::rasterOrder ? kColor + kNearest : kColor);
    if (bytes > caps.tileBytesPerPixel)
        return "its samples take " + std::to_string(bytes) + " bytes per pixel of the tile, which holds " +
               std::to_string(caps.tileBytesPerPixel);
    return {};
}

SampleChoice chooseSamples(DeviceKind kind, Visibility path, const PlanCaps& caps) {
    if (const std::string lacks = lacksMultisampling(path, caps); !lacks.empty()) return {1, lacks};
    if (kind == DeviceKind::software) return {1, "software rasteriser: each sample costs as much as a pixel"};
    if (kind == DeviceKind::immediate) return {1, "immediate-mode GPU: samples go through memory"};
    if (!caps.transient || caps.storeAll) return {1, "samples would take memory: none is lazily allocated here"};
    if (path == Visibility::rasterOrder)
        return {1, "no driver has shown that it reads each sample of an attachment in order; --msaa 4 asks for it"};
    return {kMultisamples, "samples stay on the tile, and each fragment is shaded once"};
}

}  // namespace nacre::graph
