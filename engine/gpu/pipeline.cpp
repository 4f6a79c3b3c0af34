#include "engine/gpu/pipeline.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "engine/gpu/fold_constants.h"
#include "engine/gpu/pipeline_worker.h"
#include "engine/gpu/resources.h"

namespace nacre::gpu {

void Specialization::set(int id, std::uint32_t value) {
    if (count_ == kMost) throw std::logic_error("more specialization constants than a pipeline here has");
    entries_[count_] = vk::SpecializationMapEntry(static_cast<std::uint32_t>(id),
                                                  count_ * static_cast<std::uint32_t>(sizeof(value)), sizeof(value));
    values_[count_++] = value;
}

void Specialization::change(int id, std::uint32_t value) {
    for (std::uint32_t i = 0; i < count_; ++i)
        if (entries_[i].constantID == static_cast<std::uint32_t>(id)) values_[i] = value;
}

std::optional<std::uint32_t> Specialization::value(std::uint32_t id) const {
    for (std::uint32_t i = 0; i < count_; ++i)
        if (entries_[i].constantID == id) return values_[i];
    return std::nullopt;
}

vk::SpecializationInfo Specialization::info() const {
    return vk::SpecializationInfo(count_, entries_.data(), count_ * sizeof(std::uint32_t), values_.data());
}

namespace {

vk::ColorComponentFlags colorMask(Blend blend) {
    using Channel = vk::ColorComponentFlagBits;
    if (blend == Blend::overRed) return Channel::eR;
    if (blend == Blend::overCyan) return Channel::eG | Channel::eB;
    return Channel::eR | Channel::eG | Channel::eB | Channel::eA;
}

vk::PipelineColorBlendAttachmentState blendState(Blend blend, bool written) {
    vk::PipelineColorBlendAttachmentState state;
    if (written) state.colorWriteMask = colorMask(blend);
    if (blend == Blend::minimum || blend == Blend::maximum || blend == Blend::add) {
        state.blendEnable = true;
        state.srcColorBlendFactor = state.dstColorBlendFactor = vk::BlendFactor::eOne;
        state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = vk::BlendFactor::eOne;
        state.colorBlendOp = state.alphaBlendOp = blend == Blend::add       ? vk::BlendOp::eAdd
                                                  : blend == Blend::maximum ? vk::BlendOp::eMax
                                                                            : vk::BlendOp::eMin;
    }
    const bool premultiplied = blend == Blend::premultiplied;
    if (blend == Blend::over || blend == Blend::overRed || blend == Blend::overCyan || premultiplied) {
        state.blendEnable = true;
        state.srcColorBlendFactor = premultiplied ? vk::BlendFactor::eOne : vk::BlendFactor::eSrcAlpha;
        state.srcAlphaBlendFactor = vk::BlendFactor::eOne;
        state.dstColorBlendFactor = state.dstAlphaBlendFactor = vk::BlendFactor::eOneMinusSrcAlpha;
    }
    return state;
}

vk::raii::ShaderModule makeModule(const Device& device, std::span<const std::uint32_t> stage,
                                  const Specialization& constants, const std::string& name) {
    const std::vector<std::uint32_t> code = foldConstants(stage, constants);
    const std::span<const std::uint32_t> words(code);
    vk::raii::ShaderModule module(*device, vk::ShaderModuleCreateInfo({}, words.size_bytes(), words.data()));
    device.name(*module, name);
    return module;
}

std::string fullName(const GraphicsPipeline& d) {
    return std::string(d.name) + (d.detail.empty() ? "" : ", ") + std::string(d.detail);
}

template <typename T>
std::uint32_t toCount(std::span<const T> table) {
    return static_cast<std::uint32_t>(table.size());
}

/// Excludes other threads from the driver's compiler, where it is not thread-safe.
std::unique_lock<std::mutex> lockCompiler(const Device& device) {
    static std::mutex compiling;
    std::unique_lock lock(compiling, std::defer_lock);
    if (device.caps().has(graph::Quirk::oneCompiler)) lock.lock();
    return lock;
}

/// A pipeline with its name; drivers give no reason for a failure.
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
    const std::string name = fullName(d);
    const std::unique_lock alone = lockCompiler(device);
    const vk::raii::ShaderModule vertex = makeModule(device, d.vertex, d.constants, name + ", vertex shader");
    const vk::raii::ShaderModule fragment = makeModule(device, d.fragment, d.constants, name + ", fragment shader");
    const vk::SpecializationInfo constants = d.constants.info();
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main", &constants),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main", &constants)};
    const vk::PipelineVertexInputStateCreateInfo input({}, toCount(d.streams.bindings), d.streams.bindings.data(),
                                                       toCount(d.streams.attributes), d.streams.attributes.data());
    const vk::PipelineInputAssemblyStateCreateInfo assembly(
        {}, d.strip ? vk::PrimitiveTopology::eTriangleStrip : vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.cullMode = vk::CullModeFlagBits::eNone;
    raster.lineWidth = 1.0f;
    const vk::PipelineMultisampleStateCreateInfo samples({}, static_cast<vk::SampleCountFlagBits>(d.samples));
    const vk::PipelineDepthStencilStateCreateInfo depth({}, d.depth != DepthUse::none, d.depth == DepthUse::write,
                                                        vk::CompareOp::eLessOrEqual);
    std::vector<vk::PipelineColorBlendAttachmentState> blends;
    for (std::uint32_t i = 0; i < d.colorCount; ++i) blends.push_back(blendState(d.blend, i < d.colorsWritten));
    if (d.rendering.any()) {  // formats of the whole render pass, not of the subpass alone
        blends.clear();
        for (std::uint32_t i = 0; i < d.rendering.colorCount; ++i)
            blends.push_back(blendState(d.blend, d.rendering.locations[i] < d.colorsWritten));
    }
    vk::PipelineColorBlendStateCreateFlags blendFlags;
    if (d.ordered && device.caps().plan.rasterOrder == graph::RasterOrder::promised)
        blendFlags = vk::PipelineColorBlendStateCreateFlagBits::eRasterizationOrderAttachmentAccessEXT;
    const vk::PipelineColorBlendStateCreateInfo blend(blendFlags, false, vk::LogicOp::eCopy, blends);
    constexpr vk::DynamicState kDynamic[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, kDynamic);
    const vk::raii::PipelineCache* cache =
        device.caps().has(graph::Quirk::cacheMixesRenderPasses) ? nullptr : device.pipelineCache();
    const RenderingChain rendering(d.rendering);
    vk::GraphicsPipelineCreateInfo info({}, stages, &input, &assembly, nullptr, &viewport, &raster, &samples, &depth,
                                        &blend, &dynamic, d.layout, d.renderPass, d.subpass);
    info.pNext = rendering.first();
    return named(device, name,
                 [&] { return vk::raii::Pipeline(*device, vk::Optional<const vk::raii::PipelineCache>(cache), info); });
}

