#pragma once
// Stages of draw calls that draw two views (VK_KHR_multiview), made from stages that draw one.

#include <cstdint>
#include <span>

namespace nacre::gpu {

/// The stage for draw calls of so many views. For two, a stage with viewIndex() (shaders/common/view_index.glsl)
/// becomes a copy in which that is gl_ViewIndex, and the sampled 2D image named "...OfView" is an array with a layer
/// for each view. Copies are made once and kept.
/// @param words  SPIR-V 1.3, with names; reads that image by texelFetch() alone
std::span<const std::uint32_t> forViews(std::span<const std::uint32_t> words, std::uint32_t views);

}  // namespace nacre::gpu
