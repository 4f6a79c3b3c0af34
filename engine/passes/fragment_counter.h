#pragma once
// Counts the fragments that each pass shades, exactly, by an atomic in the shader. Passes with early tests count what
// the tests let through; those that write gl_FragDepth count what is rasterised.

#include <vector>

#include "engine/passes/geometry.h"
#include "engine/results.h"

namespace nacre::passes {

class FragmentCounter {
public:
    FragmentCounter(const gpu::Device& device, bool enabled);

    /// Makes a draw count, if counting is on. Draws of the same kind add up.
    void attach(Draw& draw);
    /// Call behind the last draw.
    void finish(const vk::raii::CommandBuffer& commands) const;
    /// In the order of the frame; call when the commands have run.
    std::vector<PassCount> counts() const;

private:
    bool enabled_;
    gpu::Buffer buffer_;
    std::vector<Writes> used_;
};

}  // namespace nacre::passes
