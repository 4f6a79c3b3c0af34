#pragma once
// Frames for a window: the screen frame into the swapchain's image, or by way of a picture at another resolution, and
// the application's overlay on top.

#include <optional>

#include "engine/frame/screen_frame.h"
#include "engine/gpu/frame_ring.h"
#include "engine/gpu/swapchain.h"
#include "engine/graph/plan_cache.h"
#include "engine/passes/overlay_pass.h"
#include "engine/passes/resample.h"
#include "engine/renderer.h"

namespace nacre {

class WindowFrames {
public:
    /// Declares the screen frame of a view with its recorders, and binds what it imports but for the window's image.
    using Declare =
        std::function<ScreenFrame(const View&, std::span<const ScreenTarget>, const char* name, gpu::Imports&)>;

    WindowFrames(const gpu::Device& device, gpu::Executor& executor, const SurfaceSource& source);
    ~WindowFrames() { device_.settle(); }

    /// @param view of the upright window; one of another size is not drawn, and told by FrameOutcome::resized
    FrameOutcome present(const View& view, const std::array<float, 4>& background, const WindowFrame& frame,
                         const Declare& declare);
    void setGlyphs(const OverlayGlyphs& glyphs);
    void release();
    graph::Extent size() const { return swapchain_.upright(); }

private:
    bool prepare(graph::Extent wanted);
    void submit(gpu::FrameSlot& slot, const View& view, const graph::Clear& clear, const WindowFrame& frame,
                const Declare& declare);
    ScreenFrame declareFrame(const View& view, const graph::Clear& clear, const WindowFrame& frame,
                             const Declare& declare, gpu::Imports& imports);
    graph::Image addPicture(ScreenFrame& frame, graph::Image picture, std::uint32_t samples);
    void addOverlay(ScreenFrame& frame, graph::Image window, const Overlay* overlay, gpu::FrameSlot& slot);
    bool coded() const;

    const gpu::Device& device_;
    gpu::Executor& executor_;
    gpu::Swapchain swapchain_;
    gpu::FrameRing ring_;
    graph::PlanCache plans_;
    passes::OverlayPass overlay_;
    passes::Resample resample_;
    gpu::Image kept_;         ///< the refined picture
    bool keptDrawn_ = false;  ///< it has been drawn, or will be by what was submitted
};

}  // namespace nacre
