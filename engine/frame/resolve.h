#pragma once
// The one image that all paths and all ways to sample end in, for passes over the whole picture behind them.

#include "engine/frame/effects/lens/lens_pass.h"
#include "engine/frame/frame.h"
#include "engine/gpu/resources.h"
#include "engine/passes/resolve.h"

namespace nacre {

/// The picture's image, and parameters of the next frame that uses it.
struct PictureImage {
    gpu::Image image;
    gpu::Image finer;  ///< of its size: not 0 where a pixel takes more samples than one
    // Of the next frame that ends in it:
    passes::ResolvePlace place;
    const passes::TileFrame* tiles = nullptr;
    passes::Lens lens;  ///< of the next frame that reads it
};

/// Declares the pass that ends a frame in the image. @param to  read when the pass is recorded
void declareResolve(Frame& frame, const FrameShape& shape, const PictureImage& to);

}  // namespace nacre
