#include "tests/benchmark/batch_maps.h"

#include <array>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "engine/gpu/instance.h"

namespace nacre::test {
namespace {

namespace shaders {
#include "batchMapFragment.h"
#include "batchMapMultiviewVertex.h"
#include "batchMapVertex.h"
}  // namespace shaders

constexpr vk::Format kDepth = vk::Format::eD32Sfloat;
constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

struct Push {
    float pixels, scale, near, range;
    float corner[2];
    std::int32_t direction;
};

}  // namespace

BatchMaps::BatchMaps(const Representation& scene, std::span<const glm::dmat3> directions, std::uint32_t pixels)
    : radius_(scene.radius), pixels_(pixels), spheres_(static_cast<std::uint32_t>(scene.spheres.size())) {
    gpu::InstanceExtensions found;
    instance_ = gpu::makeInstance(context_, false, found);
    physical_ = gpu::pickDevice(instance_, "");
    vk::PhysicalDeviceMultiviewFeatures features;
    features.multiview = physical_.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceMultiviewFeatures>()
                             .get<vk::PhysicalDeviceMultiviewFeatures>()
                             .multiview;
    if (!features.multiview) throw std::runtime_error("this device has no multiview");
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue({}, 0, 1, &priority);  // software drivers have one family
    device_ = vk::raii::Device(physical_, vk::DeviceCreateInfo({}, queue, {}, {}, nullptr, &features));
    queue_ = device_.getQueue(0, 0);
    commands_ = vk::raii::CommandPool(device_, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, 0));

    shapes_ = buffer(scene.spheres.size() * sizeof(Sphere), vk::BufferUsageFlagBits::eVertexBuffer);
    std::memcpy(shapes_.mapped, scene.spheres.data(), scene.spheres.size() * sizeof(Sphere));
    std::array<glm::mat4, kMaps> rows;
    for (std::uint32_t i = 0; i < kMaps; ++i) rows[i] = glm::mat4(glm::mat3(glm::transpose(directions[i])));
    directions_ = buffer(sizeof(rows), vk::BufferUsageFlagBits::eUniformBuffer);
    std::memcpy(directions_.mapped, rows.data(), sizeof(rows));

    const vk::DescriptorSetLayoutBinding binding(0, vk::DescriptorType::eUniformBuffer, 1,
                                                 vk::ShaderStageFlagBits::eVertex);
    setLayout_ = vk::raii::DescriptorSetLayout(device_, vk::DescriptorSetLayoutCreateInfo({}, binding));
    const vk::PushConstantRange push(kStages, 0, sizeof(Push));
    layout_ = vk::raii::PipelineLayout(device_, vk::PipelineLayoutCreateInfo({}, *setLayout_, push));
    const vk::DescriptorPoolSize size(vk::DescriptorType::eUniformBuffer, 1);
    pool_ = vk::raii::DescriptorPool(device_, vk::DescriptorPoolCreateInfo({}, 1, size));
    set_ = (*device_).allocateDescriptorSets({*pool_, *setLayout_}, *device_.getDispatcher())[0];
    const vk::DescriptorBufferInfo info(*directions_.handle, 0, VK_WHOLE_SIZE);
    device_.updateDescriptorSets(vk::WriteDescriptorSet(set_, 0, 0, vk::DescriptorType::eUniformBuffer, {}, info), {});
    single_ = renderPass(0);
    multi_ = renderPass((1u << kViews) - 1);
    plain_ = pipeline(false);
    multiview_ = pipeline(true);
    makeFramebuffers();
}

vk::raii::DeviceMemory BatchMaps::allocate(const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted) const {
    const auto memory = physical_.getMemoryProperties();
    for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type)
        if (needs.memoryTypeBits & (1u << type) && (memory.memoryTypes[type].propertyFlags & wanted) == wanted)
            return {device_, vk::MemoryAllocateInfo(needs.size, type)};
    throw std::runtime_error("no such memory");
}

