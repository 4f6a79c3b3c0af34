#include "engine/passes/geometry.h"

namespace nacre::passes {
namespace {

constexpr vk::ShaderStageFlags kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr std::uint32_t kPyramidCorners = 24;  // a triangle list
constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;

void describeStreams(gpu::GraphicsPipeline& d, Primitive primitive, bool looks) {
    constexpr auto kInstance = vk::VertexInputRate::eInstance;
    constexpr auto kVec4 = vk::Format::eR32G32B32A32Sfloat;
    if (primitive == Primitive::screen) return;
    if (primitive == Primitive::sphere) {
        d.bindings = {{0, sizeof(Sphere), kInstance}};
        d.attributes = {{0, 0, kVec4, 0}};
        if (looks) {
            d.bindings.emplace_back(1, sizeof(SphereLook), kInstance);
            d.attributes.emplace_back(1, 1, vk::Format::eR32G32B32Uint, 0);
        }
        return;
    }
    d.bindings = {{0, sizeof(Cylinder), kInstance}};
    d.attributes = {{0, 0, kVec4, 0}, {1, 0, kVec4, 16}};
    if (looks) {
        d.bindings.emplace_back(1, sizeof(CylinderLook), kInstance);
        d.attributes.emplace_back(2, 1, vk::Format::eR32G32B32A32Uint, 0);
        d.attributes.emplace_back(3, 1, vk::Format::eR32Uint, 16);
    }
}

/// Whether a pass has a set of textures and attachments.
bool reads(const ShaderKey& key) { return shades(key.writes) || keepsDepth(key.writes, key.nearest); }

bool writesDepth(const ShaderKey& key) {
    if (shades(key.writes)) return key.nearest == Nearest::fragdepth || key.settle;
    return key.writes != Writes::encoded && key.writes != Writes::overdraw;
}

}  // namespace

Geometry::Geometry(const gpu::Device& device)
    : device_(device),
      linear_(gpu::makeSampler(device, vk::Filter::eLinear, "linear")),
      nearest_(gpu::makeSampler(device, vk::Filter::eNearest, "nearest")) {}

const gpu::Layout& Geometry::layoutOf(const ShaderKey& key) {
    using Type = vk::DescriptorType;
    const LayoutKey at{reads(key), key.nearest, key.sampled, key.counting};
    if (const auto it = layouts_.find(at); it != layouts_.end()) return it->second;
    std::vector<Type> bindings;
    if (reads(key)) {
        bindings.push_back(Type::eCombinedImageSampler);
        if (key.nearest != Nearest::fragdepth)
            bindings.push_back(key.sampled ? Type::eCombinedImageSampler : Type::eInputAttachment);
        if (key.nearest == Nearest::deferred) bindings.insert(bindings.end(), 3, Type::eStorageBuffer);
    }
    return layouts_
        .emplace(at, gpu::makeLayout(device_, bindings, kStages, sizeof(layout::ViewConstants),
                                     reads(key) ? "shading layout" : "geometry layout", key.counting))
        .first->second;
}

vk::Pipeline Geometry::pipeline(gpu::PassContext& context, const ShaderKey& key, const Draw& draw,
                                std::uint32_t corners, float rim) {
    const bool plates = key.writes == Writes::plates;
    const auto shape = static_cast<std::uint32_t>(plates ? rim * 1e6f : 0.0f) * 32 + corners;
    const PipelineKey at{key, draw.perspective, draw.quarterTurns, shape, context.renderPass, context.subpass};
    if (const auto it = pipelines_.find(at); it != pipelines_.end()) return *it->second;
    gpu::GraphicsPipeline d;
    d.name = std::string(nameOf(key.writes)) + (key.primitive == Primitive::sphere     ? ", spheres"
                                                : key.primitive == Primitive::cylinder ? ", cylinders"
                                                                                       : ", screen");
    d.vertex = vertexShader(key);
    d.fragment = fragmentShader(key);
    const graph::EncodedFormat& encoded = device_.caps().encoded;
    d.constants.set(layout::kPerspectiveId, draw.perspective);
    d.constants.set(layout::kQuarterTurnsId, draw.quarterTurns);
    const bool exact = key.nearest == Nearest::rasterOrder;  // needs no blending: R32F everywhere
    d.constants.set(layout::kDepthChannelsId, exact ? 1 : encoded.channels);
    d.constants.set(layout::kDepthStepsId, exact ? 0 : encoded.steps);
    d.constants.set(layout::kCornersId, corners);
    if (plates) d.constants.set(layout::kRimId, rim);
    d.strip = corners != kPyramidCorners;
    describeStreams(d, key.primitive, shades(key.writes));
    d.layout = *layoutOf(key).pipeline;
    d.renderPass = context.renderPass;
    d.subpass = context.subpass;
    d.colorCount = context.colorCount;
    d.ordered = keepsDepth(key.writes, key.nearest) && !key.sampled;
    d.colorsWritten = plates || key.writes == Writes::depth ? 0 : d.ordered && shades(key.writes) ? 2 : 1;
    d.depth = key.primitive == Primitive::screen ? gpu::DepthUse::none
              : writesDepth(key)                 ? gpu::DepthUse::write
                                                 : gpu::DepthUse::test;
    d.blend = key.writes == Writes::overdraw                ? gpu::Blend::add
              : key.writes == Writes::encoded && !d.ordered ? gpu::Blend::minimum
                                                            : gpu::Blend::replace;
    return *pipelines_.emplace(at, gpu::makePipeline(device_, d)).first->second;
}

void Geometry::bindSets(gpu::PassContext& context, const SceneBuffers& scene, const ShaderKey& key, const Draw& draw,
                        const ShadingInputs& inputs) {
    const gpu::Layout& layout = layoutOf(key);
    constexpr auto kGraphics = vk::PipelineBindPoint::eGraphics;
    if (reads(key)) {
        const vk::DescriptorSet set = context.descriptors.allocate(layout.set, nameOf(key.writes));
        const vk::DescriptorImageInfo atlas(*linear_, inputs.atlas, kRead);
        const bool ordered = keepsDepth(key.writes, key.nearest) && !key.sampled;
        const auto layoutHere = ordered ? vk::ImageLayout::eGeneral : kRead;
        const vk::DescriptorImageInfo nearest(key.sampled ? *nearest_ : vk::Sampler(), inputs.nearest, layoutHere);
        const vk::DescriptorBufferInfo buffers[] = {
            {*scene.shapes.handle, 0, VK_WHOLE_SIZE},
            {*scene.looks.handle, 0, VK_WHOLE_SIZE},
            {draw.copyRows ? *draw.copyRows->handle : vk::Buffer(), 0, VK_WHOLE_SIZE}};
        std::vector<vk::WriteDescriptorSet> writes;
        writes.emplace_back(set, 0, 0, vk::DescriptorType::eCombinedImageSampler, atlas);
        if (key.nearest != Nearest::fragdepth)
            writes.emplace_back(
                set, 1, 0,
                key.sampled ? vk::DescriptorType::eCombinedImageSampler : vk::DescriptorType::eInputAttachment,
                nearest);
        if (key.nearest == Nearest::deferred)
            for (std::uint32_t i = 0; i < 3; ++i)
                writes.emplace_back(set, 2 + i, 0, vk::DescriptorType::eStorageBuffer,
                                    vk::ArrayProxyNoTemporaries<const vk::DescriptorImageInfo>{}, buffers[i]);
        device_->updateDescriptorSets(writes, {});
        context.commands.bindDescriptorSets(kGraphics, *layout.pipeline, 0, set, {});
    }
    if (key.counting) {
        const vk::DescriptorSet set =
            context.descriptors.allocate(layout.counterSet, std::string(nameOf(key.writes)) + ", counter");
        const vk::DescriptorBufferInfo counter(*draw.counter->handle, draw.counterOffset, sizeof(std::uint32_t));
        device_->updateDescriptorSets(
            vk::WriteDescriptorSet(set, 0, 0, vk::DescriptorType::eStorageBuffer, {}, counter), {});
        context.commands.bindDescriptorSets(kGraphics, *layout.pipeline, 1, set, {});
    }
}

namespace {

/// One call for every copy, which differ by their push constants alone.
void drawCopies(const vk::raii::CommandBuffer& commands, vk::PipelineLayout layout, const Draw& draw,
                const std::vector<PlacedCopies::Call>& calls, std::uint32_t corners) {
    layout::ViewConstants view = draw.view;
    for (const PlacedCopies::Call& call : calls) {
        const glm::vec4* rows = &draw.copies->rows[3 * std::size_t{call.copy}];
        view.row0 = rows[0], view.row1 = rows[1], view.row2 = rows[2];
        view.numberBefore = call.copy * view.primitives;
        commands.pushConstants<layout::ViewConstants>(layout, kStages, 0, view);
        commands.draw(corners, call.count, 0, call.first);
    }
}

}  // namespace

void Geometry::drawPrimitives(gpu::PassContext& context, const SceneBuffers& scene, const Draw& draw,
                              const ShadingInputs& inputs, Primitive primitive, std::uint32_t corners, float rim) {
    const bool sphere = primitive == Primitive::sphere, screen = primitive == Primitive::screen;
    const std::vector<PlacedCopies::Call>& calls = sphere ? draw.copies->spheres : draw.copies->cylinders;
    if (!screen && calls.empty()) return;
    const ShaderKey key{primitive,
                        draw.writes,
                        draw.nearest,
                        shades(draw.writes) && (context.inputIsSampled || inputs.asTexture),
                        shades(draw.writes) && draw.nearest == Nearest::encoded && device_.caps().encoded.settles(),
                        draw.counter != nullptr};
    const vk::raii::CommandBuffer& commands = context.commands;
    const vk::PipelineLayout layout = *layoutOf(key).pipeline;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline(context, key, draw, corners, rim));
    bindSets(context, scene, key, draw, inputs);
    if (screen) {
        commands.pushConstants<layout::ViewConstants>(layout, kStages, 0, draw.view);
        commands.draw(corners, 1, 0, 0);
        return;
    }
    commands.bindVertexBuffers(0, {*scene.shapes.handle, *scene.looks.handle},
                               {sphere ? 0 : scene.cylinderOffset, sphere ? 0 : scene.cylinderLookOffset});
    drawCopies(commands, layout, draw, calls, corners);
}

void Geometry::draw(gpu::PassContext& context, const SceneBuffers& scene, const Draw& draw,
                    const ShadingInputs& inputs) {
    if (scene.empty()) return;
    const bool software = device_.caps().software;
    if (draw.writes == Writes::plates) {
        const PlateShape shape = choosePlates(draw.plates, software, draw.radiusPixels);
        for (const Plate& plate : platesOf(shape))
            drawPrimitives(context, scene, draw, inputs, Primitive::sphere, plate.corners, plate.rim);
        return;
    }
    if (shades(draw.writes) && draw.nearest == Nearest::deferred)
        return drawPrimitives(context, scene, draw, inputs, Primitive::screen, 3);
    const ImpostorShape shape = chooseImpostor(draw.impostor, software, draw.radiusPixels, draw.perspective);
    drawPrimitives(context, scene, draw, inputs, Primitive::sphere,
                   shape == ImpostorShape::square    ? 4
                   : shape == ImpostorShape::octagon ? 8
                                                     : kPyramidCorners);
    drawPrimitives(context, scene, draw, inputs, Primitive::cylinder, 4);
}

}  // namespace nacre::passes
