// Choices that hold for all frames of a device.

#include "engine/error.h"
#include "engine/frame/chooser.h"

namespace nacre {

using graph::DeviceKind;
using graph::FrameCaps;

namespace {

struct PathRow {
    Visibility path;
    const char* why;
};

/// The path that the device's kind suggests.
PathRow pathOfKind(DeviceKind kind, const graph::PlanCaps& caps) {
    switch (kind) {
        case DeviceKind::tiler:
            if (!caps.tileSubpasses)
                return {Visibility::fragdepth,
                        "subpasses do not stay on the tile here: one subpass, and no encoded depth in memory"};
            if (caps.rasterOrder == graph::RasterOrder::promised && caps.blendsByShader)
                return {Visibility::rasterOrder,
                        "tile-based GPU whose MIN is a shader: one pass over the impostors, in raster order"};
            return {Visibility::encoded, "tile-based GPU: depth stays fixed-function, encoded depth on the tile"};
        case DeviceKind::layered:
            return {Visibility::fragdepth, "Vulkan over Metal leaves the tile between subpasses"};
        case DeviceKind::software:
            return {Visibility::tiles,
                    "software rasteriser: compute over lists of primitives costs less than triangles"};
        case DeviceKind::immediate:
            break;
    }
    return {Visibility::fragdepth, "immediate-mode GPU: no tile memory to keep encoded depth in"};
}

enum class Lack { nothing, encoded, deferred, tiles, places, room };

std::uint32_t bytesOfSamples(Visibility path) {
    constexpr std::uint32_t kColor = 4, kNearest = 4;  // bytes of a sample
    return kMultisamples * (path == Visibility::rasterOrder ? kColor + kNearest : kColor);
}

Lack lackOfMultisampling(Visibility path, const graph::PlanCaps& caps) {
    if (path == Visibility::encoded) return Lack::encoded;
    if (path == Visibility::deferred) return Lack::deferred;
    if (path == Visibility::tiles) return Lack::tiles;
    if (!caps.placesSamples) return Lack::places;
    return bytesOfSamples(path) > caps.tileBytesPerPixel ? Lack::room : Lack::nothing;
}

/// Why frames in motion have one sample per pixel by default, apart from limits of the path; null: they have more.
const char* whySingleInMotion(DeviceKind kind, Visibility path, const graph::PlanCaps& caps) {
    if (kind == DeviceKind::software) return "software rasteriser: each sample costs as much as a pixel";
    if (kind == DeviceKind::immediate) return "immediate-mode GPU: samples go through memory";
    if (!caps.transient || caps.storeAll) return "samples would take memory: none is lazily allocated here";
    if (path == Visibility::rasterOrder)
        return "no driver has shown that it reads each sample of an attachment in order; --msaa 4 asks for it";
    return nullptr;
}

}  // namespace

Visibility pickPath(const FrameCaps& device) {
    if (device.visibility != Visibility::automatic) return device.visibility;
    if (device.tested.visibility != Visibility::automatic) return device.tested.visibility;
    return pathOfKind(device.kind, device.plan).path;
}

graph::TestedPath choosePath(const FrameCaps& device) {
    const auto refuse = [&](Visibility path, const std::string& lacks) {
        throw Error("cannot draw by " + std::string(visibilityName(path)), device.plan.name, lacks);
    };
    if (device.visibility == Visibility::rasterOrder && device.plan.rasterOrder == graph::RasterOrder::none)
        refuse(device.visibility, device.lacksRasterOrder);
    if (device.visibility != Visibility::automatic) return {device.visibility, kAskedFor};
    if (device.tested.visibility != Visibility::automatic) return device.tested;
    const PathRow row = pathOfKind(device.kind, device.plan);
    return {row.path, row.why};
}

std::uint32_t motionSamples(const FrameCaps& device) {
    if (device.multisampling == Multisampling::four) return kMultisamples;
    const Visibility path = pickPath(device);
    const bool several = device.multisampling == Multisampling::automatic &&
                         lackOfMultisampling(path, device.plan) == Lack::nothing &&
                         !whySingleInMotion(device.kind, path, device.plan);
    return several ? kMultisamples : 1;
}

MotionSamples chooseMotionSamples(const FrameCaps& device) {
    if (device.multisampling == Multisampling::off) return {1, kAskedFor};
    const Visibility path = pickPath(device);
    const std::string lacks = lacksMultisampling(path, device.plan);
    if (device.multisampling == Multisampling::four) {
        if (!lacks.empty()) throw Error("cannot draw 4 samples per pixel", device.plan.name, lacks);
        return {kMultisamples, kAskedFor};
    }
    if (!lacks.empty()) return {1, lacks};
    if (const char* why = whySingleInMotion(device.kind, path, device.plan)) return {1, why};
    return {kMultisamples, "samples stay on the tile, and each fragment is shaded once"};
}

OcclusionMaps chooseOcclusionMaps(const FrameCaps& device) {
    if (device.kind == DeviceKind::software || pickPath(device) == Visibility::tiles) return OcclusionMaps::tiles;
    // Where MIN is a blend shader, the depth buffer is cheaper.
    return pickPath(device) == Visibility::encoded && !device.encoded.ordered ? OcclusionMaps::encoded
                                                                              : OcclusionMaps::fragdepth;
}

graph::TestedPath plainestPath(const char* why) { return {Visibility::fragdepth, why}; }

bool drawsByCompute(Visibility path) { return path == Visibility::tiles; }

bool hasPath(Visibility path, bool rasterOrder) { return path != Visibility::rasterOrder || rasterOrder; }

bool platesReject(Visibility path, const graph::PlanCaps& caps) {
    return caps.conservativeDepth || (path != Visibility::fragdepth && path != Visibility::deferred);
}

std::string lacksMultisampling(Visibility path, const graph::PlanCaps& caps) {
    switch (lackOfMultisampling(path, caps)) {
        case Lack::nothing:
            break;
        case Lack::encoded:
            return "--visibility encoded settles depth in one sample per pixel; fragdepth and raster-order take more";
        case Lack::deferred:
            return "--visibility deferred numbers one primitive per pixel";
        case Lack::tiles:
            return "--visibility tiles draws by compute: --supersample auto refines its edges";
        case Lack::places:
            return "the device places samples of its own";
        case Lack::room:
            return "its samples take " + std::to_string(bytesOfSamples(path)) +
                   " bytes per pixel of the tile, which holds " + std::to_string(caps.tileBytesPerPixel);
    }
    return {};
}

}  // namespace nacre
