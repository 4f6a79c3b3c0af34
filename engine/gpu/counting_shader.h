#pragma once
// Fragment stages that count the fragments that they shade, made from stages that do not.

#include <cstdint>
#include <span>

namespace nacre::gpu {

/// A copy of a stage whose empty function countFragment() (shaders/common/count.glsl) adds 1 to the word in binding 0
/// of set 1. Made once per stage and kept.
/// @param words  SPIR-V below 1.4, with names
/// @throws std::logic_error if it has no such function
std::span<const std::uint32_t> countingShader(std::span<const std::uint32_t> words);

}  // namespace nacre::gpu
