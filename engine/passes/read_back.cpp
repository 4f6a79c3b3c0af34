#include "engine/passes/read_back.h"

#include <utility>

namespace nacre::passes {
namespace {

vk::BufferImageCopy whole(const graph::ImageDesc& desc) {
    return {0,  0,
            0,  {vk::ImageAspectFlagBits::eColor, 0, 0, desc.layers},
            {}, {desc.extent.width, desc.extent.height, desc.depth}};
}

}  // namespace

void readBack(graph::Graph& g, graph::Image image, const graph::ImageDesc& desc, graph::Buffer buffer) {
    g.transfer("read back").copiesFrom(image).copiesTo(buffer).record([=](gpu::PassContext& c) {
        c.commands.copyImageToBuffer(c.image(image), vk::ImageLayout::eTransferSrcOptimal, c.buffer(buffer),
                                     whole(desc));
    });
    g.output(buffer);
}

TextureUpload uploadTexture(const gpu::Device& device, const graph::ImageDesc& desc,
                            std::span<const std::uint8_t> bytes, const std::string& name, graph::Verb use) {
    const auto read =
        use == graph::Verb::density ? vk::ImageUsageFlagBits::eFragmentDensityMapEXT : vk::ImageUsageFlagBits::eSampled;
    TextureUpload upload{gpu::makeImage(device, desc, read | vk::ImageUsageFlagBits::eTransferDst, false, name),
                         gpu::makeBuffer(device, bytes, vk::BufferUsageFlagBits::eTransferSrc, name + " bytes"),
                         graph::Graph(name),
                         {}};
    graph::Graph& g = upload.graph;
    auto target = g.importImage(name, desc, graph::verbState(use, graph::PassKind::graphics), true);
    const auto source = g.importBuffer(name + " bytes", upload.bytes.size);
    g.transfer("upload").copiesFrom(source).copiesTo(target).record([=](gpu::PassContext& c) {
        c.commands.copyBufferToImage(c.buffer(source), c.image(target), vk::ImageLayout::eTransferDstOptimal,
                                     whole(desc));
    });
    upload.imports.bind(target, upload.image);
    upload.imports.bind(source, upload.bytes);
    return upload;
}

gpu::Image makeTexture(const gpu::Device& device, gpu::Executor& executor, const graph::ImageDesc& desc,
                       std::span<const std::uint8_t> bytes, const std::string& name, graph::Verb use) {
    TextureUpload upload = uploadTexture(device, desc, bytes, name, use);
    executor.run(upload.graph, upload.imports);
    return std::move(upload.image);
}

gpu::Image makeWhiteTexture(const gpu::Device& device, gpu::Executor& executor) {
    constexpr std::array<std::uint8_t, 4> kWhite{255, 255, 255, 255};
    return makeTexture(device, executor, {VK_FORMAT_R8_UNORM, {1, 1}}, kWhite, "white");
}

}  // namespace nacre::passes
