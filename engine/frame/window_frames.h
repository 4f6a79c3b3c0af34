#pragma once
// Frames for a window: the screen frame into the swapchain's image, or by way of a picture at another resolution, and
// the application's overlay on top.

#include <optional>

#include "engine/frame/declared_frames.h"
#include "engine/frame/scene_frames.h"
#include "engine/gpu/frame_ring.h"
#include "engine/gpu/swapchain.h"
#include "engine/passes/overlay.h"

namespace nacre {

class WindowFrames {
public:
    /// @param frames  outlives this
    WindowFrames(const gpu::Device& device, gpu::Executor& executor, SceneFrames& frames, const SurfaceSource& source);
    ~WindowFrames() { device_.settle(); }

    /// @param settings  its view is that of the upright window; one of another size is not drawn, and told by
    ///                  FrameOutcome::resized
    FrameOutcome present(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame);
    /// Has the pipelines of a frame that shows the scene made ahead, of whatever size its spheres will be. Nothing is
    /// drawn; and nothing happens before there was a frame.
    void prepareScene(const RenderSettings& settings, const WindowFrame& frame);
    /// Waits until there is room for another frame and, if it can be had, for an image to draw it into: so that what
    /// present() shows can be found out after that.
    void await();
    /// What the device took for a frame lately, milliseconds; 0: nobody knows.
    double milliseconds() const { return ring_.milliseconds(); }
    /// Of the last frame that drew the scene.
    const SceneCounts& counts() const { return counts_; }
    void setGlyphs(const OverlayGlyphs& glyphs);
    void release();
    graph::Extent size() const { return swapchain_.upright(); }

private:
    bool prepare(graph::Extent wanted);
    void submit(gpu::FrameSlot& slot, const RenderSettings& settings, const passes::Atlas& atlas,
                const WindowFrame& frame);
    FrameEnd endOf(const WindowFrame& frame) const;
    SeenFrame see(const RenderSettings& settings, const passes::Atlas& atlas, const WindowFrame& frame,
                  std::optional<double> radiusBefore);
    DeclaredFrame& declared(const SeenFrame& seen);
    void declareEnd(ScreenFrame& frame, const FrameShape& shape);
    void makeSum();
    void prepareOthers();
    graph::Image addSum(graph::Graph& frame, graph::Image sample, bool first) const;
    graph::Image addPicture(graph::Graph& frame, graph::Image picture, std::uint32_t samples) const;
    void addOverlay(graph::Graph& frame, graph::Image window) const;
    bool coded() const;
    VkFormat pictureFormat() const;

    const gpu::Device& device_;
    gpu::Executor& executor_;
    SceneFrames& frames_;
    gpu::Swapchain swapchain_;
    gpu::FrameRing ring_;
    gpu::Retired retired_;  ///< by frames that are in flight; the next one takes it with it
    DeclaredFrames declared_;
    SceneCounts counts_;
    passes::OverlayPass overlay_;
    // Of the frame that is recorded, for its passes:
    ScreenTarget target_{};
    float share_ = 1;  ///< of a sum that is shown
    const Overlay* overlaid_ = nullptr;
    const gpu::FrameSlot* slot_ = nullptr;
    gpu::Image sum_;  ///< of the refined picture's samples
    bool preparedOthers_ = false;
    std::uint32_t summed_ = 0;  ///< of them, in it, or to be by what was submitted; 0: none are of use
};

}  // namespace nacre