vk::raii::Pipeline makePipeline(const Device& device, const ComputePipeline& d) {
    const std::string name(d.name);
    const std::unique_lock alone = lockCompiler(device);
    const vk::raii::ShaderModule module = makeModule(device, d.code, d.constants, name + ", shader");
    const vk::SpecializationInfo info = d.constants.info();
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main", &info);
    return named(device, name, [&] {
        return vk::raii::Pipeline(*device, vk::Optional<const vk::raii::PipelineCache>(device.pipelineCache()),
                                  vk::ComputePipelineCreateInfo({}, stage, d.layout));
    });
}

Layout makeLayout(const Device& device, const LayoutDescription& d) {
    const std::string name(d.name);
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < d.bindings.size(); ++i) {
        constexpr vk::ShaderStageFlags kVertex = vk::ShaderStageFlagBits::eVertex;
        const bool ofVertices = i + d.ofVertices >= d.bindings.size();
        const bool ofAll = d.bindings[i] == vk::DescriptorType::eUniformBuffer || (ofVertices && d.shared);
        bindings.emplace_back(i, d.bindings[i], 1, ofAll ? d.stages : ofVertices ? kVertex : d.stages & ~kVertex);
    }
    Layout layout;
    layout.set = vk::raii::DescriptorSetLayout(*device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    device.name(*layout.set, name + ", set 0");
    std::vector<vk::PushConstantRange> ranges;
    if (d.pushConstantBytes > 0) ranges.emplace_back(d.stages, 0, d.pushConstantBytes);
    std::vector<vk::DescriptorSetLayout> sets{*layout.set};
    if (d.counter) {
        constexpr auto kCounting = vk::ShaderStageFlagBits::eFragment | vk::ShaderStageFlagBits::eCompute;
        const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eStorageBuffer, 1, d.stages & kCounting);
        layout.counterSet = vk::raii::DescriptorSetLayout(*device, vk::DescriptorSetLayoutCreateInfo({}, binding));
        device.name(*layout.counterSet, name + ", set 1");
        sets.push_back(*layout.counterSet);
    }
    layout.pipeline = vk::raii::PipelineLayout(*device, vk::PipelineLayoutCreateInfo({}, sets, ranges));
    device.name(*layout.pipeline, name);
    return layout;
}

namespace {

template <typename T>
bool sameTable(std::span<const T> a, std::span<const T> b) {
    return a.data() == b.data() && a.size() == b.size();
}

}  // namespace

