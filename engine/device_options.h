#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace nacre {

/// How a pixel's nearest surface is found; every path draws the same picture.
enum class Visibility {
    automatic,    ///< the device's caps choose
    encoded,      ///< the paper's: encoded depth in colour, three subpasses
    fragdepth,    ///< gl_FragDepth, one subpass
    rasterOrder,  ///< nearest depth read and written as an attachment in raster order, one pass over the impostors
    deferred,     ///< the nearest primitive's number by gl_FragDepth, then every covered pixel shaded once
    tiles,        ///< the nearest primitive's number by compute, tile by tile; the same shading
};

/// As the command line spells it.
inline const char* visibilityName(Visibility visibility) {
    constexpr const char* kNames[] = {"auto", "encoded", "fragdepth", "raster-order", "deferred", "tiles"};
    return kNames[static_cast<std::size_t>(visibility)];
}

/// The opaque plates of the prepass, per sphere; domes are stacks of smaller octagons nearer to the viewer.
enum class PlateShape { automatic, none, square, octagon, dome2, dome3 };

/// The polygons that a sphere's picture is drawn in.
enum class ImpostorShape {
    automatic,
    square,
    octagon,
    pyramid,  ///< eight facets that lean against the sphere, so that early tests reject more (orthographic)
};

/// The formats that can hold encoded depth, finest first (engine/graph/encoded_format.h).
enum class EncodedDepth { automatic, r32f, rgba16f, rg16f, a2b10g10r10, rgba8 };

/// A window to draw into. The engine knows no window system: whoever has the window makes its surface.
struct SurfaceSource {
    std::vector<std::string> instanceExtensions;     ///< what `create` needs, VK_KHR_surface among them
    std::function<VkSurfaceKHR(VkInstance)> create;  ///< called again after the surface was lost. @throws Error
};

/// How the depth maps of the occlusion bake are drawn; all give the same occlusion.
enum class OcclusionMaps {
    automatic,  ///< the device's caps choose
    encoded,    ///< opaque prepass, then encoded depth by a MIN blend
    fragdepth,  ///< opaque prepass, then gl_FragDepth
    tiles,      ///< compute, tile by tile from lists; devices that lack what it needs do as `automatic` says
};

struct DeviceOptions {
    bool validate = false;  ///< Khronos validation layer, with synchronization validation
    std::string device;     ///< number as `nacre devices` lists it, or part of a name; empty: the best there is
    Visibility visibility = Visibility::automatic;
    EncodedDepth encoded = EncodedDepth::automatic;
    SurfaceSource surface = {};                 ///< without `create`: no window
    std::vector<std::byte> pipelineCache = {};  ///< of Renderer::pipelineCache(); one of another device is dropped
    /// Folder that is kept in what devices were found to draw right (self_test.h), if `visibility` is automatic; empty:
    /// nobody tries. Software devices are not tried: their paths are tested with the program.
    std::string selfTests = {};
    /// Called before a device is tried, which takes seconds, once for a device and driver; may be empty.
    std::function<void()> onSelfTest = {};
    bool capture = false;  ///< RenderDoc is loaded, for Renderer::beginCapture()
};

}  // namespace nacre
