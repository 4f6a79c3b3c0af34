#pragma once
// Frames of the renderer's scene, for pictures and for the window.

#include "engine/frame/scene.h"
#include "engine/frame/screen.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/frame_buffers.h"
#include "engine/passes/hidden_spheres.h"
#include "engine/passes/tile_frame.h"
#include "engine/results.h"

namespace nacre {

class SceneFrames {
public:
    /// All of them outlive this. `stats` is told what frames submit.
    SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene,
                FrameStats& stats);

    /// Declares a frame, with the debug view that the settings ask for, and binds what it imports but for a window's
    /// image.
    /// @param atlas  of the occlusion that is there so far; not looked at if the settings ask for none
    /// @param name  of the graph, by which its images are kept
    /// @param fragments  counts them, if not null
    /// @param edges  whether they are to be drawn from kEdgeSamples; the frame tells whether they are
    ScreenFrame declare(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                        std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports,
                        std::shared_ptr<passes::FragmentCounter> fragments = nullptr, bool edges = false) const;
    /// The same for a window, whose frames follow each other: pipelines stay the same where a zoom goes to and fro.
    ScreenFrame declareNext(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                            std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports) const;

    /// Whether one frame can draw edges from more samples than what lies between them; else all pixels have as many.
    bool drawsEdges() const {
        return device_.caps().visibility == Visibility::tiles && device_.caps().tiles.drawsEdges && !translucent();
    }

    /// Whether one looks through some of the scene: colours are blended then, and coded by no shader.
    bool translucent() const { return !scene_->translucent.empty(); }

    /// How the device's caps and the settings want such a frame planned.
    graph::PlanCaps planCaps(const FrameTuning& tuning) const;

private:
    std::shared_ptr<const gpu::Buffer> effectsOf(const RenderSettings& settings) const;
    ScreenFrame declareSeen(const RenderSettings& settings, const passes::Atlas& atlas, const View& view,
                            std::span<const ScreenTarget> targets, const char* name, gpu::Imports& imports,
                            std::shared_ptr<passes::FragmentCounter> fragments, bool edges, double* lastRadius) const;
    /// Takes out of a view the spheres that others hide. @param edges  samples between the middles of pixels look at it
    /// Whether a view has so many spheres that the host looks for those that others hide.
    static bool hides(const passes::SceneView& seen, const RenderSettings& settings);
    /// Where the host can draw them instead, boxes about them; else null.
    const SphereBoxes* boxesOf(const passes::SceneView& seen, const RenderSettings& settings, const View& view,
                               bool edges) const;
    void dropHidden(passes::SceneView& seen, const RenderSettings& settings, const View& view, bool edges) const;
    void checkBlending(VkFormat format) const;

    const gpu::Device& device_;
    const std::shared_ptr<const Scene>& scene_;  ///< changes between frames
    FrameStats& stats_;
    gpu::Image white_;  // the atlas of scenes without occlusion
    mutable passes::TileFrames tiles_, layerTiles_;
    mutable passes::HiddenSpheres hidden_;
    mutable double windowRadius_ = 0;  // by which the window's last frame chose its shapes
    // Frames in flight hold theirs; the last one serves as long as nothing changes.
    mutable layout::EffectConstants lastEffects_{};
    mutable std::shared_ptr<const gpu::Buffer> effects_;
    mutable gpu::FrameBuffers effectBuffers_, copyRows_;
};

}  // namespace nacre
