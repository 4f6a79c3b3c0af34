#pragma once

#include "engine/passes/full_screen.h"

namespace nacre::passes {

/// Takes a picture to another resolution.
/// @param samples n: the picture has n x n texels for each pixel of the target; 0: any other ratio
/// @param coded   the target takes sRGB-coded colour
void resample(gpu::PassContext& context, vk::ImageView picture, std::uint32_t samples, bool coded);

}  // namespace nacre::passes
