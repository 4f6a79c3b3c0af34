#pragma once
// The least that a bake can do on a device: read every depth map once and write the sums of every texel once.

#include <cstdint>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/resources.h"

namespace nacre::test {

class OcclusionFloor {
public:
    /// @param mapBytes  of one batch of `perBatch` maps, a multiple of 16
    OcclusionFloor(const gpu::Device& device, std::uint64_t mapBytes, std::uint32_t perBatch, std::uint64_t texels);

    /// Reads the maps of that many directions, batch after batch from the same buffer, as the bake has them; writes the
    /// sums with the last. Submits and waits.
    void run(std::uint32_t directions) const;

private:
    const gpu::Device& device_;
    std::uint32_t words_, perBatch_, texels_;
    gpu::Buffer maps_, sums_;
    gpu::Layout layout_;
    vk::raii::Pipeline pipeline_{nullptr};
};

}  // namespace nacre::test
