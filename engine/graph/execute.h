#pragma once
// Carries out a plan: makes the images, render passes and framebuffers it asks for, records barriers and passes.

#include <list>
#include <map>
#include <memory>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/resources.h"
#include "engine/graph/plan.h"

namespace nacre::graph {

class Executor;

/// Resources from outside, by the handles under which the graph imported them.
struct Imports {
    std::map<std::uint32_t, gpu::ImageRef> images;
    std::map<std::uint32_t, vk::Buffer> buffers;
    void bind(Image handle, const gpu::ImageRef& image) { images[handle.index] = image; }
    void bind(Buffer handle, const gpu::Buffer& buffer) { buffers[handle.index] = *buffer.handle; }
};

/// What a pass gets when it records.
struct PassContext {
    const vk::raii::CommandBuffer& commands;
    const gpu::Device& device;
    gpu::DescriptorPool& descriptors;
    vk::RenderPass renderPass;  ///< graphics passes
    std::uint32_t subpass = 0;
    std::uint32_t colorCount = 0;  ///< colour attachments of the subpass
    Extent extent;
    bool inputIsSampled = false;        ///< input reads come as textures
    std::vector<gpu::ImageRef> images;  ///< by graph index
    std::vector<vk::Buffer> buffers;

    vk::ImageView view(Image image) const { return images[image.index].view; }
    vk::Image image(Image image) const { return images[image.index].handle; }
    vk::Buffer buffer(Buffer buffer) const { return buffers[buffer.index]; }
};

class Executor {
public:
    explicit Executor(const gpu::Device& device);

    /// Records the plan of a graph. Images of the same graph and name are kept from one execution to the next.
    /// For commands that are waited for before the next ones are recorded: their descriptor sets last until then.
    void record(const vk::raii::CommandBuffer& commands, const Graph& graph, const Plan& plan, const Imports& imports) {
        reset();  // what failed half way may have left some
        record(commands, graph, plan, imports, descriptors_);
    }
    /// The same, with descriptor sets from a pool of the caller's, for frames that overlap.
    void record(const vk::raii::CommandBuffer& commands, const Graph& graph, const Plan& plan, const Imports& imports,
                gpu::DescriptorPool& descriptors);
    /// Call when nothing that was recorded is in flight: frees descriptor sets.
    void reset() { descriptors_.reset(); }
    /// Drops every image of this name's graph, so that its memory can be used for something else.
    void forget(const std::string& graph);
    /// Waits for the device and drops every framebuffer. Call before an imported attachment's view is destroyed.
    void forgetFramebuffers();

private:
    struct OwnedImage {
        VkImageUsageFlags usage;
        bool transient;
        gpu::Image image;
    };
    struct Framebuffer {
        std::vector<VkImageView> views;
        Extent extent;
        vk::raii::Framebuffer handle;
    };
    struct OwnedRenderPass {
        RenderPassPlan plan;  ///< without what changes from frame to frame
        vk::raii::RenderPass handle;
        std::list<Framebuffer> framebuffers;
    };

    const gpu::Image& own(const std::string& key, const ImageDesc& desc, const PlannedImage& planned);
    OwnedRenderPass& renderPass(const RenderPassPlan& plan, const std::string& name);
    vk::Framebuffer framebuffer(OwnedRenderPass& pass, const RenderPassPlan& plan, const PassContext& context,
                                const std::string& name);
    void barriers(const vk::raii::CommandBuffer& commands, const std::vector<Barrier>& barriers, const Graph& graph,
                  const PassContext& context) const;
    void recordRenderPass(const Graph& graph, const Plan& plan, const RenderPassPlan& pass, PassContext& context);

    const gpu::Device& device_;
    gpu::DescriptorPool descriptors_;
    std::map<std::string, OwnedImage> images_;
    std::list<OwnedRenderPass> renderPasses_;
};

/// The VkRenderPass of a plan.
vk::raii::RenderPass makeRenderPass(const gpu::Device& device, const RenderPassPlan& plan, const std::string& name);

}  // namespace nacre::graph
