#pragma once
// Frames of the renderer's scene, for pictures and windows: gathers facts, calls choose(), and prepares what the choice
// needs.

#include "engine/frame/capped_scenes.h"
#include "engine/frame/declared_frames.h"
#include "engine/frame/effects/volume/volume_textures.h"
#include "engine/frame/geometry.h"
#include "engine/frame/level_scenes.h"
#include "engine/frame/scene.h"
#include "engine/gpu/execute.h"
#include "engine/gpu/frame_buffers.h"
#include "engine/results.h"
#include "engine/software/software.h"
#include "engine/tiles/tiles.h"

namespace nacre {

/// Data of a requested frame.
struct FrameInputs {
    const passes::Atlas& atlas;  ///< occlusion baked so far; unused if the settings ask for none
    const View& view;
    const char* name = "screen";                                   ///< of the graph; key of its kept images
    std::span<const ScreenTarget> window{};                        ///< the target of a window's frame
    std::shared_ptr<passes::FragmentCounter> fragments = nullptr;  ///< if not null, counts fragments
    const TileMask* mask = nullptr;                                ///< only these tiles' pixels matter, on every path
    const passes::EdgePlaces* places = nullptr;                    ///< edge pixels, for Part::edges
    /// SceneCounts::radiusPixels of the previous window frame, or 0. Hysteresis: small zooms in and out keep their
    /// pipelines.
    std::optional<double> radiusBefore{};
};

/// A scene as a frame shows it.
struct PreparedFrame {
    FrameShape shape;
    std::shared_ptr<passes::SceneView> view;  ///< resources of the frame's commands while they are in flight
    const gpu::Image* atlas = nullptr;
    SceneFacts facts;  ///< inputs of the choice
    SceneCounts counts;

    const FrameChoice& choice() const { return shape.choice; }
    /// The picture, where compute shades.
    std::shared_ptr<const passes::TileFrame> colors() const {
        return shape.choice.shadedByCompute() ? view->tiles : nullptr;
    }
};

class SceneFrames {
public:
    /// All arguments outlive this.
    SceneFrames(const gpu::Device& device, gpu::Executor& executor, const std::shared_ptr<const Scene>& scene);

    /// The scene and shape of a frame. If lists are too long, the choice is the replacement. A frame that gives way to
    /// others (FrameChoice::givesWay()) is prepared no further. @throws Error
    PreparedFrame prepare(const FrameRequest& request, const FrameInputs& inputs);
    /// Makes a frame of the same shape show `prepared`. Binds all imports except those of the frame's ending.
    static void bind(DeclaredFrame& declared, const PreparedFrame& prepared);
    /// Releases the scene; only frames in flight still hold it.
    void releaseScene();

    /// Facts of the scene, without those of a view.
    SceneFacts facts(const RenderSettings& settings) const;

private:
    static SceneFacts sceneFacts(const Scene& scene);
    static passes::PrimitiveCounts countPrimitives(const passes::SceneView& view);
    static void addViewFacts(SceneFacts& facts, const passes::SceneView& view);
    std::shared_ptr<const gpu::Buffer> uploadEffects(const RenderSettings& settings, bool subsamples);
    std::shared_ptr<const passes::TileFrame> listTiles(const passes::SceneView& view, const FrameChoice& choice,
                                                       const FrameRequest& request, const FrameInputs& inputs);
    void addLists(PreparedFrame& prepared, const FrameRequest& request, const FrameInputs& inputs);
    void addCovers(PreparedFrame& prepared, const TileMask& mask);
    /// Removes hidden spheres from a view.
    void dropHidden(passes::SceneView& view, const FrameChoice& choice, const FrameInputs& inputs);
    static void count(PreparedFrame& prepared);
    void releaseViews();

    const gpu::Device& device_;
    const std::shared_ptr<const Scene>& scene_;  ///< changes between frames
    std::shared_ptr<const Scene> shown_;         ///< the scene, or the part that the current view shows
    gpu::Image white_;                           // the atlas for scenes without occlusion
    Volumes volumes_;
    // Frame memory, reused when frames in flight are done. Carries nothing from one frame to the next.
    SceneViews views_;
    std::unique_ptr<passes::TileFrames> tiles_, layerTiles_;
    std::unique_ptr<passes::HiddenSpheres> hidden_;  // null in builds without it
    LevelScenes levelScenes_;
    CappedScenes cappedScenes_;
    layout::EffectConstants lastEffects_{};
    std::shared_ptr<const gpu::Buffer> effects_;  // of the effects
    gpu::FrameBuffers effectBuffers_, copyRows_, covers_;
};

}  // namespace nacre
