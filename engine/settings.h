#pragma once
// What a caller asks of a picture or a frame.

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "engine/debug_view.h"
#include "engine/device_options.h"
#include "engine/effects.h"
#include "engine/overlay.h"
#include "engine/scene/camera.h"

namespace nacre {

/// The ambient occlusion bake of a scene: how much of it, and what it may take. Two bakes with the same first four are
/// the same.
struct OcclusionSettings {
    static constexpr std::uint64_t kUsualBytes = 64ull << 20;
    int directions = 128;  ///< 0: no occlusion
    /// Device memory budget of the bake, atlas and depth maps included. The usual one grows with meshes of more than a
    /// million vertices: each has a value of its own.
    std::uint64_t bytes = kUsualBytes;
    OcclusionMaps maps = OcclusionMaps::automatic;
    /// Texels across a sphere's patch, at most, 4 to 32. Small pictures show no more than 12 of them, and a bake's time
    /// goes with their square; depth maps, too, get no larger than the molecule wants them.
    std::uint32_t detail = 32;
    std::string cache;         ///< folder that finished bakes are kept in; empty: none are
    double worthKeeping = 50;  ///< milliseconds: bakes that took less are not kept
    /// Called between batches of the bake with the share that is done, above 0 and at most 1.
    std::function<void(double)> onProgress;
};

/// What a bake beside a window's frames may take of the device.
struct OcclusionPace {
    double sliceMilliseconds = 4;  ///< of one submission: so long a frame behind it waits at most
    double showMilliseconds = 0;   ///< of work, at least, from one change of what frames show to the next
    bool mustFit = false;          ///< nothing is submitted if even the least there is takes longer than a slice
};

/// How a frame is drawn. None of this changes the picture.
struct FrameTuning {
    PlateShape plates = PlateShape::automatic;  ///< of the opaque prepass
    ImpostorShape impostor = ImpostorShape::automatic;
    bool countFragments = false;  ///< fill FrameStats::passes (slower)
    bool timePasses = false;      ///< fill FrameStats::passTimes; software devices finish each pass for it
    bool transient = true;        ///< what a tile alone needs has no memory, where the device can; off: all is stored
    bool merge = true;            ///< neighbouring passes share a render pass
    bool cull = true;             ///< what certainly does not show is not drawn
    /// Spheres of a view from which the host draws them itself, or looks for those that others hide, for the `tiles`
    /// path: of fewer it costs what it saves.
    std::uint32_t hideFrom = 1'500'000;
};

struct RenderSettings {
    /// Of a picture: kEdgeSamples where a pixel shows an edge, one elsewhere. Debug views have one everywhere.
    static constexpr std::uint32_t kEdges = 0;
    static constexpr std::uint32_t kEdgeSamples = 16;
    /// Where a frame does not draw those (it is not of the `tiles` path; one looks through meshes; halos, lines of
    /// three weights; lists that are too long), a picture has as many everywhere, so many a side.
    static constexpr std::uint32_t kBlockSamples = 4;
    static_assert(kBlockSamples * kBlockSamples == kEdgeSamples);

    View view;
    std::uint32_t supersample = kEdges;           ///< N x N samples a pixel, or kEdges
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha, 0..1
    bool fine = false;                            ///< pictures: 32 bits a channel, linear, instead of 8, sRGB-coded
    bool lighting = true;                         ///< off: base colour x occlusion
    Effects effects;                              ///< layers and picks have no contours
    /// How far a mesh's outline may be off, as a share of the distance between samples (a quarter of a pixel at edges):
    /// meshes are drawn by the coarsest of their levels that keeps within it. Twice that in a window's live frames.
    /// 0: as fine as they are.
    double meshError = 0.25;
    DebugView debug = DebugView::none;  ///< of pictures and window frames; layers and picks are not concerned
    OcclusionSettings occlusion;
    FrameTuning tuning;

    /// What a frame goes by: all but how a bake is made, which is in strings and functions.
    RenderSettings ofFrame() const {
        RenderSettings frame{view, supersample, background, fine, lighting, effects, meshError, debug, {}, tuning};
        frame.occlusion.directions = occlusion.directions;
        return frame;
    }
};

/// How a frame for the window is drawn.
struct WindowFrame {
    enum class Quality {
        live,     ///< at `scale` times the window's resolution
        refined,  ///< one sample of each pixel more, added to those before: their mean is shown, and kept
        kept,     ///< the refined picture once more, under another overlay
    };
    Quality quality = Quality::live;
    double scale = 1;
    std::uint32_t samples = 1;         ///< that a pixel of the refined picture has in the end: 1, 4, 9 or 16
    std::uint32_t sample = 0;          ///< the one that this frame adds; the first begins anew
    const Overlay* overlay = nullptr;  ///< good until the call returns
    double meshError = 2;              ///< of a live frame, times RenderSettings::meshError
};

}  // namespace nacre
