#pragma once
// Results: pictures, and statistics about device and work.

#include <cstdint>
#include <string>
#include <vector>

namespace nacre {

/// Row 0 is at the top.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;  ///< linear light, premultiplied; 4 per pixel
};

/// A rectangle of a picture, from the top left.
struct PictureRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    static constexpr std::uint32_t kStep = 16;  ///< x and y of parts are multiples of this
};

struct LayerPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;        ///< linear light, premultiplied; 4 per pixel
    std::vector<float> z;           ///< Å; +infinity on the background
    std::vector<float> normal;      ///< view space; 3 per pixel; 0 on the background
    std::vector<float> occlusion;   ///< 0 closed .. 1 open; 1 on the background
    std::vector<std::uint32_t> id;  ///< 1-based atom; 0 on the background
};

struct DeviceInfo {
    std::string name, driver, type;   ///< type: "discrete", "integrated", "virtual", "software", "other"
    std::string apiVersion;           ///< "1.3.230"
    bool bundled = false;             ///< from the driver in nacre's package, since the system's drivers have no device
    std::string visibility, why;      ///< the path of `automatic` on this device, and the reason
    std::uint32_t motionSamples = 1;  ///< per pixel of a window's frames in motion
    std::string motionWhy;            ///< the reason
    std::string encodedFormat;        ///< "R32F", "R32F in raster order"
    bool lazyMemory = false;
    bool timestamps = false;       ///< passes can be timed
    bool rasterOrder = false;      ///< fragments can read their own attachment in raster order
    bool localRead = false;        ///< render passes with inputs use dynamic rendering with local reads
    bool mergeFeedback = false;    ///< the driver reports how it merges subpasses
    std::string driverKey;         ///< identifies device and driver in names of files
    std::string selfTest;          ///< "encoded 1.20 ms, fragdepth wrong"; empty: not tested
    std::string capabilitySet;     ///< base of its plans: "turnip"
    std::string knownAs, knownBy;  ///< known facts about the driver, and their source; or empty
    // As reported by Vulkan
    std::uint32_t vendorId = 0, deviceId = 0, driverVersion = 0;  ///< Vulkan's numbers
    /// Device memory: total, and this program's current budget (VK_EXT_memory_budget; 0: unknown).
    std::uint64_t memoryBytes = 0, budgetBytes = 0;
    std::vector<std::pair<std::string, std::uint64_t>> limits;
    std::vector<std::string> formats;     ///< "R32F: sampled, colour, blended"
    std::vector<std::string> extensions;  ///< by name
};

struct PassCount {
    std::string name;
    std::uint64_t shadedFragments = 0;
};

/// Geometry of a pass over the scene's primitives.
struct PassGeometry {
    std::string name;
    std::uint32_t pass = 0;  ///< its place in the frame
    std::uint64_t vertices = 0, triangles = 0;
    std::uint64_t varyingBytes = 0;  ///< positions and varyings of all vertices
};

/// Device time of a render pass, a dispatch or a copy. Passes that share a render pass share a time.
struct PassTime {
    std::string name;  ///< names of its passes: "opaque prepass + impostor colour"
    double milliseconds = 0;
};

/// How the driver merged a render pass with several subpasses (VK_EXT_subpass_merge_feedback).
struct MergedSubpasses {
    std::string name;                        ///< names of its passes
    std::uint32_t planned = 0, carried = 0;  ///< subpasses in the plan, and after merging by the driver
    std::string why;                         ///< the driver's reason for keeping some apart
};

/// An image that should never leave the tile. Committed bytes: the memory that the driver nevertheless needed.
struct TransientImage {
    std::string name;
    std::uint64_t bytes = 0, committedBytes = 0;
};

/// The driver's feedback on drawn frames; empty where it gives none.
struct DriverFeedback {
    std::vector<MergedSubpasses> merges;
    std::vector<TransientImage> transients;
};

/// Choices and progress of the occlusion bake.
struct OcclusionStats {
    int directions = 0, done = 0;
    std::uint32_t patchTexels = 0;  ///< across a sphere's patch; 1: one value per atom
    std::uint64_t texels = 0;       ///< that light can reach
    const char* maps = "";          ///< "encoded", "fragdepth", "tiles"
    std::uint32_t mapPixels = 0;    ///< across one depth map
    std::uint32_t mapsPerBatch = 0;
    std::uint64_t bytes = 0;      ///< device memory during the bake
    std::uint64_t budget = 0;     ///< limit for `bytes`
    std::uint64_t neverSeen = 0;  ///< spheres not visible from any direction
    bool cached = false;          ///< read from disk instead of baked
    std::uint64_t asked = 0;      ///< sum over texels of the directions tested
};

