#include "engine/passes/covers.h"

#include <algorithm>

#include "engine/passes/bindings.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

constexpr vk::VertexInputBindingDescription kCoverStreams[] = {{0, sizeof(glm::vec4), vk::VertexInputRate::eInstance}};
constexpr vk::VertexInputAttributeDescription kCoverAttributes[] = {{0, 0, vk::Format::eR32G32B32A32Sfloat, 0}};

}  // namespace

std::vector<glm::vec4> makeCovers(const TileMask& mask, graph::Extent image) {
    std::vector<glm::vec4> covers;
    const glm::vec2 ndc = 2.0f * TileMask::kSide / glm::vec2(image.width, image.height);
    const auto down = static_cast<std::uint32_t>(mask.wanted.size() / mask.across);
    for (std::uint32_t y = 0; y < down; ++y)
        for (std::uint32_t x = 0, end = 0; x < mask.across; x = end + 1) {
            end = x;
            while (end < mask.across && !mask.wants(end, y)) ++end;
            if (x < end) covers.emplace_back(glm::vec2(x, y) * ndc - 1.0f, glm::vec2(end, y + 1) * ndc - 1.0f);
        }
    return covers;
}

void drawCovers(gpu::PassContext& context, const SceneView& view) {
    if (!view.covers) return;
    const gpu::Layout& layout = context.pipelines.layout({"covers", {}, kDraw, 0});
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = "covers";
    d.vertex = shaders::coverVertex;
    d.fragment = shaders::plateFragment;
    d.streams = {kCoverStreams, kCoverAttributes};
    d.layout = *layout.pipeline;
    d.depth = gpu::DepthUse::write;
    context.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, context.pipelines.graphics(d));
    context.commands.bindVertexBuffers(0, {*view.covers->handle}, {0});
    for (std::uint32_t first = 0; first < view.coverCount; first += kMostInstances)
        context.commands.draw(4, std::min(kMostInstances, view.coverCount - first), 0, first);
}

}  // namespace nacre::passes
