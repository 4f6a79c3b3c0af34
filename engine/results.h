#pragma once
// What a caller gets: pictures, and what is known of the device and of the work.

#include <cstdint>
#include <string>
#include <vector>

namespace nacre {

/// Row 0 on top.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;  ///< linear light, premultiplied; 4 a pixel
};

/// A rectangle of a picture, from the top left.
struct PictureRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    static constexpr std::uint32_t kStep = 16;  ///< parts of pictures begin at multiples of it
};

struct LayerPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;        ///< linear light, premultiplied; 4 a pixel
    std::vector<float> z;           ///< Å; +infinity on the background
    std::vector<float> normal;      ///< view space; 3 a pixel; 0 on the background
    std::vector<float> occlusion;   ///< 0 closed .. 1 open; 1 on the background
    std::vector<std::uint32_t> id;  ///< 1-based atom; 0 on the background
};

struct DeviceInfo {
    std::string name, driver, type;  ///< type: "discrete", "integrated", "virtual", "software", "other"
    std::string apiVersion;          ///< "1.3.230"
    std::string visibility, why;     ///< the path that `automatic` takes here, and the reason
    std::string encodedFormat;       ///< "R32F", "R32F in raster order"
    bool lazyMemory = false;
    bool timestamps = false;       ///< passes can be timed
    bool rasterOrder = false;      ///< fragments can read their own attachment in raster order
    bool localRead = false;        ///< render passes with inputs are carried out by dynamic rendering with local reads
    bool mergeFeedback = false;    ///< the driver tells what it makes of subpasses
    std::string driverKey;         ///< of this device and driver, for names of files
    std::string selfTest;          ///< "encoded 1.20 ms, fragdepth wrong"; empty: nobody tried
    std::string capabilitySet;     ///< what a plan for it starts from: "turnip"
    std::string knownAs, knownBy;  ///< what is known of its driver, and the source; empty where nothing is
    // What it says of itself
    std::uint32_t vendorId = 0, deviceId = 0, driverVersion = 0;  ///< the numbers of Vulkan
    /// Of its own memory: all, and what this program may use of it by now (VK_EXT_memory_budget; 0: it does not tell).
    std::uint64_t memoryBytes = 0, budgetBytes = 0;
    std::vector<std::pair<std::string, std::uint64_t>> limits;
    std::vector<std::string> formats;     ///< "R32F: sampled, colour, blended"
    std::vector<std::string> extensions;  ///< by name
};

struct PassCount {
    std::string name;
    std::uint64_t shadedFragments = 0;
};

/// What a pass over the scene's primitives hands from vertices to fragments.
struct PassGeometry {
    std::string name;
    std::uint64_t vertices = 0, triangles = 0;
    std::uint64_t varyingBytes = 0;  ///< positions and varyings of all vertices
};

/// What the device itself took for a render pass, a dispatch or a copy. Passes that share a render pass are timed as
/// one: what a tiler does within it is its own affair.
struct PassTime {
    std::string name;  ///< of its passes: "opaque prepass + impostor colour"
    double milliseconds = 0;
};

/// What the driver made of a render pass that was planned with several subpasses (VK_EXT_subpass_merge_feedback).
struct MergedSubpasses {
    std::string name;                        ///< of its passes
    std::uint32_t planned = 0, carried = 0;  ///< subpasses of the plan, and those that the driver carries out
    std::string why;                         ///< in the driver's words, where it kept some apart
};

/// An image that never leaves the tile by plan. What the driver has committed after a frame it did need in memory.
struct TransientImage {
    std::string name;
    std::uint64_t bytes = 0, committedBytes = 0;
};

/// What the driver says of the frames that it has drawn; what it cannot tell is left out.
struct DriverFeedback {
    std::vector<MergedSubpasses> merges;
    std::vector<TransientImage> transients;
};

/// What the occlusion bake chose, and how far it is.
struct OcclusionStats {
    int directions = 0, done = 0;
    std::uint32_t patchTexels = 0;  ///< across a sphere's patch; 1: one value an atom
    std::uint64_t texels = 0;       ///< that light can reach
    const char* maps = "";          ///< "encoded", "fragdepth", "tiles"
    std::uint32_t mapPixels = 0;    ///< across one depth map
    std::uint32_t mapsPerBatch = 0;
    std::uint64_t bytes = 0;      ///< device memory while it bakes
    std::uint64_t budget = 0;     ///< of which so much was allowed
    std::uint64_t neverSeen = 0;  ///< spheres that no direction saw
    bool cached = false;          ///< read from disk: nothing was baked
    std::uint64_t asked = 0;      ///< texels times the directions that each was asked about
};

/// The lists that the `tiles` path drew a frame from.
struct TileCounts {
    std::uint64_t tiles = 0;                  ///< that may show something; 0: the path drew from none
    std::uint64_t kept = 0, keptSpheres = 0;  ///< primitives, and spheres of them, in any list
    std::uint64_t entries = 0;                ///< of all lists
    std::uint32_t longestList = 0;            ///< entries
};

/// Of the meshes' levels of detail.
struct MeshLevelCount {
    double error = 0;             ///< Å
    std::uint64_t triangles = 0;  ///< that it has
    std::uint64_t drawn = 0;      ///< of them for the last picture, in all copies
};

/// Of the last picture, and the frames that drew it.
struct PictureStats {
    double frameMilliseconds = 0;       ///< of its frames, submission to completion
    std::uint64_t coveredPixels = 0;    ///< of N x N samples a pixel that were asked for, samples
    std::uint32_t samples = 1;          ///< a pixel of the last picture or frame has at most
    std::uint32_t frames = 1;           ///< that drew it, block by block
    std::vector<PassCount> passes;      ///< of the last frame that counted
    std::vector<PassTime> passTimes;    ///< of the last frame that was timed; none if the device cannot
    std::uint64_t deviceBytes = 0;      ///< peak device memory
    std::uint64_t deviceBytesHeld = 0;  ///< after it
    std::uint32_t tileBytesPerPixel = 0;
    std::uint64_t loadedBytes = 0, storedBytes = 0;  ///< of attachments, a frame
    std::vector<PassGeometry> geometry;
    bool storesVaryings = false;  ///< the device writes varyings to memory, and reads them back
};

/// Of the bake that was begun last.
struct BakeStats {
    double bakeMilliseconds = 0;  ///< ambient occlusion, from streams to atlas
    OcclusionStats occlusion;
};

struct FrameStats : PictureStats, BakeStats {
    DeviceInfo device;  ///< with the path and reason in force
    /// Submitted for the last picture or frame, in all copies.
    std::uint64_t spheres = 0, cylinders = 0, triangles = 0;
    std::vector<MeshLevelCount> meshLevels;  ///< the finest first; none without meshes
    std::uint64_t copies = 1;                ///< of an assembly
    TileCounts lists;                        ///< of the last frame
    std::uint64_t windowFrames = 0;          ///< submitted to the window so far
    double windowMilliseconds = 0;           ///< what the device took for one lately; 0: it has no clock
};

enum class FrameOutcome {
    shown,
    resized,  ///< nothing drawn: the window is now windowSize(), or there is no refined picture of that size
    hidden,   ///< nothing drawn: the window has no area
    lost,     ///< nothing drawn: the device is gone, deviceLoss() tells; only a new Renderer helps
};

struct PixelSize {
    std::uint32_t width = 0, height = 0;
};

}  // namespace nacre
