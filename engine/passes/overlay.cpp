#include "engine/passes/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/error.h"
#include "engine/passes/bindings.h"
#include "engine/passes/full_screen.h"
#include "engine/passes/read_back.h"
#include "shaders.h"
#include "shaders/common/layout.h"

namespace nacre::passes {
namespace {

constexpr Type kGlyphs[] = {kSampled};
constexpr vk::VertexInputBindingDescription kStreams[] = {{0, sizeof(OverlayVertex), vk::VertexInputRate::eVertex}};
constexpr vk::VertexInputAttributeDescription kAttributes[] = {
    {0, 0, vk::Format::eR32G32Sfloat, 0}, {1, 0, vk::Format::eR32G32Sfloat, 8}, {2, 0, vk::Format::eR8G8B8A8Unorm, 16}};

/// Copies after making room; buffers grow by half, so that this is rare.
template <typename T>
void put(const gpu::Device& device, gpu::Buffer& buffer, const std::vector<T>& contents, vk::BufferUsageFlags usage,
         const char* name) {
    const std::size_t bytes = contents.size() * sizeof(T);
    if (!buffer.mapped || buffer.size < bytes)
        buffer = gpu::makeBuffer(device, bytes + bytes / 2, usage, gpu::Access::upload, name);
    std::copy_n(contents.data(), contents.size(), reinterpret_cast<T*>(buffer.mapped));
}

/// A batch's rectangle in the image, which may be the picture turned; empty if it lies outside.
vk::Rect2D makeScissor(const OverlayBatch& b, graph::Extent upright, int quarterTurns) {
    const auto pixel = [](float value, std::uint32_t most) {
        return static_cast<std::int32_t>(std::clamp(value, 0.0f, static_cast<float>(most)));
    };
    const auto w = static_cast<std::int32_t>(upright.width), h = static_cast<std::int32_t>(upright.height);
    const std::int32_t left = pixel(b.left, upright.width), right = pixel(std::ceil(b.right), upright.width);
    const std::int32_t top = pixel(b.top, upright.height), bottom = pixel(std::ceil(b.bottom), upright.height);
    if (right <= left || bottom <= top) return {};
    const auto size = [](std::int32_t x, std::int32_t y) {
        return vk::Extent2D(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    };
    switch (quarterTurns) {
        case 1:
            return {{h - bottom, left}, size(bottom - top, right - left)};
        case 2:
            return {{w - right, h - bottom}, size(right - left, bottom - top)};
        case 3:
            return {{top, w - right}, size(bottom - top, right - left)};
        default:
            return {{left, top}, size(right - left, bottom - top)};
    }
}

using Scale = std::array<float, 4>;

const gpu::Layout& overlayLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"overlay layout", kGlyphs, kDraw, sizeof(Scale)});
}

gpu::GraphicsPipeline overlayPipeline(gpu::PipelineContext& context, int quarterTurns, bool coded, OverlayEye eye) {
    constexpr std::array kBlends{gpu::Blend::over, gpu::Blend::overRed, gpu::Blend::overCyan};  // by OverlayEye
    gpu::GraphicsPipeline d = context.pipeline();
    d.vertex = shaders::overlayVertex;
    d.fragment = shaders::overlayFragment;
    d.constants.set(layout::kQuarterTurnsId, quarterTurns);
    d.constants.set(layout::kCodedId, coded);
    d.streams = {kStreams, kAttributes};
    d.layout = *overlayLayout(context).pipeline;
    d.colorsWritten = 1;
    d.blend = kBlends[static_cast<std::size_t>(eye)];
    d.strip = false;
    return d;
}

}  // namespace

OverlayPass::OverlayPass(const gpu::Device& device, gpu::Executor& executor)
    : device_(device), glyphs_(makeWhiteTexture(device, executor)) {}

void OverlayPass::setGlyphs(gpu::Executor& executor, const OverlayGlyphs& glyphs) {
    if (std::max(glyphs.width, glyphs.height) > device_.caps().maxImageSize)
        throw Error("cannot show text", device_.caps().deviceName, "its textures are too small for the glyphs");
    glyphs_ =
        makeTexture(device_, executor, {VK_FORMAT_R8_UNORM, {glyphs.width, glyphs.height}}, glyphs.coverage, "glyphs");
}

void OverlayPass::upload(gpu::FrameSlot& slot, const Overlay& overlay) const {
    put(device_, slot.vertices, overlay.vertices, vk::BufferUsageFlagBits::eVertexBuffer, "overlay vertices");
    put(device_, slot.indices, overlay.indices, vk::BufferUsageFlagBits::eIndexBuffer, "overlay indices");
}

void OverlayPass::want(gpu::PipelineContext& context, int quarterTurns, bool coded) {
    context.pipelines.want(overlayPipeline(context, quarterTurns, coded, OverlayEye::both));
}

void OverlayPass::draw(gpu::PassContext& context, const gpu::FrameSlot& slot, const Overlay& overlay,
                       graph::Extent upright, int quarterTurns, bool coded) const {
    const vk::raii::CommandBuffer& commands = context.commands;
    const Scale scale{2.0f / static_cast<float>(upright.width), 2.0f / static_cast<float>(upright.height), 0, 0};
    const gpu::Layout& layout = overlayLayout(context);
    std::optional<OverlayEye> bound;
    const vk::ImageView glyphs = *glyphs_.view;
    bindTextures(context, layout, vk::Filter::eLinear, {&glyphs, 1});
    commands.pushConstants<float>(*layout.pipeline, kDraw, 0, scale);
    commands.bindVertexBuffers(0, *slot.vertices.handle, {0});
    commands.bindIndexBuffer(*slot.indices.handle, 0, vk::IndexType::eUint32);
    for (const OverlayBatch& batch : overlay.batches) {
        const vk::Rect2D scissor = makeScissor(batch, upright, quarterTurns);
        if (scissor.extent.width == 0) continue;
        if (bound != batch.eye) {
            const gpu::GraphicsPipeline pipeline = overlayPipeline(context, quarterTurns, coded, batch.eye);
            commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(pipeline));
            bound = batch.eye;
        }
        commands.setScissor(0, scissor);
        commands.drawIndexed(batch.indexCount, 1, batch.firstIndex, 0, 0);
    }
}

}  // namespace nacre::passes
