#pragma once
// Rows of bins or tiles that show anything, as rectangles: fragments draw their pixels.

#include "engine/tiles/listed_frame.h"

namespace nacre::passes {

/// Binds the rows, and draws them.
inline void drawSpans(gpu::PassContext& context, const ListedFrame& frame) {
    context.commands.bindVertexBuffers(0, {*frame.spanVertices.buffer.handle}, {0});
    context.commands.draw(4, frame.rowCount, 0, 0);
}

/// The vertex stream of drawSpans().
gpu::VertexStreams spanStreams();

}  // namespace nacre::passes
