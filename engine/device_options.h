#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

// Handles as vulkan_core.h declares them, for programs that do not include it.
using VkInstance = struct VkInstance_T*;
using VkPhysicalDevice = struct VkPhysicalDevice_T*;
using VkDevice = struct VkDevice_T*;
using VkSurfaceKHR = std::conditional_t<sizeof(void*) == 8, struct VkSurfaceKHR_T*, std::uint64_t>;
using VkImage = std::conditional_t<sizeof(void*) == 8, struct VkImage_T*, std::uint64_t>;
struct VkInstanceCreateInfo;
struct VkDeviceCreateInfo;

namespace nacre {

/// How the renderer finds a pixel's nearest surface. Every path draws the same picture.
enum class Visibility {
    automatic,    ///< chosen by the device's capabilities
    encoded,      ///< as in the paper: encoded depth in a colour attachment, three subpasses
    fragdepth,    ///< gl_FragDepth, one subpass
    rasterOrder,  ///< nearest depth read and written as an attachment in raster order, one pass over the impostors
    deferred,     ///< the nearest primitive's number by gl_FragDepth, then each covered pixel shaded once
    tiles,        ///< the nearest primitive's number by compute, tile by tile; the same shading
};

/// The name on the command line.
inline const char* visibilityName(Visibility visibility) {
    constexpr const char* kNames[] = {"auto", "encoded", "fragdepth", "raster-order", "deferred", "tiles"};
    return kNames[static_cast<std::size_t>(visibility)];
}

/// Opaque plates per sphere in the prepass. Domes are stacks of octagons, smaller towards the viewer.
enum class PlateShape { automatic, none, square, octagon, dome2, dome3 };

/// The polygon that encloses a sphere's image.
enum class ImpostorShape {
    automatic,
    square,
    octagon,
    pyramid,  ///< eight facets tilted towards the sphere, so that early tests reject more (orthographic)
};

/// The formats that can hold encoded depth, finest first (engine/graph/encoded_format.h).
enum class EncodedDepth { automatic, r32f, rgba16f, rg16f, a2b10g10r10, rgba8 };

/// Samples per pixel of a frame in motion, averaged before they leave the tile. A window at rest always has more.
enum class Multisampling {
    automatic,  ///< only frames in motion, where the device's capabilities make it cheap
    off,
    four,  ///< also in pictures without supersampling
};

/// A window to draw into. The engine knows no window system: the application creates the surface.
struct SurfaceSource {
    std::vector<std::string> instanceExtensions;          ///< needed by `create`, VK_KHR_surface included
    std::function<VkSurfaceKHR(VkInstance)> create = {};  ///< called again after the surface was lost. @throws Error
    std::function<double()> clock = {};                   ///< seconds, for the pace of frames; empty: the system's
};

/// Lets a headset's runtime make the Vulkan objects. The renderer owns and destroys them. All three or none. @throws
/// Error
struct HeadsetSource {
    using EntryPoint = void (*(*)(VkInstance, const char*))();  ///< vkGetInstanceProcAddr
    std::function<VkInstance(const VkInstanceCreateInfo&, EntryPoint)> instance = {};
    std::function<VkPhysicalDevice(VkInstance)> physical = {};
    std::function<VkDevice(VkPhysicalDevice, const VkDeviceCreateInfo&, EntryPoint)> device = {};
};

/// How the depth maps of the occlusion bake are drawn; all give the same occlusion.
enum class OcclusionMaps {
    automatic,  ///< chosen by the device's capabilities
    encoded,    ///< opaque prepass, then encoded depth by a MIN blend
    fragdepth,  ///< opaque prepass, then gl_FragDepth
    tiles,      ///< compute, tile by tile from lists; falls back to `automatic` where unsupported
};

struct DeviceOptions {
    bool validate = false;    ///< Khronos validation layer, with synchronization validation
    std::string device = {};  ///< number in `nacre devices`, or part of the name; empty: the best one
    Visibility visibility = Visibility::automatic;
    EncodedDepth encoded = EncodedDepth::automatic;
    Multisampling multisampling = Multisampling::automatic;  ///< `four`: @throws Error where the path cannot
    SurfaceSource surface = {};                              ///< no `create`: no window
    HeadsetSource headset = {};                              ///< no functions: no headset
    std::vector<std::byte> pipelineCache = {};  ///< from Renderer::pipelineCache(); ignored if from another device
    /// Folder for results of self-tests (self_test.h), which decide if `visibility` is automatic. Empty: no self-test.
    /// Without a window, a missing test runs first. Software devices need none: the program's tests cover their paths.
    std::string selfTests = {};
    /// Called before a self-test, which takes seconds, once per device and driver; may be empty.
    std::function<void()> onSelfTest = {};
    bool capture = false;  ///< load RenderDoc, for Renderer::beginCapture()
};

}  // namespace nacre
