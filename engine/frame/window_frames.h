#pragma once
// Frames for a window: draws the scene into the swapchain's image, directly or from another resolution, with the
// application's overlay on top.

#include <optional>

#include "engine/frame/declared_frames.h"
#include "engine/frame/scene_frames.h"
#include "engine/frame/window_end.h"
#include "engine/gpu/frame_ring.h"
#include "engine/gpu/swapchain.h"
#include "engine/passes/overlay.h"

namespace nacre {

class WindowFrames {
public:
    /// @param frames  must outlive this
    WindowFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames, const SurfaceSource& source);
    ~WindowFrames() { device_.settle(); }

    /// @param settings  with the view of the upright window. Views of another size are not drawn: FrameOutcome::resized
    FrameOutcome present(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame);
    /// Has the pipelines for the scene created ahead, for any size of its spheres. Draws nothing. Does nothing before
    /// the first frame.
    void prepareScene(const RenderSettings& settings, const WindowFrame& frame);
    /// Waits until another frame should start and, if possible, until it has a window image. The caller can then decide
    /// the frame's contents as late as possible.
    void await();
    /// GPU time of a recent frame, milliseconds; 0: unknown.
    double milliseconds() const { return ring_.milliseconds(); }
    /// Counts of the last frame that drew the scene.
    const SceneCounts& counts() const { return counts_; }
    void setGlyphs(const OverlayGlyphs& glyphs);
    void release();
    graph::Extent size() const { return swapchain_.upright(); }
    WindowPace pace() const { return swapchain_.pace(); }

private:
    bool resize(graph::Extent wanted);
    void submit(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                const WindowFrame& frame);
    void draw(gpu::FrameSlot& slot, const PreparedFrame& prepared, const WindowFrame& frame);
    void drawEyes(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                  const WindowFrame& frame);
    Ending chooseEnding(const WindowFrame& frame) const;
    PreparedFrame prepare(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame,
                          std::optional<double> radiusBefore, std::optional<std::size_t> eye = {});
    DeclaredFrame& declared(const PreparedFrame& prepared);
    void makeSum();
    void prepareOthers();
    void prepareRest(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame);
    WindowEnd end() const;
    VkFormat pictureFormat() const;

    const gpu::Device& device_;
    gpu::Executor& executor_;
    SceneFrames& frames_;
    gpu::Swapchain swapchain_;
    gpu::FrameRing ring_;
    gpu::Retired retired_;  ///< replaced objects that frames in flight use; the next frame takes them over
    DeclaredFrames declared_;
    SceneCounts counts_;
    passes::OverlayPass overlay_;
    // For the passes of the frame that is recorded:
    ScreenTarget target_{};
    WindowSamples samples_;
    const Overlay* overlaid_ = nullptr;
    const gpu::FrameSlot* slot_ = nullptr;
    gpu::Image sum_;             ///< of the refined picture's samples
    std::size_t pipelines_ = 0;  ///< made for frames so far
    bool preparedOthers_ = false;
    std::uint32_t summed_ = 0;  ///< samples in it, including those in flight; 0: invalid
};

}  // namespace nacre
