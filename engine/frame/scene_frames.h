#pragma once
// Frames of the renderer's scene, for pictures and for the window.

#include "engine/frame/declared_frames.h"
#include "engine/frame/scene.h"
#include "engine/frame/screen.h"
#include "engine/frame/seen_scene.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/frame_buffers.h"
#include "engine/results.h"
#include "engine/software/hidden_spheres.h"
#include "engine/software/tile_frame.h"

namespace nacre {

/// Request for a frame.
struct FrameRequest {
    const RenderSettings& settings;
    const passes::Atlas& atlas;  ///< occlusion computed so far; unused if the settings ask for none
    const View& view;
    std::span<const ScreenTarget> targets;
    const char* name = "screen";  ///< of the graph; its images are kept by this name
    FrameEnd end = FrameEnd::left;
    std::shared_ptr<passes::FragmentCounter> fragments = nullptr;  ///< not null: counts fragments
    bool edges = false;  ///< draw edges with kEdgeSamples; the shape tells whether that is possible
    /// SceneCounts::radiusPixels of the previous window frame, or 0. Hysteresis: small zooms in and out keep their
    /// pipelines.
    std::optional<double> radiusBefore = {};
    bool subsamples = false;                     ///< kBlockSamples x kBlockSamples of its pixels are one of a picture
    std::uint32_t samples = 1;                   ///< per pixel, unless lacksSamples() has a reason against it
    const TileMask* mask = nullptr;              ///< not null: only these tiles' pixels matter, on every path
    bool finer = false;                          ///< it adds samples or depth to a picture by the device's path
    const passes::EdgePlaces* places = nullptr;  ///< as passes::TileWork has it
};

/// A scene as a frame shows it.
struct SeenFrame {
    FrameShape shape;
    std::shared_ptr<passes::SceneView> view;  ///< resources of the frame's commands while they are in flight
    const gpu::Image* atlas = nullptr;
    SceneCounts counts;

    /// For `tiles` with compute shading: the picture.
    std::shared_ptr<const passes::TileFrame> colors() const {
        return shape.options.shadedByTiles ? view->tiles : nullptr;
    }
};

class SceneFrames {
public:
    /// All arguments outlive this.
    SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene);

    /// The scene and shape of a frame, with the debug view that the settings ask for.
    SeenFrame see(const FrameRequest& request);
    /// Makes a frame of that shape show it. Binds all imports except those of the frame's end.
    static void bind(DeclaredFrame& declared, const SeenFrame& seen);
    /// Releases the scene; only frames in flight still hold it.
    void letGo();

    /// Whether one frame can draw edges with more samples than the rest; otherwise all pixels have equally many.
    /// @param finer  as FrameRequest has it
    bool drawsEdges(bool finer = false) const {
        return pathOf(finer) == Visibility::tiles && device_.caps().tiles.drawsEdges && !translucent();
    }
    /// The path of a frame, before its effects are asked. On devices that shade by tiles these add samples, whatever
    /// path is wanted: other paths draw each sample as a pixel.
    Visibility pathOf(bool finer) const {
        const gpu::Caps& caps = device_.caps();
        return finer && caps.tiles.shade && caps.plan.tiles ? Visibility::tiles : caps.visibility;
    }

    /// Whether a view is small, and shows a mesh of so many triangles that samples would search long lists.
    bool isFineMesh(const View& view) const;

    /// Why a frame by these settings has one sample of a pixel, whatever the device can. Empty: it can have more.
    std::string lacksSamples(const RenderSettings& settings) const;

    /// Whether one looks through some of the scene: colours are blended then, and coded by no shader.
    bool translucent() const { return !scene_->translucent.empty(); }

private:
    std::shared_ptr<const gpu::Buffer> effectsOf(const RenderSettings& settings, bool subsamples);
    Visibility settle(RenderSettings& settings, const FrameRequest& request) const;
    bool shadesByTiles(const FrameRequest& request) const;
    void addLists(SeenFrame& seen, const RenderSettings& settings, const FrameRequest& request);
    void addCovers(SeenFrame& seen, const TileMask& mask);
    static void count(SeenFrame& seen);
    /// Whether the host finds hidden spheres before a path draws the others.
    bool hides(const passes::SceneView& seen, const RenderSettings& settings, Visibility path) const;
    /// Bounding boxes, where the host can draw them instead of spheres; else null.
    const SphereBoxes* boxesOf(const passes::SceneView& seen, const RenderSettings& settings, const View& view,
                               bool edges) const;
    /// Whether the host draws a scene of spheres and cylinders.
    bool drawsShapes(const passes::SceneView& seen, const View& view) const;
    /// Removes hidden spheres from a view. @param edges  also test samples between pixel centres
    void dropHidden(passes::SceneView& seen, const View& view, bool edges);
    void checkBlending(VkFormat format) const;

    const gpu::Device& device_;
    const std::shared_ptr<const Scene>& scene_;  ///< changes between frames
    std::shared_ptr<const Scene> shown_;         ///< it, or what the current view shows of it
    gpu::Image white_;                           // the atlas for scenes without occlusion
    // Frame memory, reused when frames in flight are done. Carries nothing from one frame to the next.
    SceneViews views_;
    passes::TileFrames tiles_, layerTiles_;
    passes::HiddenSpheres hidden_;
    SeenScenes seenScenes_;
    layout::EffectConstants lastEffects_{};
    std::shared_ptr<const gpu::Buffer> effects_;  // for the effects
    gpu::FrameBuffers effectBuffers_, copyRows_, covers_;
};

}  // namespace nacre
