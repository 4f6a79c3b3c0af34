#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/device.h"

namespace nacre::gpu {

/// Specialization constants, all of 4 bytes: id and bits.
class Specialization {
public:
    void set(std::uint32_t id, std::uint32_t value);
    void set(std::uint32_t id, int value) { set(id, static_cast<std::uint32_t>(value)); }
    void set(std::uint32_t id, bool value) { set(id, value ? 1u : 0u); }
    void set(std::uint32_t id, float value);
    vk::SpecializationInfo info() const;

private:
    std::vector<vk::SpecializationMapEntry> entries_;
    std::vector<std::uint32_t> values_;
};

enum class DepthUse { none, test, write };
enum class Blend {
    replace,
    minimum,
    add,
    over,  ///< straight alpha, over an opaque picture
};

struct GraphicsPipeline {
    std::string name;
    std::span<const std::uint32_t> vertex, fragment;
    Specialization constants;  ///< for both stages
    std::vector<vk::VertexInputBindingDescription> bindings;
    std::vector<vk::VertexInputAttributeDescription> attributes;
    vk::PipelineLayout layout;
    vk::RenderPass renderPass;
    std::uint32_t subpass = 0;
    std::uint32_t colorCount = 0;     ///< of the subpass
    std::uint32_t colorsWritten = 0;  ///< of the pass; the others are masked
    DepthUse depth = DepthUse::none;
    Blend blend = Blend::replace;
    bool ordered = false;  ///< attachments are read in raster order
    bool strip = true;     ///< triangle strip, else list
};

/// A pipeline; viewport and scissor are dynamic.
vk::raii::Pipeline makePipeline(const Device& device, const GraphicsPipeline& description);

vk::raii::Pipeline makeComputePipeline(const Device& device, std::span<const std::uint32_t> code,
                                       const Specialization& constants, vk::PipelineLayout layout,
                                       const std::string& name);

/// A layout of one set (bindings numbered from 0) and one range of push constants.
struct Layout {
    vk::raii::DescriptorSetLayout set{nullptr};
    vk::raii::DescriptorSetLayout counterSet{nullptr};  ///< set 1, if asked for: one storage buffer
    vk::raii::PipelineLayout pipeline{nullptr};
};
Layout makeLayout(const Device& device, std::span<const vk::DescriptorType> bindings, vk::ShaderStageFlags stages,
                  std::uint32_t pushConstantBytes, const std::string& name, bool counter = false);

/// Descriptor sets that live as long as one recorded frame.
class DescriptorPool {
public:
    explicit DescriptorPool(const Device& device);
    vk::DescriptorSet allocate(const vk::raii::DescriptorSetLayout& layout, const std::string& name = "descriptors");
    void reset();

private:
    const Device& device_;
    vk::raii::DescriptorPool pool_{nullptr};
};

}  // namespace nacre::gpu
