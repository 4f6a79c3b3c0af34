#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/gpu/execute.h"

namespace nacre::passes {

/// Declares the copy of a whole image into a buffer that the host reads.
/// @param buffer imported into the graph, at least as large as the image
void readBack(graph::Graph& g, graph::Image image, const graph::ImageDesc& desc, graph::Buffer buffer);

/// A texture, and the graph that fills it.
struct TextureUpload {
    gpu::Image image;
    gpu::Buffer bytes;  ///< until the graph has run
    graph::Graph graph;
    gpu::Imports imports;
};
TextureUpload uploadTexture(const gpu::Device& device, const graph::ImageDesc& desc,
                            std::span<const std::uint8_t> bytes, const std::string& name,
                            graph::Verb use = graph::Verb::samples);

/// A texture with these contents, in the state of its use, when the device is done with them.
/// @param bytes  all texels, row by row, layer by layer @param use  samples or density
gpu::Image makeTexture(const gpu::Device& device, gpu::Executor& executor, const graph::ImageDesc& desc,
                       std::span<const std::uint8_t> bytes, const std::string& name,
                       graph::Verb use = graph::Verb::samples);

/// A texture of one white texel, for passes without occlusion.
gpu::Image makeWhiteTexture(const gpu::Device& device, gpu::Executor& executor);

/// State of a texture between graphs.
constexpr graph::State kTextureState{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

}  // namespace nacre::passes
