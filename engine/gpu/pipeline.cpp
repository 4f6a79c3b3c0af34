#include "engine/gpu/pipeline.h"

#include <bit>

namespace nacre::gpu {

void Specialization::set(std::uint32_t id, std::uint32_t value) {
    entries_.emplace_back(id, static_cast<std::uint32_t>(values_.size() * sizeof(value)), sizeof(value));
    values_.push_back(value);
}

void Specialization::set(std::uint32_t id, float value) { set(id, std::bit_cast<std::uint32_t>(value)); }

vk::SpecializationInfo Specialization::info() const {
    return vk::SpecializationInfo(static_cast<std::uint32_t>(entries_.size()), entries_.data(),
                                  values_.size() * sizeof(std::uint32_t), values_.data());
}

namespace {

vk::PipelineColorBlendAttachmentState blendState(Blend blend, bool written) {
    vk::PipelineColorBlendAttachmentState state;
    if (written)
        state.colorWriteMask = vk::ColorComponentFlagBits::eR | vk::ColorComponentFlagBits::eG |
                               vk::ColorComponentFlagBits::eB | vk::ColorComponentFlagBits::eA;
    if (blend == Blend::minimum || blend == Blend::add) {
        state.blendEnable = true;
        state.srcColorBlendFactor = state.dstColorBlendFactor = vk::BlendFactor::eOne;
        state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = vk::BlendFactor::eOne;
        state.colorBlendOp = state.alphaBlendOp = blend == Blend::add ? vk::BlendOp::eAdd : vk::BlendOp::eMin;
    }
    if (blend == Blend::over) {
        state.blendEnable = true;
        state.srcColorBlendFactor = vk::BlendFactor::eSrcAlpha;
        state.srcAlphaBlendFactor = vk::BlendFactor::eOne;
        state.dstColorBlendFactor = state.dstAlphaBlendFactor = vk::BlendFactor::eOneMinusSrcAlpha;
    }
    return state;
}

vk::raii::ShaderModule makeModule(const Device& device, std::span<const std::uint32_t> code, const std::string& name) {
    vk::raii::ShaderModule module(*device, vk::ShaderModuleCreateInfo({}, code.size_bytes(), code.data()));
    device.name(*module, name);
    return module;
}

/// A pipeline with its name; a driver that cannot make it says no more than that.
template <typename Make>
vk::raii::Pipeline named(const Device& device, const std::string& name, Make&& make) {
    try {
        vk::raii::Pipeline pipeline = make();
        device.name(*pipeline, name);
        return pipeline;
    } catch (const vk::SystemError& failure) {
        throw Error("cannot make pipeline", name, inOneLine(failure.what()));
    }
}

}  // namespace

vk::raii::Pipeline makePipeline(const Device& device, const GraphicsPipeline& d) {
    const vk::raii::ShaderModule vertex = makeModule(device, d.vertex, d.name + ", vertex shader");
    const vk::raii::ShaderModule fragment = makeModule(device, d.fragment, d.name + ", fragment shader");
    const vk::SpecializationInfo constants = d.constants.info();
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main", &constants),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main", &constants)};
    const vk::PipelineVertexInputStateCreateInfo input({}, d.bindings, d.attributes);
    const vk::PipelineInputAssemblyStateCreateInfo assembly(
        {}, d.strip ? vk::PrimitiveTopology::eTriangleStrip : vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.cullMode = vk::CullModeFlagBits::eNone;
    raster.lineWidth = 1.0f;
    const vk::PipelineMultisampleStateCreateInfo samples;
    const vk::PipelineDepthStencilStateCreateInfo depth({}, d.depth != DepthUse::none, d.depth == DepthUse::write,
                                                        vk::CompareOp::eLessOrEqual);
    std::vector<vk::PipelineColorBlendAttachmentState> blends;
    for (std::uint32_t i = 0; i < d.colorCount; ++i) blends.push_back(blendState(d.blend, i < d.colorsWritten));
    vk::PipelineColorBlendStateCreateFlags blendFlags;
    if (d.ordered) blendFlags = vk::PipelineColorBlendStateCreateFlagBits::eRasterizationOrderAttachmentAccessEXT;
    const vk::PipelineColorBlendStateCreateInfo blend(blendFlags, false, vk::LogicOp::eCopy, blends);
    constexpr vk::DynamicState kDynamic[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, kDynamic);
    const vk::raii::PipelineCache* cache = device.caps().cacheMixesRenderPasses ? nullptr : &device.pipelineCache();
    return named(device, d.name, [&] {
        return vk::raii::Pipeline(
            *device, vk::Optional<const vk::raii::PipelineCache>(cache),
            vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport, &raster, &samples, &depth,
                                           &blend, &dynamic, d.layout, d.renderPass, d.subpass));
    });
}

vk::raii::Pipeline makeComputePipeline(const Device& device, std::span<const std::uint32_t> code,
                                       const Specialization& constants, vk::PipelineLayout layout,
                                       const std::string& name) {
    const vk::raii::ShaderModule module = makeModule(device, code, name + ", shader");
    const vk::SpecializationInfo info = constants.info();
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main", &info);
    return named(device, name, [&] {
        return vk::raii::Pipeline(*device, device.pipelineCache(), vk::ComputePipelineCreateInfo({}, stage, layout));
    });
}

Layout makeLayout(const Device& device, std::span<const vk::DescriptorType> types, vk::ShaderStageFlags stages,
                  std::uint32_t pushConstantBytes, const std::string& name, bool counter) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < types.size(); ++i) {
        // Input attachments exist in fragment stages only; streams are read by whatever stage asks.
        bindings.emplace_back(i, types[i], 1, stages & ~vk::ShaderStageFlags(vk::ShaderStageFlagBits::eVertex));
    }
    Layout layout;
    layout.set = vk::raii::DescriptorSetLayout(*device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    device.name(*layout.set, name + ", set 0");
    const vk::PushConstantRange range(stages, 0, pushConstantBytes);
    std::vector<vk::DescriptorSetLayout> sets{*layout.set};
    if (counter) {
        const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageBuffer, 1,
                                                     vk::ShaderStageFlagBits::eFragment);
        layout.counterSet = vk::raii::DescriptorSetLayout(*device, vk::DescriptorSetLayoutCreateInfo({}, binding));
        device.name(*layout.counterSet, name + ", set 1");
        sets.push_back(*layout.counterSet);
    }
    layout.pipeline = vk::raii::PipelineLayout(*device, vk::PipelineLayoutCreateInfo({}, sets, range));
    device.name(*layout.pipeline, name);
    return layout;
}

DescriptorPool::DescriptorPool(const Device& device) : device_(device) {
    constexpr std::uint32_t kSets = 256;
    const std::array sizes{vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, 2 * kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eInputAttachment, kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, 8 * kSets)};
    pool_ = vk::raii::DescriptorPool(*device, vk::DescriptorPoolCreateInfo({}, kSets, sizes));
    device.name(*pool_, "descriptors");
}

vk::DescriptorSet DescriptorPool::allocate(const vk::raii::DescriptorSetLayout& layout, const std::string& name) {
    const vk::DescriptorSetAllocateInfo info(*pool_, *layout);
    const vk::DescriptorSet set = (**device_).allocateDescriptorSets(info).front();
    device_.name(set, name);
    return set;
}

void DescriptorPool::reset() { pool_.reset(); }

}  // namespace nacre::gpu
