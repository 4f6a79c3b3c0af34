#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/gpu/pipeline.h"

namespace nacre::gpu {

/// A stage without what its specialization constants never reach: branches, functions, outputs to the fragment stage
/// and inputs from the vertex stage. Drivers inline every function that a branch calls before they look at constants,
/// which takes most of their time for large stages. (SPIRV-Tools' optimizer takes longer than they do.)
/// @param words  a SPIR-V module @param constants  that the pipeline passes with it
std::vector<std::uint32_t> foldConstants(std::span<const std::uint32_t> words, const Specialization& constants);

}  // namespace nacre::gpu
