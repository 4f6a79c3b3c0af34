#include "engine/passes/primitives.h"

#include "engine/passes/plates.h"

namespace nacre::passes {
namespace {

using Type = vk::DescriptorType;
constexpr vk::ShaderStageFlags kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kGraphics = vk::PipelineBindPoint::eGraphics;

constexpr auto kInstance = vk::VertexInputRate::eInstance;
constexpr auto kVec4 = vk::Format::eR32G32B32A32Sfloat;
constexpr vk::VertexInputBindingDescription kSphereBindings[] = {{0, sizeof(Sphere), kInstance},
                                                                 {1, sizeof(SphereLook), kInstance}};
constexpr vk::VertexInputAttributeDescription kSphereAttributes[] = {{0, 0, kVec4, 0},
                                                                     {1, 1, vk::Format::eR32G32Uint, 0}};
constexpr vk::VertexInputBindingDescription kCylinderBindings[] = {{0, sizeof(Cylinder), kInstance},
                                                                   {1, sizeof(CylinderLook), kInstance}};
constexpr vk::VertexInputAttributeDescription kCylinderAttributes[] = {
    {0, 0, kVec4, 0}, {1, 0, kVec4, 16}, {2, 1, vk::Format::eR32G32B32A32Uint, 0}};

/// Streams A and B, or A alone.
gpu::VertexStreams streamsOf(bool sphere, bool looks) {
    if (sphere)
        return {std::span(kSphereBindings).first(looks ? 2 : 1), std::span(kSphereAttributes).first(looks ? 2 : 1)};
    return {std::span(kCylinderBindings).first(looks ? 2 : 1), std::span(kCylinderAttributes).first(looks ? 3 : 2)};
}

/// Set 0 of a pass that reads: the atlas, and what holds the nearest depth.
std::span<const Type> bindingsOf(const Reads* reads) {
    static constexpr Type kAtlas[] = {Type::eCombinedImageSampler};
    static constexpr Type kInput[] = {Type::eCombinedImageSampler, Type::eInputAttachment};
    static constexpr Type kTexture[] = {Type::eCombinedImageSampler, Type::eCombinedImageSampler};
    if (!reads) return {};
    switch (reads->from) {
        case NearestFrom::depthBuffer:
            return kAtlas;
        case NearestFrom::texture:
            return kTexture;
        case NearestFrom::inputAttachment:
        case NearestFrom::ownAttachment:
            break;
    }
    return kInput;
}

const gpu::Layout& layoutOf(gpu::PassContext& context, const SceneView& view, const PrimitivePass& pass) {
    return context.pipelines.layout({pass.reads ? "shading layout" : "geometry layout", bindingsOf(pass.reads), kStages,
                                     sizeof(layout::ViewConstants), view.fragments != nullptr});
}

vk::Pipeline pipelineOf(gpu::PassContext& context, const SceneView& view, const PrimitivePass& pass, bool sphere) {
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = sphere ? "spheres" : "cylinders";
    d.vertex = pass.shaders.vertex;
    d.fragment = pass.shaders.fragment.of(view);
    d.constants.set(layout::kPerspectiveId, view.perspective);
    d.constants.set(layout::kQuarterTurnsId, view.quarterTurns);
    d.constants.set(layout::kDepthChannelsId, pass.encoding.channels);
    d.constants.set(layout::kDepthStepsId, pass.encoding.steps);
    d.constants.set(layout::kCornersId, pass.corners);
    if (pass.rim > 0) d.constants.set(layout::kRimId, pass.rim);
    d.streams = streamsOf(sphere, pass.looks);
    d.layout = *layoutOf(context, view, pass).pipeline;
    d.colorsWritten = pass.colorsWritten;
    d.depth = pass.depth;
    d.blend = pass.blend;
    d.ordered = pass.reads && pass.reads->from == NearestFrom::ownAttachment;
    d.strip = pass.corners != kPyramidCorners;
    return context.pipelines.graphics(d);
}

void bindReads(gpu::PassContext& context, const gpu::Layout& layout, const Reads& reads) {
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const bool texture = reads.from == NearestFrom::texture;
    const vk::DescriptorImageInfo atlas(context.pipelines.sampler(vk::Filter::eLinear), reads.atlas, kRead);
    const vk::DescriptorImageInfo nearest(texture ? context.pipelines.sampler(vk::Filter::eNearest) : vk::Sampler(),
                                          reads.nearest,
                                          reads.from == NearestFrom::ownAttachment ? vk::ImageLayout::eGeneral : kRead);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, Type::eCombinedImageSampler, atlas},
        {set, 1, 0, texture ? Type::eCombinedImageSampler : Type::eInputAttachment, nearest}};
    context.device->updateDescriptorSets(
        vk::ArrayProxy<const vk::WriteDescriptorSet>(reads.from == NearestFrom::depthBuffer ? 1 : 2, writes), {});
    context.commands.bindDescriptorSets(kGraphics, *layout.pipeline, 0, set, {});
}

