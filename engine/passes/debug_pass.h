#pragma once

#include <map>

#include "engine/debug_view.h"
#include "engine/gpu/execute.h"
#include "shaders/common/layout.h"

namespace nacre::passes {

/// Turns an image of the frame into a picture (shaders/debug_view.frag).
class DebugPass {
public:
    explicit DebugPass(const gpu::Device& device);

    struct Draw {
        DebugView view{};
        bool tileMean = false;   ///< sums tiles up instead
        std::uint32_t tile = 1;  ///< pixels across
        bool perspective = false;
        int quarterTurns = 0;
        layout::ViewConstants constants{};
    };
    /// @param under null if the view reads one image
    void draw(gpu::PassContext& context, const Draw& draw, vk::ImageView source, vk::ImageView under);

private:
    using Key = std::tuple<DebugView, bool, bool, int, VkRenderPass, std::uint32_t>;
    vk::Pipeline pipeline(const gpu::PassContext& context, const Draw& draw);

    const gpu::Device& device_;
    vk::raii::Sampler sampler_;
    gpu::Layout layout_;
    std::map<Key, vk::raii::Pipeline> pipelines_;
};

}  // namespace nacre::passes
