#pragma once
// Frames of the renderer's scene, for pictures and for the window.

#include "engine/frame/declared_frames.h"
#include "engine/frame/scene.h"
#include "engine/frame/screen.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/frame_buffers.h"
#include "engine/passes/hidden_spheres.h"
#include "engine/passes/tile_frame.h"
#include "engine/results.h"

namespace nacre {

/// What is asked of a frame.
struct FrameRequest {
    const RenderSettings& settings;
    const passes::Atlas& atlas;  ///< of the occlusion that is there so far; not looked at if the settings ask for none
    const View& view;
    std::span<const ScreenTarget> targets;
    const char* name = "screen";  ///< of the graph, by which its images are kept
    FrameEnd end = FrameEnd::left;
    std::shared_ptr<passes::FragmentCounter> fragments = nullptr;  ///< counts them, if not null
    bool edges = false;  ///< whether they are to be drawn from kEdgeSamples; the shape tells whether they are
    /// Of a window, whose frames follow each other: what SceneCounts::radiusPixels was of the one before, or 0. A zoom
    /// to and fro keeps its pipelines by it.
    std::optional<double> radiusBefore = {};
    bool subsamples = false;  ///< kBlockSamples x kBlockSamples of its pixels are one of a picture
};

/// A scene as a frame shows it.
struct SeenFrame {
    FrameShape shape;
    std::shared_ptr<passes::SceneView> view;  ///< what the frame's commands use, for as long as they are in flight
    const gpu::Image* atlas = nullptr;
    SceneCounts counts;

    /// Of `tiles` that compute shades: they are the picture.
    std::shared_ptr<const passes::TileFrame> colors() const {
        return shape.options.shadedByTiles ? view->tiles : nullptr;
    }
};

class SceneFrames {
public:
    /// All of them outlive this.
    SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene);

    /// What a frame will show, and the shape of it, with the debug view that the settings ask for.
    SeenFrame see(const FrameRequest& request);
    /// Has a frame of that shape show it, and binds what it imports but for what its end does.
    static void bind(DeclaredFrame& declared, const SeenFrame& seen);
    /// Nothing but frames in flight holds on to a scene any more.
    void letGo();

    /// Whether one frame can draw edges from more samples than what lies between them; else all pixels have as many.
    bool drawsEdges() const {
        return device_.caps().visibility == Visibility::tiles && device_.caps().tiles.drawsEdges && !translucent();
    }

    /// Whether one looks through some of the scene: colours are blended then, and coded by no shader.
    bool translucent() const { return !scene_->translucent.empty(); }

private:
    std::shared_ptr<const gpu::Buffer> effectsOf(const RenderSettings& settings);
    Visibility settle(RenderSettings& settings, const FrameRequest& request) const;
    bool shadesByTiles(const FrameRequest& request) const;
    void addLists(SeenFrame& seen, const RenderSettings& settings, const FrameRequest& request);
    static void count(SeenFrame& seen);
    /// Whether a view has so many spheres that the host looks for those that others hide.
    static bool hides(const passes::SceneView& seen, const RenderSettings& settings);
    /// Where the host can draw them instead, boxes about them; else null.
    const SphereBoxes* boxesOf(const passes::SceneView& seen, const RenderSettings& settings, const View& view,
                               bool edges) const;
    /// Takes out of a view the spheres that others hide. @param edges  samples between the middles of pixels look at it
    void dropHidden(passes::SceneView& seen, const RenderSettings& settings, const View& view, bool edges);
    void checkBlending(VkFormat format) const;

    const gpu::Device& device_;
    const std::shared_ptr<const Scene>& scene_;  ///< changes between frames
    gpu::Image white_;                           // the atlas of scenes without occlusion
    // Memory that frames are made in, used again when those in flight are done: nothing of one shows in the next.
    SceneViews views_;
    passes::TileFrames tiles_, layerTiles_;
    passes::HiddenSpheres hidden_;
    layout::EffectConstants lastEffects_{};
    std::shared_ptr<const gpu::Buffer> effects_;  // of these
    gpu::FrameBuffers effectBuffers_, copyRows_;
};

}  // namespace nacre
