#pragma once
// A graph and its plan, prepared for recording every frame: everything that depends on them alone is computed once.

#include <string>
#include <utility>
#include <vector>

#include "engine/gpu/resources.h"
#include "engine/graph/plan.h"

namespace nacre::gpu {

/// Resources from outside, by the handles under which the graph imported them.
class Imports {
public:
    void bind(graph::Image handle, const ImageRef& image) { images_.emplace_back(handle.index, image); }
    void bind(graph::Buffer handle, const Buffer& buffer) { buffers_.emplace_back(handle.index, *buffer.handle); }
    void clear() { images_.clear(), buffers_.clear(); }
    /// The last bound image; null: none.
    const ImageRef* image(std::uint32_t index) const { return last(images_, index); }
    const vk::Buffer* buffer(std::uint32_t index) const { return last(buffers_, index); }

private:
    template <typename T>
    static const T* last(const std::vector<std::pair<std::uint32_t, T>>& bound, std::uint32_t index) {
        for (auto it = bound.rbegin(); it != bound.rend(); ++it)
            if (it->first == index) return &it->second;
        return nullptr;
    }
    std::vector<std::pair<std::uint32_t, ImageRef>> images_;
    std::vector<std::pair<std::uint32_t, vk::Buffer>> buffers_;
};

struct OwnedRenderPass;  // execute.h

/// Serves one executor. Holds a frame's scratch memory, so that recording again allocates nothing.
class Recording {
public:
    /// Both outlive this.
    Recording(const graph::Graph& graph, const graph::Plan& plan);
    Recording(const Recording&) = delete;

private:
    friend class Executor;
    struct RenderPass {
        std::string name;  ///< "opaque prepass + depth encoding"
        std::vector<vk::ClearValue> clears;
        OwnedRenderPass* made = nullptr;
    };
    const graph::Graph& graph_;
    const graph::Plan& plan_;
    std::string work_;                      // for the log: "screen: opaque prepass, impostor colour"
    std::vector<std::string> owned_;        // by graph index: names of the executor's own images
    std::vector<RenderPass> renderPasses_;  // by step
    // Valid for one recording:
    std::vector<ImageRef> images_;     // by graph index
    std::vector<vk::Buffer> buffers_;  // by graph index
    std::vector<VkImageView> views_;
    std::vector<vk::ImageMemoryBarrier> imageBarriers_;
    std::vector<vk::BufferMemoryBarrier> bufferBarriers_;
};

}  // namespace nacre::gpu
