#pragma once

#include "engine/gpu/execute.h"
#include "engine/gpu/frame_ring.h"
#include "engine/overlay.h"

namespace nacre::passes {

/// Draws an application's triangles over the picture.
class OverlayPass {
public:
    OverlayPass(const gpu::Device& device, gpu::Executor& executor);

    /// Replaces the glyph texture; nothing may be in flight. @throws Error if the texture is larger than the device
    /// takes
    void setGlyphs(gpu::Executor& executor, const OverlayGlyphs& glyphs);
    /// Puts the triangles where the device reads them.
    void upload(gpu::FrameSlot& slot, const Overlay& overlay) const;
    /// @param upright pixels of the picture as it is seen
    /// @param coded   the target takes sRGB-coded colour
    void draw(gpu::PassContext& context, const gpu::FrameSlot& slot, const Overlay& overlay, graph::Extent upright,
              int quarterTurns, bool coded) const;
    /// Asks for the pipeline of that.
    static void want(gpu::PipelineContext& context, int quarterTurns, bool coded);

private:
    const gpu::Device& device_;
    gpu::Image glyphs_;
};

}  // namespace nacre::passes
