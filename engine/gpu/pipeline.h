#pragma once
// Pipelines, layouts and samplers. Each is described by a value and made when first asked for.

#include <array>
#include <bit>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/gpu/dynamic_rendering.h"

namespace nacre::gpu {

using ShaderWords = std::span<const std::uint32_t>;

/// Specialization constants of 4 bytes each: id (shaders/common/layout.h) and bits.
class Specialization {
public:
    void set(int id, std::uint32_t value);
    void set(int id, int value) { set(id, static_cast<std::uint32_t>(value)); }
    void set(int id, bool value) { set(id, value ? 1u : 0u); }
    void set(int id, float value) { set(id, std::bit_cast<std::uint32_t>(value)); }
    /// Replaces a value that was set.
    void change(int id, std::uint32_t value);
    void change(int id, float value) { change(id, std::bit_cast<std::uint32_t>(value)); }
    /// Empty if it was not set.
    std::optional<std::uint32_t> value(std::uint32_t id) const;
    /// Points into this.
    vk::SpecializationInfo info() const;
    friend bool operator==(const Specialization&, const Specialization&) = default;

private:
    static constexpr std::size_t kMost = 40;
    std::array<vk::SpecializationMapEntry, kMost> entries_{};
    std::array<std::uint32_t, kMost> values_{};
    std::uint32_t count_ = 0;
};

enum class DepthUse : std::uint8_t { none, test, write };
enum class Blend : std::uint8_t {
    replace,
    minimum,
    maximum,
    add,
    over,           ///< straight alpha, over an opaque picture
    overRed,        ///< like over, in the red channel alone
    overCyan,       ///< like over, in green and blue
    premultiplied,  ///< over any picture
};

/// Vertex streams of a pipeline. Both tables are static: comparison uses their addresses.
struct VertexStreams {
    std::span<const vk::VertexInputBindingDescription> bindings;
    std::span<const vk::VertexInputAttributeDescription> attributes;
};

struct GraphicsPipeline {
    std::string_view name, detail;  ///< "impostor colour", "spheres": for captures and messages
    ShaderWords vertex, fragment;
    Specialization constants;  ///< for both stages
    VertexStreams streams;
    vk::PipelineLayout layout;
    vk::RenderPass renderPass;
    std::uint32_t subpass = 0;
    RenderingFormats rendering;       ///< where there is no render pass
    std::uint32_t colorCount = 0;     ///< of the subpass
    std::uint32_t samples = 1;        ///< per pixel; shading runs once per fragment
    std::uint32_t colorsWritten = 0;  ///< by the pass; others are masked
    DepthUse depth = DepthUse::none;
    Blend blend = Blend::replace;
    bool ordered = false;  ///< it reads attachments in raster order
    bool strip = true;     ///< triangle strip, else list
};

struct ComputePipeline {
    std::string_view name;
    ShaderWords code;
    Specialization constants;
    vk::PipelineLayout layout;
};

/// A layout of one set (bindings numbered from 0) and one range of push constants.
struct LayoutDescription {
    std::string_view name;
    std::span<const vk::DescriptorType> bindings;  ///< static; the vertex stage reads uniform buffers only
    vk::ShaderStageFlags stages;
    std::uint32_t pushConstantBytes = 0;
    bool counter = false;          ///< set 1 has one storage buffer
    std::uint32_t ofVertices = 0;  ///< the vertex stage reads this many bindings, the last ones
    bool shared = false;           ///< the fragment stage also reads those
};
struct Layout {
    vk::raii::DescriptorSetLayout set{nullptr};
    vk::raii::DescriptorSetLayout counterSet{nullptr};
    vk::raii::PipelineLayout pipeline{nullptr};
};

/// Viewport and scissor are dynamic. @throws Error with the pipeline's name
vk::raii::Pipeline makePipeline(const Device& device, const GraphicsPipeline& description);
vk::raii::Pipeline makePipeline(const Device& device, const ComputePipeline& description);
Layout makeLayout(const Device& device, const LayoutDescription& description);

/// Ignores names.
bool samePipeline(const GraphicsPipeline& a, const GraphicsPipeline& b);
bool samePipeline(const ComputePipeline& a, const ComputePipeline& b);

class PipelineWorker;

/// All objects made so far. Equal descriptions share one object.
class Pipelines {
public:
    /// @param device  must outlive this
    explicit Pipelines(const Device& device);
    ~Pipelines();

    /// Starts a worker thread that compiles likely pipelines until endAhead().
    void makeAhead();
    void endAhead();
    bool makesAhead() const { return worker_ != nullptr; }
    /// Whether the worker still has work.
    bool busyAhead() const;
    /// Queues a pipeline for the worker, once. Does nothing without a worker.
    void want(const GraphicsPipeline& description);
    void want(const ComputePipeline& description);

    vk::Pipeline graphics(const GraphicsPipeline& description);
    /// @param next  returns likely next pipelines; called if this one is new and there is a worker
    template <typename Next>
    vk::Pipeline graphics(const GraphicsPipeline& description, const Next& next) {
        const std::size_t before = graphics_.size();
        const vk::Pipeline pipeline = graphics(description);
        if (worker_ && graphics_.size() > before)
            for (const GraphicsPipeline& other : next()) want(other);
        return pipeline;
    }
    vk::Pipeline compute(const ComputePipeline& description);
    const Layout& layout(const LayoutDescription& description);
    vk::Sampler sampler(vk::Filter filter);
    /// Pipelines made so far, without those that the worker has ready.
    std::size_t count() const { return graphics_.size() + compute_.size(); }

private:
    template <typename Description>
    struct Made {
        Description description;
        vk::raii::Pipeline pipeline;
    };
    struct MadeLayout {
        LayoutDescription description;
        Layout layout;
    };
    const Device& device_;
    std::unique_ptr<PipelineWorker> worker_;  ///< null: pipelines are made when first asked for
    std::vector<Made<GraphicsPipeline>> graphics_;
    std::vector<Made<ComputePipeline>> compute_;
    std::list<MadeLayout> layouts_;  // references to elements stay valid
    std::map<vk::Filter, vk::raii::Sampler> samplers_;
};

/// Descriptor sets that live as long as one recorded frame.
class DescriptorPool {
public:
    explicit DescriptorPool(const Device& device);
    vk::DescriptorSet allocate(const vk::raii::DescriptorSetLayout& layout, std::string_view name);
    void reset();

private:
    const Device& device_;
    vk::raii::DescriptorPool pool_{nullptr};
};

}  // namespace nacre::gpu
