#include "engine/passes/read_back.h"

namespace nacre::passes {
namespace {

vk::BufferImageCopy whole(const graph::ImageDesc& desc) {
    return {
        0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, desc.layers}, {}, {desc.extent.width, desc.extent.height, 1}};
}

}  // namespace

void readBack(graph::Graph& g, graph::Image image, const graph::ImageDesc& desc, graph::Buffer buffer) {
    g.transfer("read back").copiesFrom(image).copiesTo(buffer).record([=](graph::PassContext& c) {
        c.commands.copyImageToBuffer(c.image(image), vk::ImageLayout::eTransferSrcOptimal, c.buffer(buffer),
                                     whole(desc));
    });
    g.output(buffer);
}

gpu::Image makeTexture(const gpu::Device& device, graph::Executor& executor, const graph::ImageDesc& desc,
                       std::span<const std::byte> texels, const std::string& name) {
    gpu::Image image = gpu::makeImage(
        device, desc, vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, false, name);
    const gpu::Buffer bytes = gpu::makeBuffer(device, texels, vk::BufferUsageFlagBits::eTransferSrc, name + " texels");
    graph::Graph g(name);
    const auto target = g.importImage(name, desc, kTextureState, true);
    const auto source = g.importBuffer(name + " texels", bytes.size);
    g.transfer("upload").copiesFrom(source).copiesTo(target).record([=](graph::PassContext& c) {
        c.commands.copyBufferToImage(c.buffer(source), c.image(target), vk::ImageLayout::eTransferDstOptimal,
                                     whole(desc));
    });
    graph::Imports imports;
    imports.bind(target, image);
    imports.bind(source, bytes);
    const graph::Plan plan = graph::compile(g, device.caps().plan);
    device.submitAndWait([&](const vk::raii::CommandBuffer& c) { executor.record(c, g, plan, imports); });
    return image;
}

gpu::Image makeWhiteTexture(const gpu::Device& device, graph::Executor& executor) {
    constexpr std::array<std::byte, 1> kWhite{std::byte{255}};
    return makeTexture(device, executor, {VK_FORMAT_R8_UNORM, {1, 1}}, kWhite, "white");
}

}  // namespace nacre::passes