BatchMaps::Buffer BatchMaps::buffer(vk::DeviceSize bytes, vk::BufferUsageFlags usage) const {
    Buffer b;
    b.handle = vk::raii::Buffer(device_, vk::BufferCreateInfo({}, bytes, usage));
    b.memory = allocate(b.handle.getMemoryRequirements(),
                        vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
    b.handle.bindMemory(*b.memory, 0);
    b.mapped = b.memory.mapMemory(0, VK_WHOLE_SIZE);
    return b;
}

BatchMaps::Image BatchMaps::image(std::uint32_t width, std::uint32_t height, std::uint32_t layers,
                                  std::uint32_t layersPerView) const {
    Image made;
    made.handle = vk::raii::Image(
        device_, vk::ImageCreateInfo({}, vk::ImageType::e2D, kDepth, {width, height, 1}, 1, layers,
                                     vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                                     vk::ImageUsageFlagBits::eDepthStencilAttachment |
                                         vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eSampled));
    made.memory = allocate(made.handle.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
    made.handle.bindMemory(*made.memory, 0);
    for (std::uint32_t first = 0; first < layers; first += layersPerView)
        made.views.emplace_back(device_,
                                vk::ImageViewCreateInfo({}, *made.handle, vk::ImageViewType::e2DArray, kDepth, {},
                                                        {vk::ImageAspectFlagBits::eDepth, 0, 1, first, layersPerView}));
    return made;
}

/// Clears, draws, stores; left for copies to read. @param viewMask  0: no multiview
vk::raii::RenderPass BatchMaps::renderPass(std::uint32_t viewMask) const {
    const vk::AttachmentDescription depth({}, kDepth, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eClear,
                                          vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                          vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eUndefined,
                                          vk::ImageLayout::eTransferSrcOptimal);
    const vk::AttachmentReference use(0, vk::ImageLayout::eDepthStencilAttachmentOptimal);
    vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics);
    subpass.pDepthStencilAttachment = &use;
    const vk::SubpassDependency after(
        0, VK_SUBPASS_EXTERNAL, vk::PipelineStageFlagBits::eLateFragmentTests, vk::PipelineStageFlagBits::eTransfer,
        vk::AccessFlagBits::eDepthStencilAttachmentWrite, vk::AccessFlagBits::eTransferRead);
    vk::RenderPassMultiviewCreateInfo multiview;
    multiview.setViewMasks(viewMask);
    vk::RenderPassCreateInfo info({}, depth, subpass, after);
    if (viewMask) info.pNext = &multiview;
    return {device_, info};
}

vk::raii::Pipeline BatchMaps::pipeline(bool multiview) const {
    const std::span<const std::uint32_t> vertexCode =
        multiview ? std::span<const std::uint32_t>(shaders::batchMapMultiviewVertex) : shaders::batchMapVertex;
    const vk::raii::ShaderModule vertex(device_,
                                        vk::ShaderModuleCreateInfo({}, vertexCode.size_bytes(), vertexCode.data()));
    const vk::raii::ShaderModule fragment(
        device_, vk::ShaderModuleCreateInfo({}, sizeof(shaders::batchMapFragment), shaders::batchMapFragment));
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};
    const vk::VertexInputBindingDescription binding(0, sizeof(Sphere), vk::VertexInputRate::eInstance);
    const vk::VertexInputAttributeDescription attribute(0, 0, vk::Format::eR32G32B32A32Sfloat, 0);
    const vk::PipelineVertexInputStateCreateInfo input({}, binding, attribute);
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleStrip);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo raster;
    raster.lineWidth = 1;
    const vk::PipelineMultisampleStateCreateInfo samples;
    const vk::PipelineDepthStencilStateCreateInfo depth({}, true, true, vk::CompareOp::eLess);
    const vk::PipelineColorBlendStateCreateInfo blend;
    constexpr std::array kDynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, kDynamic);
    return {device_, nullptr,
            vk::GraphicsPipelineCreateInfo({}, stages, &input, &assembly, nullptr, &viewport, &raster, &samples, &depth,
                                           &blend, &dynamic, *layout_, multiview ? *multi_ : *single_)};
}

void BatchMaps::makeFramebuffers() {
    const std::uint32_t wide = pixels_ * kAcross, high = pixels_ * (kMaps / kAcross);
    tiles_ = image(wide, high, 1, 1);
    layers_ = image(pixels_, pixels_, kMaps, 1);
    sixes_ = image(pixels_, pixels_, kMaps, kViews);
    const auto make = [&](vk::RenderPass pass, const vk::raii::ImageView& view, std::uint32_t w, std::uint32_t h) {
        framebuffers_.emplace_back(device_, vk::FramebufferCreateInfo({}, pass, *view, w, h, 1));
    };
    make(*single_, tiles_.views[0], wide, high);
    for (const auto& view : layers_.views) make(*single_, view, pixels_, pixels_);
    for (const auto& view : sixes_.views) make(*multi_, view, pixels_, pixels_);
}

