#pragma once
// Executes a plan: makes its images, render passes and framebuffers, records barriers and passes.

#include <list>
#include <map>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/recording.h"
#include "engine/gpu/resources.h"
#include "engine/gpu/timer.h"
#include "engine/graph/plan.h"
#include "engine/results.h"

namespace nacre::gpu {

class RegionCounters;

/// Everything that a pass's pipelines depend on.
struct PipelineContext {
    const Device& device;
    Pipelines& pipelines;
    std::string_view pass{};      ///< name in the graph
    vk::RenderPass renderPass{};  ///< for graphics pipelines; null with dynamic rendering
    std::uint32_t subpass = 0;
    RenderingFormats rendering{};  ///< without a render pass
    std::uint32_t colorCount = 0;  ///< colour attachments of the subpass
    std::uint32_t samples = 1;     ///< per pixel of the attachments
    std::uint32_t views = 1;       ///< per draw call
    graph::Extent extent{};
    bool inputIsSampled = false;  ///< inputs are read as textures

    /// Description of a pipeline for this pass: name, render pass, subpass and number of colour attachments.
    GraphicsPipeline pipeline() const {
        GraphicsPipeline p;
        p.name = pass;
        p.renderPass = renderPass;
        p.subpass = subpass;
        p.rendering = rendering;
        p.colorCount = colorCount;
        p.samples = samples;
        return p;
    }
};

/// Passed to a pass when it records.
struct PassContext : PipelineContext {
    const vk::raii::CommandBuffer& commands;
    DescriptorPool& descriptors;
    vk::ImageLayout inputLayout = vk::ImageLayout::eShaderReadOnlyOptimal;  ///< of input attachments
    std::span<const ImageRef> images{};                                     ///< by graph index
    std::span<const vk::Buffer> buffers{};
    graph::Share share{};  ///< of the scene's primitives

    vk::ImageView view(graph::Image image) const { return images[image.index].view; }
    vk::Image image(graph::Image image) const { return images[image.index].handle; }
    vk::Buffer buffer(graph::Buffer buffer) const { return buffers[buffer.index]; }
};

struct Framebuffer {
    std::vector<VkImageView> views;
    graph::Extent extent;
    vk::raii::Framebuffer handle;
    std::string graph;  ///< the graph that it was made for
};
struct OwnedRenderPass {
    graph::RenderPassPlan plan;  ///< without values that change per frame
    vk::raii::RenderPass handle;
    vk::RenderPass ofPipelines;  ///< first compatible render pass, for which the pipelines were made
    MergedSubpasses merged;
    std::list<Framebuffer> framebuffers;
};

class Executor {
public:
    explicit Executor(const Device& device);
    ~Executor() { pipelines_.endAhead(); }  // the worker uses these render passes

    /// Starts a worker thread that makes pipelines that coming frames are likely to need.
    void makePipelinesAhead() { pipelines_.makeAhead(); }

    /// Pipelines made so far; they are kept.
    std::size_t pipelines() const { return pipelines_.count(); }
    bool makesPipelinesAhead() const { return pipelines_.makesAhead(); }
    /// Whether the worker thread still has work.
    bool makesPipelines() const { return pipelines_.busyAhead(); }

    /// Queues the pipelines that a graph's passes want (graph::Work) for the worker thread.
    void prepare(const graph::Graph& graph, const graph::Plan& plan);
    /// As above for compute pipelines outside a graph.
    template <typename Want>
    void prepare(const Want& want) {
        PipelineContext context{device_, pipelines_};
        want(context);
    }

    /// Records a planned graph. Images of the same graph and name are kept between executions. Only for commands that
    /// are waited for before the next recording: descriptor sets last until then.
    void record(CommandBuffer& commands, Recording& recording, const Imports& imports, Timer* timer = nullptr) {
        reset();  // a failed recording may have left some
        record(commands, recording, imports, descriptors_, timer);
    }
    void record(CommandBuffer& commands, const graph::Graph& graph, const graph::Plan& plan, const Imports& imports,
                Timer* timer = nullptr) {
        Recording once(graph, plan);
        record(commands, once, imports, timer);
    }
    /// As above, with descriptor sets from the caller's pool, for overlapping frames.
    /// @param timer    not null: takes a lap per render pass, dispatch and copy
    /// @param retired  not null: keeps replaced objects (images after a resize) until these commands are done. Null:
    /// waits
    void record(CommandBuffer& commands, Recording& recording, const Imports& imports, DescriptorPool& descriptors,
                Timer* timer = nullptr, Retired* retired = nullptr);
    void record(CommandBuffer& commands, const graph::Graph& graph, const graph::Plan& plan, const Imports& imports,
                DescriptorPool& descriptors, Timer* timer = nullptr) {
        Recording once(graph, plan);
        record(commands, once, imports, descriptors, timer);
    }
    /// Compiles a graph for the device's caps, executes it and waits.
    void run(const graph::Graph& graph, const Imports& imports);
    void run(const graph::Graph& graph, const graph::Plan& plan, const Imports& imports);
    /// Lets counters count the render passes that are recorded from now on; null: none.
    void countRegions(RegionCounters* counters) { regions_ = counters; }
    /// Frees descriptor sets. Nothing recorded may be in flight.
    void reset() { descriptors_.reset(); }
    /// Drops every image of the graph of this name to free its memory. Nothing of that graph may be in flight; the call
    /// does not wait.
    void forget(const std::string& graph);
    /// How the driver merged the render passes recorded so far, and its transient images. Queries the driver: not for
    /// every frame.
    DriverFeedback feedback() const;
    /// Waits for the device and drops every framebuffer. Call before an imported attachment's view is destroyed.
    void forgetFramebuffers();
    /// As above without waiting: the caller keeps them until everything in flight is done.
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
    RegionCounters* regions_ = nullptr;
};

/// The VkRenderPass of a plan.
/// @param merged  receives how the driver merges its subpasses, where it reports that
vk::raii::RenderPass makeRenderPass(const Device& device, const graph::RenderPassPlan& plan, const std::string& name,
                                    MergedSubpasses& merged);

}  // namespace nacre::gpu
