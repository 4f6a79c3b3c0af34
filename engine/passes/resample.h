#pragma once

#include <map>

#include "engine/gpu/execute.h"

namespace nacre::passes {

/// Takes a picture to another resolution.
class Resample {
public:
    explicit Resample(const gpu::Device& device);

    /// @param samples n: the picture has n x n texels for each pixel of the target; 0: any other ratio
    /// @param coded   the target takes sRGB-coded colour
    void draw(gpu::PassContext& context, vk::ImageView picture, std::uint32_t samples, bool coded);

private:
    vk::Pipeline pipeline(const gpu::PassContext& context, std::uint32_t samples, bool coded);

    const gpu::Device& device_;
    vk::raii::Sampler sampler_;
    gpu::Layout layout_;
    std::map<std::tuple<VkRenderPass, std::uint32_t, std::uint32_t, bool>, vk::raii::Pipeline> pipelines_;
};

}  // namespace nacre::passes
