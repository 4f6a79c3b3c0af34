#pragma once
// Carries out a plan: makes the images, render passes and framebuffers it asks for, records barriers and passes.

#include <list>
#include <map>
#include <memory>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/recording.h"
#include "engine/gpu/resources.h"
#include "engine/gpu/timer.h"
#include "engine/graph/plan.h"
#include "engine/results.h"

namespace nacre::gpu {

/// What a pass's pipelines depend on.
struct PipelineContext {
    const Device& device;
    Pipelines& pipelines;
    std::string_view pass{};      ///< its name in the graph
    vk::RenderPass renderPass{};  ///< of graphics passes' pipelines; null where they are rendered dynamically
    std::uint32_t subpass = 0;
    RenderingFormats rendering{};  ///< of these
    std::uint32_t colorCount = 0;  ///< colour attachments of the subpass
    graph::Extent extent{};
    bool inputIsSampled = false;  ///< input reads come as textures

    /// A pipeline of this pass: its name, render pass, subpass and number of colour attachments.
    GraphicsPipeline pipeline() const {
        GraphicsPipeline p;
        p.name = pass;
        p.renderPass = renderPass;
        p.subpass = subpass;
        p.rendering = rendering;
        p.colorCount = colorCount;
        return p;
    }
};

/// What a pass gets when it records.
struct PassContext : PipelineContext {
    const vk::raii::CommandBuffer& commands;
    DescriptorPool& descriptors;
    vk::ImageLayout inputLayout = vk::ImageLayout::eShaderReadOnlyOptimal;  ///< of input attachments
    std::span<const ImageRef> images{};                                     ///< by graph index
    std::span<const vk::Buffer> buffers{};

    vk::ImageView view(graph::Image image) const { return images[image.index].view; }
    vk::Image image(graph::Image image) const { return images[image.index].handle; }
    vk::Buffer buffer(graph::Buffer buffer) const { return buffers[buffer.index]; }
};

struct Framebuffer {
    std::vector<VkImageView> views;
    graph::Extent extent;
    vk::raii::Framebuffer handle;
    std::string graph;  ///< that it was made for
};
struct OwnedRenderPass {
    graph::RenderPassPlan plan;  ///< without what changes from frame to frame
    vk::raii::RenderPass handle;
    vk::RenderPass ofPipelines;  ///< the first that is compatible: a pipeline made for it serves this, too
    MergedSubpasses merged;
    std::list<Framebuffer> framebuffers;
};

class Executor {
public:
    explicit Executor(const Device& device);
    ~Executor() { pipelines_.endAhead(); }  // which work with render passes of this

    /// Pipelines that frames are likely to ask for next are made on a thread of its own from now on.
    void makePipelinesAhead() { pipelines_.makeAhead(); }

    bool makesPipelinesAhead() const { return pipelines_.makesAhead(); }
    /// Whether that thread is still at what it was asked for.
    bool makesPipelines() const { return pipelines_.busyAhead(); }

    /// Has the pipelines that a graph's passes want (graph::Work) made by that thread.
    void prepare(const graph::Graph& graph, const graph::Plan& plan);
    /// The same of compute pipelines, outside any graph.
    template <typename Want>
    void prepare(const Want& want) {
        PipelineContext context{device_, pipelines_};
        want(context);
    }

    /// Records a graph as planned. Images of the same graph and name are kept from one execution to the next.
    /// For commands that are waited for before the next ones are recorded: their descriptor sets last until then.
    void record(CommandBuffer& commands, Recording& recording, const Imports& imports, Timer* timer = nullptr) {
        reset();  // what failed half way may have left some
        record(commands, recording, imports, descriptors_, timer);
    }
    void record(CommandBuffer& commands, const graph::Graph& graph, const graph::Plan& plan, const Imports& imports,
                Timer* timer = nullptr) {
        Recording once(graph, plan);
        record(commands, once, imports, timer);
    }
    /// The same, with descriptor sets from a pool of the caller's, for frames that overlap.
    /// @param timer    not null: takes a lap for each render pass, dispatch and copy
    /// @param retired  not null: gets what is replaced, as images are when their size changes, until these commands are
    ///                 done. Else that is waited for
    void record(CommandBuffer& commands, Recording& recording, const Imports& imports, DescriptorPool& descriptors,
                Timer* timer = nullptr, Retired* retired = nullptr);
    void record(CommandBuffer& commands, const graph::Graph& graph, const graph::Plan& plan, const Imports& imports,
                DescriptorPool& descriptors, Timer* timer = nullptr) {
        Recording once(graph, plan);
        record(commands, once, imports, descriptors, timer);
    }
    /// Compiles a graph, by the device's caps, carries it out and waits until it is done.
    void run(const graph::Graph& graph, const Imports& imports);
    void run(const graph::Graph& graph, const graph::Plan& plan, const Imports& imports);
    /// Call when nothing that was recorded is in flight: frees descriptor sets.
    void reset() { descriptors_.reset(); }
    /// Drops every image of this name's graph, so that its memory can be used for something else. Call when nothing
    /// that was recorded of it is in flight; what else is, nobody waits for.
    void forget(const std::string& graph);
    /// What the driver made of the render passes that were recorded so far, and of transient images. Not for every
    /// frame: it asks the driver.
    DriverFeedback feedback() const;
    /// Waits for the device and drops every framebuffer. Call before an imported attachment's view is destroyed.
    void forgetFramebuffers();
    /// The same without a wait, for whoever keeps them until what is in flight is done.
    void retireFramebuffers(Retired& retired);

private:
    struct OwnedImage {
        VkImageUsageFlags usage;
        bool transient;
        Image image;
    };
    const Image& own(const std::string& key, const graph::ImageDesc& desc, const graph::PlannedImage& planned,
                     Retired* retired);
    OwnedRenderPass& renderPass(const graph::RenderPassPlan& plan, const std::string& name);
    vk::Framebuffer framebuffer(OwnedRenderPass& pass, const graph::RenderPassPlan& plan, Recording& recording,
                                const std::string& name);
    void bind(Recording& recording, const Imports& imports, Retired* retired);
    void barriers(const vk::raii::CommandBuffer& commands, const std::vector<graph::Barrier>& barriers,
                  Recording& recording) const;
    void beginRenderPass(Recording& recording, std::size_t step, PassContext& context);
    void recordRenderPass(Recording& recording, std::size_t step, PassContext& context);

    const Device& device_;
    Pipelines pipelines_;
    DescriptorPool descriptors_;
    std::map<std::string, OwnedImage> images_;
    std::list<OwnedRenderPass> renderPasses_;
};

/// The VkRenderPass of a plan.
/// @param merged  gets what the driver makes of its subpasses, where the driver tells
vk::raii::RenderPass makeRenderPass(const Device& device, const graph::RenderPassPlan& plan, const std::string& name,
                                    MergedSubpasses& merged);

}  // namespace nacre::gpu
