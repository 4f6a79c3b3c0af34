#pragma once

#include "engine/passes/full_screen.h"

namespace nacre::passes {

struct Resampling {
    std::uint32_t samples = 0;  ///< n: the picture has n x n texels per pixel of the target; 0: any other ratio
    bool coded = false;         ///< the target takes sRGB-coded colour
    float share = 1;            ///< factor for the picture's values
    bool add = false;           ///< to the target's contents
};

/// Scales a picture to another resolution.
void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how);
/// Requests the pipeline.
void wantResampling(gpu::PipelineContext& context, const Resampling& how);

}  // namespace nacre::passes
