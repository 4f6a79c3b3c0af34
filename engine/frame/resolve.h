#pragma once
// The one image in which all paths and sampling methods end, and which passes over the whole picture read.

#include "engine/frame/effects/lens/lens_pass.h"
#include "engine/frame/frame.h"
#include "engine/gpu/resources.h"
#include "engine/passes/resolve.h"

namespace nacre {

/// The picture's image, and parameters of the next frame that uses it.
struct PictureImage {
    gpu::Image image;
    gpu::Image finer;  ///< of its size, FinerPlaces::bytes()
    // Of the next frame that ends in it:
    passes::ResolvePlace place;
    const passes::TileFrame* tiles = nullptr;
    passes::Lens lens;  ///< of the next frame that reads it
};

/// Declares the pass that ends a frame in the image. @param to  read when the pass is recorded
void declareResolve(Frame& frame, const FrameShape& shape, const PictureImage& to);

}  // namespace nacre
