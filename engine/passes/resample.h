#pragma once

#include "engine/passes/full_screen.h"

namespace nacre::passes {

struct Resampling {
    std::uint32_t samples = 0;  ///< n: the picture has n x n texels for each pixel of the target; 0: any other ratio
    bool coded = false;         ///< the target takes sRGB-coded colour
    float share = 1;            ///< what the picture is multiplied with
    bool add = false;           ///< to what the target holds
};

/// Takes a picture to another resolution.
void resample(gpu::PassContext& context, vk::ImageView picture, const Resampling& how);
/// Asks for the pipeline of that.
void wantResampling(gpu::PipelineContext& context, const Resampling& how);

}  // namespace nacre::passes
