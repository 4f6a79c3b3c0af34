#pragma once
// Counts the fragments that each pass shades, exactly, by an atomic in the shader. Passes with early tests count what
// the tests let through; those that write gl_FragDepth count what is rasterised.

#include <string_view>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/results.h"

namespace nacre::passes {

class FragmentCounter {
public:
    explicit FragmentCounter(const gpu::Device& device);

    /// The counter of a pass. Draws of the same pass add up.
    vk::DescriptorBufferInfo slot(std::string_view pass);
    /// Call behind the last draw.
    void finish(const vk::raii::CommandBuffer& commands) const;
    /// In the order of the frame; call when the commands have run.
    std::vector<PassCount> counts() const;

private:
    gpu::Buffer buffer_;
    std::vector<std::string> passes_;
};

}  // namespace nacre::passes
