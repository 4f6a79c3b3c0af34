#pragma once
// A molecule's pictures. Read this and renderer.cpp first.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/debug_view.h"
#include "engine/device_options.h"
#include "engine/overlay.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre {

struct RenderSettings {
    View view;
    std::uint32_t supersample = 1;                ///< N x N samples a pixel
    std::array<float, 4> background{1, 1, 1, 1};  ///< sRGB-coded, straight alpha, 0..1
    bool lighting = true;                         ///< off: base colour x occlusion
    int occlusionDirections = 128;                ///< 0: no occlusion
    std::uint64_t occlusionBytes = 64ull << 20;   ///< device memory budget of the bake, atlas and depth maps included
    OcclusionMaps occlusionMaps = OcclusionMaps::automatic;
    std::string occlusionCache;                 ///< folder that finished bakes are kept in; empty: none are
    double occlusionWorthKeeping = 50;          ///< milliseconds: bakes that took less are not kept
    PlateShape plates = PlateShape::automatic;  ///< of the opaque prepass; never changes the picture
    ImpostorShape impostor = ImpostorShape::automatic;
    bool countFragments = false;  ///< fill FrameStats::passes (slower)
    bool transient = true;        ///< what a tile alone needs has no memory, where the device can; off: all is stored
    bool merge = true;            ///< neighbouring passes share a render pass
    DebugView debug = DebugView::none;  ///< of pictures and window frames; layers and picks are not concerned
    /// Called between batches of the occlusion bake with the share that is done, above 0 and at most 1.
    std::function<void(double)> onBakeProgress;
};

/// Row 0 on top.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> rgba;  ///< linear light, premultiplied; 4 a pixel
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
    std::string encodedFormat;       ///< "R32F"
    bool lazyMemory = false;
};

struct PassCount {
    std::string name;
    std::uint64_t shadedFragments = 0;
};

/// What the occlusion bake chose, and how far it is.
struct OcclusionStats {
    int directions = 0, done = 0;
    std::uint32_t patchTexels = 0;  ///< across a sphere's patch; 1: one value an atom
    std::uint64_t texels = 0;       ///< that light can reach
    const char* maps = "";          ///< "encoded", "fragdepth", "splat"
    std::uint32_t mapPixels = 0;    ///< across one depth map
    std::uint32_t mapsPerBatch = 0;
    std::uint64_t bytes = 0;      ///< device memory while it bakes
    std::uint64_t neverSeen = 0;  ///< spheres that no direction saw
    bool cached = false;          ///< read from disk: nothing was baked
    std::uint64_t asked = 0;      ///< texels times the directions that each was asked about
};

struct FrameStats {
    DeviceInfo device;                         ///< with the path and reason in force
    double bakeMilliseconds = 0;               ///< ambient occlusion, from streams to atlas
    double frameMilliseconds = 0;              ///< one frame, submission to completion, without read-back conversion
    std::uint64_t coveredPixels = 0;           ///< of the last picture
    std::vector<PassCount> passes;             ///< of the last frame that counted
    std::uint64_t spheres = 0, cylinders = 0;  ///< submitted for the last picture, in all copies
    std::uint64_t copies = 1;                  ///< of an assembly
    OcclusionStats occlusion;
    std::uint64_t deviceBytes = 0;      ///< peak device memory
    std::uint64_t deviceBytesHeld = 0;  ///< after the last picture
    std::uint64_t windowFrames = 0;     ///< submitted to the window so far
    std::uint32_t tileBytesPerPixel = 0;
    std::uint64_t loadedBytes = 0, storedBytes = 0;  ///< of attachments, a frame
};

/// How a frame for the window is drawn.
struct WindowFrame {
    enum class Quality {
        live,     ///< at `scale` times the window's resolution
        refined,  ///< from samples x samples a pixel, and kept
        kept,     ///< the refined picture once more, under another overlay
    };
    Quality quality = Quality::live;
    double scale = 1;
    std::uint32_t samples = 2;
    const Overlay* overlay = nullptr;  ///< good until the call returns
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

/// After an Error the renderer is as good as before: the same call, or one that asks for less, may succeed. Only a
/// device that was lost stays so.
class Renderer {
public:
    /// @throws Error if no suitable device is there
    explicit Renderer(const DeviceOptions& options);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    /// Uploads a scene. What was baked for the one before is dropped. @throws Error, and the scene before stays
    void setScene(Representation representation);

    /// Works on the scene's occlusion for about `milliseconds`: at least one direction, if any is left. Frames show
    /// what is done so far; pictures and layers finish it first.
    /// @returns the share that is done, 0..1
    double advanceOcclusion(const RenderSettings& settings, double milliseconds = 4.0);
    /// For each sphere of the scene whether any direction of the bake saw any of it; empty before the bake is done.
    std::vector<bool> seenSpheres() const;

    /// @throws Error if the picture is larger than the device draws, or memory runs out
    Picture render(const RenderSettings& settings);
    /// One sample a pixel, no antialiasing; supersample is ignored.
    LayerPicture layers(const RenderSettings& settings);

    /// One frame as an application would draw it: nothing is read back, and occlusion is shown as far as it is baked (1
    /// everywhere at first). Returns milliseconds, from declaring the frame to the device being done.
    double drawFrame(const RenderSettings& settings);

    /// Draws a frame into the window that DeviceOptions::surface makes, with the occlusion that is there so far, and
    /// queues it for the display. Does not wait for the device unless two frames are in flight already.
    /// @param settings its view has the window's size; `supersample` and `countFragments` are not looked at
    FrameOutcome present(const RenderSettings& settings, const WindowFrame& frame);
    PixelSize windowSize() const;
    /// Lets go of the window's surface, which is about to go; the next frame makes another.
    void releaseWindow();
    /// Glyphs of the overlays that follow. @throws Error if the texture is too large
    void setOverlayGlyphs(const OverlayGlyphs& glyphs);
    /// The atom that is seen at a place of the view or, if none is, nearest to it. @returns its 1-based position in the
    /// file; 0: none within reach. @param x, y, reach pixels, from the top left
    std::uint32_t atomAt(const RenderSettings& settings, double x, double y, double reach);

    /// Whether frames can be captured: DeviceOptions::capture, or RenderDoc started this program.
    bool captures() const;
    /// RenderDoc started this program: its captures are for RenderDoc to keep.
    bool startedByRenderDoc() const;
    /// All that is drawn and baked from here on becomes one capture. @param stem of the file's name, to which RenderDoc
    /// adds; empty: as RenderDoc likes. @throws Error
    void beginCapture(const std::string& stem);
    /// @returns the file that RenderDoc wrote. @throws Error if there is none
    std::string endCapture();

    /// What the driver compiled so far, for DeviceOptions::pipelineCache of a later run.
    std::vector<std::byte> pipelineCache() const;

    /// What is known of the device's loss, in one line; empty: it is there.
    const std::string& deviceLoss() const;

    const FrameStats& stats() const;
    /// Plan of the last frame as text.
    const std::string& planText() const;
    /// What the validation layer said so far; empty is what is right.
    const std::vector<std::string>& validationMessages() const;
    /// Largest picture side of this device, in pixels.
    std::uint32_t maxSize() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Whether this program was built to capture frames.
bool capturesBuilt();

/// Every Vulkan device of this machine, in the order that DeviceOptions::device counts them. @throws Error
std::vector<DeviceInfo> listDevices();

}  // namespace nacre