/// Lists of the `tiles` path.
struct TileCounts {
    std::uint64_t tiles = 0;                  ///< tiles that may show something; 0: no lists were used
    std::uint64_t kept = 0, keptSpheres = 0;  ///< primitives in any list, and the spheres among them
    std::uint64_t entries = 0;                ///< in all lists; 0: the host drew the primitives
    std::uint32_t longestList = 0;            ///< entries
};

/// One level of detail of the meshes.
struct MeshLevelCount {
    double error = 0;             ///< Å
    std::uint64_t triangles = 0;  ///< in the level
    std::uint64_t drawn = 0;      ///< for the last picture, in all copies
};

/// One level of detail of copies.
struct CopyLevelCount {
    double error = 0;           ///< Å; 0: atoms
    std::uint64_t copies = 0;   ///< drawn by the level, for the last frame
    std::uint64_t spheres = 0;  ///< visible ones
};

/// Statistics of the last picture and its frames.
struct PictureStats {
    double frameMilliseconds = 0;       ///< from submission to completion, all frames
    std::uint64_t coveredPixels = 0;    ///< with N x N samples per pixel: covered samples
    std::uint32_t samples = 1;          ///< most samples of a pixel
    std::uint32_t frames = 1;           ///< number of frames, for pictures drawn in blocks
    std::vector<PassCount> passes;      ///< of the last frame with counting
    std::vector<PassTime> passTimes;    ///< of the last timed frame; empty if the device has no timestamps
    std::uint64_t deviceBytes = 0;      ///< peak device memory
    std::uint64_t deviceBytesHeld = 0;  ///< afterwards
    std::uint32_t tileBytesPerPixel = 0;
    std::uint64_t loadedBytes = 0, storedBytes = 0;  ///< attachment traffic per frame
    std::vector<PassGeometry> geometry;
    bool storesVaryings = false;  ///< whether the device passes varyings through memory
};

/// Statistics of the latest bake.
struct BakeStats {
    double bakeMilliseconds = 0;    ///< ambient occlusion, from streams to atlas
    double bounceMilliseconds = 0;  ///< share of it for bounced light
    OcclusionStats occlusion;
};

/// When a window's frames start.
struct WindowPace {
    enum class State : std::uint8_t {
        absent,   ///< with a free image: the driver does not tell when a frame is on display
        freely,   ///< with a free image, while such frames are timed
        waiting,  ///< when the frame before the last is on display
        resting,  ///< with a free image, since waiting costs frames
    };
    State state = State::absent;
    double displayMilliseconds = 0;  ///< from a frame's start to its display, while frames wait; 0: unknown
};

/// "waiting"
inline const char* paceName(WindowPace::State state) {
    constexpr const char* kNames[] = {"absent", "free", "waiting", "resting"};
    return kNames[static_cast<std::size_t>(state)];
}

struct FrameStats : PictureStats, BakeStats {
    DeviceInfo device;  ///< with the chosen path and the reason
    /// Submitted primitives of the last picture or frame, in all copies.
    std::uint64_t spheres = 0, cylinders = 0, triangles = 0;
    std::vector<MeshLevelCount> meshLevels;  ///< finest first; empty without meshes
    std::vector<CopyLevelCount> copyLevels;  ///< finest first; empty where copies are drawn whole
    std::uint64_t copies = 1;                ///< copies of an assembly
    TileCounts lists;                        ///< of the last frame
    std::uint64_t pipelines = 0;             ///< made so far, which the renderer keeps
    bool pipelinesPending = false;           ///< whether a worker thread compiles pipelines of later frames
    std::uint64_t windowFrames = 0;          ///< submitted to the window so far
    double windowMilliseconds = 0;           ///< recent device time per frame; 0: unknown
    WindowPace windowPace;
};

enum class FrameOutcome {
    shown,
    resized,  ///< nothing drawn: the window is now windowSize(), or there is no refined picture of that size
    hidden,   ///< nothing drawn: the window has no area
    lost,     ///< nothing drawn: the device is lost (deviceLoss()); create a new Renderer
};

/// One decision on how a picture was drawn.
struct Decision {
    std::string what;  ///< "path"
    std::string how;   ///< "tiles"
    std::string why;   ///< one sentence
};

struct PixelSize {
    std::uint32_t width = 0, height = 0;
};

}  // namespace nacre