void BatchMaps::recordDraw(const vk::raii::CommandBuffer& commands, std::uint32_t map, bool tiled) const {
    const std::uint32_t x = tiled ? map % kAcross * pixels_ : 0, y = tiled ? map / kAcross * pixels_ : 0;
    const auto side = static_cast<float>(pixels_), left = static_cast<float>(x), top = static_cast<float>(y);
    commands.setViewport(0, vk::Viewport(left, top, side, side, 0, 1));
    commands.setScissor(0, vk::Rect2D({static_cast<int>(x), static_cast<int>(y)}, {pixels_, pixels_}));
    const auto radius = static_cast<float>(radius_ + 1);
    const float scale = side / static_cast<float>(2 * radius_);
    const Push push{side, scale, radius, 2 * radius, {left, top}, static_cast<std::int32_t>(map)};
    commands.pushConstants<Push>(*layout_, kStages, 0, push);
    commands.draw(4, spheres_, 0, 0);
}

void BatchMaps::record(const vk::raii::CommandBuffer& commands, BatchWay way) const {
    const bool multiview = way == BatchWay::multiview, tiled = way == BatchWay::tiles;
    const vk::ClearValue clear(vk::ClearDepthStencilValue(1.0f, 0));
    const std::uint32_t perPass = tiled ? kMaps : multiview ? kViews : 1;
    const std::size_t firstFramebuffer = tiled ? 0 : multiview ? 1 + kMaps : 1;
    const vk::Extent2D extent =
        tiled ? vk::Extent2D(pixels_ * kAcross, pixels_ * (kMaps / kAcross)) : vk::Extent2D(pixels_, pixels_);
    for (std::uint32_t pass = 0; pass < kMaps / perPass; ++pass) {
        commands.beginRenderPass(vk::RenderPassBeginInfo(multiview ? *multi_ : *single_,
                                                         *framebuffers_[firstFramebuffer + pass], {{}, extent}, clear),
                                 vk::SubpassContents::eInline);
        // Here, since a render pass with views begins without any state.
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics, multiview ? *multiview_ : *plain_);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, set_, {});
        commands.bindVertexBuffers(0, *shapes_.handle, vk::DeviceSize{0});
        const std::uint32_t draws = multiview ? 1 : perPass;
        for (std::uint32_t i = 0; i < draws; ++i) recordDraw(commands, pass * perPass + i, tiled);
        commands.endRenderPass();
    }
}

template <typename Record>
void BatchMaps::submit(Record&& record) const {
    const vk::raii::CommandBuffers buffers(device_, {*commands_, vk::CommandBufferLevel::ePrimary, 1});
    buffers[0].begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(buffers[0]);
    buffers[0].end();
    queue_.submit(vk::SubmitInfo({}, {}, *buffers[0]));
    queue_.waitIdle();
}

void BatchMaps::draw(BatchWay way) const {
    submit([&](const vk::raii::CommandBuffer& commands) { record(commands, way); });
}

std::vector<float> BatchMaps::depths(BatchWay way) const {
    const std::size_t mapPixels = std::size_t{pixels_} * pixels_;
    std::vector<float> result(mapPixels * kMaps);
    const Buffer host = buffer(result.size() * sizeof(float), vk::BufferUsageFlagBits::eTransferDst);
    const bool tiled = way == BatchWay::tiles;
    const Image& image = tiled ? tiles_ : way == BatchWay::layers ? layers_ : sixes_;
    submit([&](const vk::raii::CommandBuffer& commands) {
        record(commands, way);
        std::vector<vk::BufferImageCopy> copies;
        for (std::uint32_t map = 0; map < kMaps; ++map) {
            const auto x = static_cast<std::int32_t>(map % kAcross * pixels_);
            const auto y = static_cast<std::int32_t>(map / kAcross * pixels_);
            copies.emplace_back(map * mapPixels * sizeof(float), 0, 0,
                                vk::ImageSubresourceLayers(vk::ImageAspectFlagBits::eDepth, 0, tiled ? 0 : map, 1),
                                tiled ? vk::Offset3D(x, y, 0) : vk::Offset3D(), vk::Extent3D(pixels_, pixels_, 1));
        }
        commands.copyImageToBuffer(*image.handle, vk::ImageLayout::eTransferSrcOptimal, *host.handle, copies);
        const vk::MemoryBarrier toHost(vk::AccessFlagBits::eTransferWrite, vk::AccessFlagBits::eHostRead);
        commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {}, toHost, {},
                                 {});
    });
    std::memcpy(result.data(), host.mapped, result.size() * sizeof(float));
    return result;
}

}  // namespace nacre::test