bool samePipeline(const GraphicsPipeline& a, const GraphicsPipeline& b) {
    return sameTable(a.vertex, b.vertex) && sameTable(a.fragment, b.fragment) && a.constants == b.constants &&
           sameTable(a.streams.bindings, b.streams.bindings) && sameTable(a.streams.attributes, b.streams.attributes) &&
           a.layout == b.layout && a.renderPass == b.renderPass && a.subpass == b.subpass &&
           a.rendering == b.rendering && a.colorCount == b.colorCount && a.samples == b.samples &&
           a.colorsWritten == b.colorsWritten && a.depth == b.depth && a.blend == b.blend && a.ordered == b.ordered &&
           a.strip == b.strip;
}

bool samePipeline(const ComputePipeline& a, const ComputePipeline& b) {
    return sameTable(a.code, b.code) && a.constants == b.constants && a.layout == b.layout;
}

namespace {

bool same(const LayoutDescription& a, const LayoutDescription& b) {
    return std::ranges::equal(a.bindings, b.bindings) && a.stages == b.stages &&
           a.pushConstantBytes == b.pushConstantBytes && a.counter == b.counter && a.ofVertices == b.ofVertices &&
           a.shared == b.shared;
}

}  // namespace

Pipelines::Pipelines(const Device& device) : device_(device) {}
Pipelines::~Pipelines() = default;

void Pipelines::makeAhead() {
    if (!worker_) worker_ = std::make_unique<PipelineWorker>(device_);
}

void Pipelines::endAhead() { worker_.reset(); }

bool Pipelines::busyAhead() const { return worker_ && worker_->busy(); }

void Pipelines::want(const GraphicsPipeline& description) {
    if (worker_ &&
        std::ranges::none_of(graphics_, [&](const auto& m) { return samePipeline(m.description, description); }))
        worker_->want(description);
}

void Pipelines::want(const ComputePipeline& description) {
    if (worker_ &&
        std::ranges::none_of(compute_, [&](const auto& m) { return samePipeline(m.description, description); }))
        worker_->want(description);
}

vk::Pipeline Pipelines::graphics(const GraphicsPipeline& description) {
    for (const auto& made : graphics_)
        if (samePipeline(made.description, description)) return *made.pipeline;
    std::optional<vk::raii::Pipeline> made = worker_ ? worker_->take(description) : std::nullopt;
    if (!made) made = makePipeline(device_, description);
    GraphicsPipeline kept = description;
    kept.name = kept.detail = {};
    graphics_.push_back({kept, std::move(*made)});
    return *graphics_.back().pipeline;
}

vk::Pipeline Pipelines::compute(const ComputePipeline& description) {
    for (const auto& made : compute_)
        if (samePipeline(made.description, description)) return *made.pipeline;
    std::optional<vk::raii::Pipeline> made = worker_ ? worker_->take(description) : std::nullopt;
    if (!made) made = makePipeline(device_, description);
    ComputePipeline kept = description;
    kept.name = {};
    compute_.push_back({kept, std::move(*made)});
    return *compute_.back().pipeline;
}

const Layout& Pipelines::layout(const LayoutDescription& description) {
    for (const MadeLayout& made : layouts_)
        if (same(made.description, description)) return made.layout;
    return layouts_.emplace_back(MadeLayout{description, makeLayout(device_, description)}).layout;
}

vk::Sampler Pipelines::sampler(vk::Filter filter) {
    if (const auto it = samplers_.find(filter); it != samplers_.end()) return *it->second;
    const char* name = filter == vk::Filter::eLinear ? "linear" : "nearest";
    return *samplers_.emplace(filter, makeSampler(device_, filter, name)).first->second;
}

DescriptorPool::DescriptorPool(const Device& device) : device_(device) {
    constexpr std::uint32_t kSets = 256;
    const std::array sizes{vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, 2 * kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eInputAttachment, kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eUniformBuffer, kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eUniformTexelBuffer, 4 * kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, kSets),
                           vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, 8 * kSets)};
    pool_ = vk::raii::DescriptorPool(*device, vk::DescriptorPoolCreateInfo({}, kSets, sizes));
    device.name(*pool_, "descriptors");
}

vk::DescriptorSet DescriptorPool::allocate(const vk::raii::DescriptorSetLayout& layout, std::string_view name) {
    const vk::DescriptorSetAllocateInfo info(*pool_, *layout);
    vk::DescriptorSet set;
    if (const vk::Result result = (**device_).allocateDescriptorSets(&info, &set); result != vk::Result::eSuccess)
        throw vk::SystemError(vk::make_error_code(result), "vk::Device::allocateDescriptorSets");
    // Mesa 22.3 leaks a set's name when the pool is reset, which happens every frame.
    if (device_.watched()) device_.name(set, name);
    return set;
}

void DescriptorPool::reset() { pool_.reset(); }

}  // namespace nacre::gpu
