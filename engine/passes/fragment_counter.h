#pragma once
// Counts the fragments that each pass shades, exactly, by an atomic in the shader. Passes with early depth tests count
// the fragments that pass; those that write gl_FragDepth count all rasterised fragments.

#include <string_view>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/results.h"

namespace nacre::passes {

class FragmentCounter {
public:
    explicit FragmentCounter(const gpu::Device& device);

    /// The counter of a pass. Draws of one pass are summed.
    vk::DescriptorBufferInfo slot(std::string_view pass);
    /// Call after the last draw.
    void finish(const vk::raii::CommandBuffer& commands) const;
    /// In frame order; call when the commands have run.
    std::vector<PassCount> counts() const;

private:
    gpu::Buffer buffer_;
    std::vector<std::string> passes_;
};

}  // namespace nacre::passes