/// One call for every copy, which differ by their push constants alone.
void drawCopies(gpu::PassContext& context, const SceneView& view, vk::PipelineLayout layout,
                const std::vector<PlacedCopies::Call>& calls, std::uint32_t corners) {
    layout::ViewConstants constants = view.constants;
    for (const PlacedCopies::Call& call : calls) {
        const glm::vec4* rows = &view.copies.rows[3 * std::size_t{call.copy}];
        constants.row0 = rows[0], constants.row1 = rows[1], constants.row2 = rows[2];
        constants.numberBefore = call.copy * constants.primitives;
        context.commands.pushConstants<layout::ViewConstants>(layout, kStages, 0, constants);
        context.commands.draw(corners, call.count, 0, call.first);
    }
}

void draw(gpu::PassContext& context, const SceneView& view, const PrimitivePass& pass, bool sphere) {
    const std::vector<PlacedCopies::Call>& calls = sphere ? view.copies.spheres : view.copies.cylinders;
    const SceneBuffers& scene = *view.buffers;
    if (calls.empty() || scene.empty()) return;
    const gpu::Layout& layout = layoutOf(context, view, pass);
    context.commands.bindPipeline(kGraphics, pipelineOf(context, view, pass, sphere));
    if (pass.reads) bindReads(context, layout, *pass.reads);
    bindCounter(context, view, layout);
    context.commands.bindVertexBuffers(0, {*scene.shapes.handle, *scene.looks.handle},
                                       {sphere ? 0 : scene.cylinderOffset, sphere ? 0 : scene.cylinderLookOffset});
    drawCopies(context, view, *layout.pipeline, calls, pass.corners);
}

/// Corners of the impostor polygons of spheres.
std::uint32_t cornersOf(const gpu::PassContext& context, const SceneView& view) {
    switch (chooseImpostor(view.impostor, context.device.caps().software, view.radiusPixels, view.perspective)) {
        case ImpostorShape::square:
            return 4;
        case ImpostorShape::octagon:
            return 8;
        default:
            return kPyramidCorners;
    }
}

}  // namespace

void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout) {
    if (!view.fragments) return;
    const vk::DescriptorSet set = context.descriptors.allocate(layout.counterSet, "fragment counter");
    const vk::DescriptorBufferInfo slot = view.fragments->slot(context.pass);
    context.device->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, Type::eStorageBuffer, {}, slot), {});
    context.commands.bindDescriptorSets(kGraphics, *layout.pipeline, 1, set, {});
}

void drawSpheres(gpu::PassContext& context, const SceneView& view, const PrimitivePass& pass) {
    draw(context, view, pass, true);
}

void drawImpostors(gpu::PassContext& context, const SceneView& view, PrimitivePass pass, const Shaders& spheres,
                   const Shaders& cylinders) {
    pass.shaders = spheres;
    pass.corners = cornersOf(context, view);
    draw(context, view, pass, true);
    pass.shaders = cylinders;
    pass.corners = 4;
    draw(context, view, pass, false);
}

}  // namespace nacre::passes
