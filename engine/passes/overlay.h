#pragma once

#include "engine/gpu/execute.h"
#include "engine/gpu/frame_ring.h"
#include "engine/overlay.h"

namespace nacre::passes {

/// Draws an application's triangles over the picture.
class OverlayPass {
public:
    OverlayPass(const gpu::Device& device, gpu::Executor& executor);

    /// Replaces the glyph texture. Nothing may be in flight. @throws Error if the texture exceeds the device's limit
    void setGlyphs(gpu::Executor& executor, const OverlayGlyphs& glyphs);
    /// Uploads the triangles.
    void upload(gpu::FrameSlot& slot, const Overlay& overlay) const;
    /// @param upright size of the picture as seen, pixels
    /// @param coded   the target takes sRGB-coded colour
    void draw(gpu::PassContext& context, const gpu::FrameSlot& slot, const Overlay& overlay, graph::Extent upright,
              int quarterTurns, bool coded) const;
    /// Requests the pipeline.
    static void want(gpu::PipelineContext& context, int quarterTurns, bool coded);

private:
    const gpu::Device& device_;
    gpu::Image glyphs_;
};

}  // namespace nacre::passes
