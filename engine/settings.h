#pragma once
// Settings of a picture or a frame.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "engine/debug_view.h"
#include "engine/device_options.h"
#include "engine/effects.h"
#include "engine/overlay.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// Settings of the ambient occlusion bake. Equal values of the first six fields give equal results.
struct OcclusionSettings {
    static constexpr std::uint64_t kUsualBytes = 64ull << 20;
    static constexpr int kMostDirections = 4096;
    int directions = 128;  ///< 0: no occlusion
    /// Device memory limit of the bake, atlas and depth maps included. The default grows for meshes of more than a
    /// million vertices, since each vertex has its own value.
    std::uint64_t bytes = kUsualBytes;
    OcclusionMaps maps = OcclusionMaps::automatic;
    /// Maximum width of a sphere's patch, 4 to 32 texels. Small pictures show no more than 12. Bake time and the size
    /// of depth maps grow with the square.
    std::uint32_t detail = 32;
    bool bounce = false;  ///< surfaces send light in their colours to their surroundings
    /// Atoms move from picture to picture: few directions and texels are enough (occlusion/moving_atoms.h).
    bool moving = false;
    std::string cache;  ///< folder for finished bakes; empty: none are kept
    /// The bake serves one view: without a cache, it skips texels that face away, or that other spheres hide.
    bool once = false;
    double worthKeeping = 50;  ///< milliseconds; shorter bakes are not kept
    /// Called between batches of the bake with the finished share, above 0 and at most 1.
    std::function<void(double)> onProgress;
};

/// Device time for a bake during a window's frames.
struct OcclusionPace {
    double sliceMilliseconds = 4;  ///< per submission: the longest that a frame waits for it
    double showMilliseconds = 0;   ///< least work between two updates of the shown occlusion
    bool mustFit = false;          ///< submit nothing if the smallest part exceeds a slice
};

/// How a frame is drawn. These never change the picture.
struct FrameTuning {
    PlateShape plates = PlateShape::automatic;  ///< in the opaque prepass
    ImpostorShape impostor = ImpostorShape::automatic;
    bool countFragments = false;  ///< fill FrameStats::passes (slower)
    bool timePasses = false;      ///< fill FrameStats::passTimes; software devices finish each pass for it
    bool transient = true;        ///< attachments that stay on the tile get no memory, if the device supports it
    bool merge = true;            ///< neighbouring passes share a render pass
    bool cull = true;             ///< leave out primitives that are known to be invisible
    /// Number of spheres from which the host first draws them, or finds hidden ones, on the `tiles` path. With fewer,
    /// that costs more than it saves.
    std::uint32_t hideFrom = 1'500'000;
    /// Limit of vertex outputs per render pass, bytes; 0: the device's (GeometryCaps).
    std::uint64_t mostVertexBytes = 0;
};

struct RenderSettings {
    /// Pictures have up to kEdgeSamples samples at pixels with an edge, and one elsewhere. Debug views have one
    /// everywhere.
    static constexpr std::uint32_t kEdges = 0;
    static constexpr std::uint32_t kEdgeSamples = 16;
    /// Samples per pixel side where one frame cannot do that: on paths other than `tiles`, for translucent meshes,
    /// halos and weighted outlines, and if lists are too long.
    static constexpr std::uint32_t kBlockSamples = 4;
    static_assert(kBlockSamples * kBlockSamples == kEdgeSamples);

    View view;
    std::uint32_t supersample = kEdges;           ///< N x N samples per pixel, or kEdges
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha, 0..1
    bool fine = false;                            ///< pictures: 32 bits per channel, linear, instead of 8, sRGB-coded
    bool lighting = true;                         ///< off: base colour times occlusion
    Effects effects = {};                         ///< layers and picks have no contours
    /// Largest error of a mesh's outline, in distances between samples (a quarter of a pixel at edges). The coarsest
    /// level within it is drawn. 0: the finest level.
    double meshError = 0.25;
    /// Largest error of an outline where a cluster replaces its atoms, in pixels.
    double levelError = 0.5;
    /// Number of spheres in all copies from which a view's levels and hidden spheres are found first (seen_copies.h).
    /// Only for scenes without other primitives.
    std::uint64_t levelsFrom = std::uint64_t{1} << 25;
    DebugView debug = DebugView::none;  ///< for pictures and window frames, not for layers and picks
    OcclusionSettings occlusion = {};
    FrameTuning tuning = {};

    /// The settings of a frame: all except the strings and callbacks of the bake.
    RenderSettings ofFrame() const {
        RenderSettings frame{view,      supersample, background, fine,  lighting, effects,
                             meshError, levelError,  levelsFrom, debug, {},       tuning};
        frame.occlusion.directions = occlusion.directions;
        return frame;
    }
};

/// The picture of one eye in a window. The left one's view has View::other.
struct WindowEye {
    View view;
    std::int32_t x = 0, y = 0;  ///< its top left corner in the upright window, which may be outside
    /// Shares of its red, green and blue in each channel of the window, in linear light; parts that overlap add.
    std::array<std::array<float, 3>, 3> channels{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// An image with a layer per eye, left and right, that a headset's runtime lends for a frame. Its layout is that of a
/// colour attachment before and after. Its format codes sRGB.
struct HeadsetImage {
    VkImage image{};
    int format = 0;  ///< VkFormat
    std::uint32_t width = 0, height = 0;
};

/// Settings of a window's frame.
struct WindowFrame {
    enum class Quality {
        live,     ///< at `scale` times the window's resolution
        refined,  ///< adds one sample per pixel; the mean of all is shown and kept
        kept,     ///< shows the refined picture again, under another overlay
    };
    Quality quality = Quality::live;
    double scale = 1;
    std::uint32_t samples = 1;         ///< samples per pixel of the finished refined picture: 1, 4, 9, 16 or 64
    std::uint32_t sample = 0;          ///< the sample of this frame; 0 starts again
    const Overlay* overlay = nullptr;  ///< read during the call only
    double meshError = 2;              ///< factor of RenderSettings::meshError for live frames
    std::optional<std::array<WindowEye, 2>> eyes{};  ///< left and right, in place of the settings' view
};

}  // namespace nacre
