#include "engine/passes/geometry.h"

#include "shaders.h"

namespace nacre::passes {
namespace {

using Words = std::span<const std::uint32_t>;
constexpr vk::ShaderStageFlags kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

bool shades(Writes writes) {
    return writes == Writes::color || writes == Writes::surface || writes == Writes::identity;
}

Words vertexCode(Primitive primitive, Writes writes) {
    if (writes == Writes::plates) return shaders::plateVertex;
    if (primitive == Primitive::sphere)
        return shades(writes) ? Words(shaders::lookSphereVertex) : Words(shaders::geometrySphereVertex);
    return shades(writes) ? Words(shaders::lookCylinderVertex) : Words(shaders::geometryCylinderVertex);
}

/// Fragment stages by what they write: sphere and cylinder; for shading, by where the nearest depth is.
Words fragmentCode(Primitive primitive, Writes writes, Nearest nearest, bool sampled) {
    const bool sphere = primitive == Primitive::sphere;
    const auto choose = [&](Words sphereInput, Words sphereSampled, Words sphereFragdepth, Words cylinderInput,
                            Words cylinderSampled, Words cylinderFragdepth) {
        if (nearest == Nearest::fragdepth) return sphere ? sphereFragdepth : cylinderFragdepth;
        if (sampled) return sphere ? sphereSampled : cylinderSampled;
        return sphere ? sphereInput : cylinderInput;
    };
    switch (writes) {
        case Writes::plates: return shaders::plateFragment;
        case Writes::encoded: return sphere ? Words(shaders::encodeSphere) : Words(shaders::encodeCylinder);
        case Writes::depth: return sphere ? Words(shaders::nearestSphere) : Words(shaders::nearestCylinder);
        case Writes::color:
            return choose(shaders::colorSphereInput, shaders::colorSphereSampled, shaders::colorSphereFragdepth,
                          shaders::colorCylinderInput, shaders::colorCylinderSampled, shaders::colorCylinderFragdepth);
        case Writes::surface:
            return choose(shaders::surfaceSphereInput, shaders::surfaceSphereSampled, shaders::surfaceSphereFragdepth,
                          shaders::surfaceCylinderInput, shaders::surfaceCylinderSampled,
                          shaders::surfaceCylinderFragdepth);
        case Writes::identity:
            return choose(shaders::identitySphereInput, shaders::identitySphereSampled,
                          shaders::identitySphereFragdepth, shaders::identityCylinderInput,
                          shaders::identityCylinderSampled, shaders::identityCylinderFragdepth);
    }
    return {};
}

const char* nameOf(Writes writes) {
    switch (writes) {
        case Writes::plates: return "opaque prepass";
        case Writes::encoded: return "depth encoding";
        case Writes::depth: return "nearest depth";
        case Writes::color: return "impostor colour";
        case Writes::surface: return "surface layer";
        case Writes::identity: return "identity layer";
    }
    return "";
}

void describeStreams(gpu::GraphicsPipeline& d, Primitive primitive, bool looks) {
    constexpr auto kInstance = vk::VertexInputRate::eInstance;
    constexpr auto kVec4 = vk::Format::eR32G32B32A32Sfloat;
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

}  // namespace

Geometry::Geometry(const gpu::Device& device, const gpu::EncodedFormat& encoded)
    : device_(device), encoded_(encoded), linear_(gpu::makeSampler(device, vk::Filter::eLinear, "linear")),
      nearest_(gpu::makeSampler(device, vk::Filter::eNearest, "nearest")) {
    using Type = vk::DescriptorType;
    constexpr Type kAtlas[] = {Type::eCombinedImageSampler};
    constexpr Type kInput[] = {Type::eCombinedImageSampler, Type::eInputAttachment};
    constexpr Type kSampled[] = {Type::eCombinedImageSampler, Type::eCombinedImageSampler};
    constexpr auto kPush = static_cast<std::uint32_t>(sizeof(layout::ViewConstants));
    plain_ = gpu::makeLayout(device, {}, kStages, kPush, "geometry layout");
    atlasOnly_ = gpu::makeLayout(device, kAtlas, kStages, kPush, "shading layout");
    inputs_ = gpu::makeLayout(device, kInput, kStages, kPush, "shading layout, input attachment");
    sampled_ = gpu::makeLayout(device, kSampled, kStages, kPush, "shading layout, sampled depth");
}

const gpu::Layout& Geometry::layoutOf(Writes writes, Nearest nearest, bool sampled) const {
    if (!shades(writes)) return plain_;
    if (nearest == Nearest::fragdepth) return atlasOnly_;
    return sampled ? sampled_ : inputs_;
}

vk::Pipeline Geometry::pipeline(graph::PassContext& context, Primitive primitive, Writes writes, Nearest nearest,
                                bool perspective) {
    const bool sampled = context.inputIsSampled;
    const Key key{primitive, writes, nearest, sampled, perspective, context.renderPass, context.subpass};
    if (const auto it = pipelines_.find(key); it != pipelines_.end()) return *it->second;
    const bool sphere = primitive == Primitive::sphere;
    gpu::GraphicsPipeline d;
    d.name = std::string(nameOf(writes)) + (sphere ? ", spheres" : ", cylinders");
    d.vertex = vertexCode(primitive, writes);
    d.fragment = fragmentCode(primitive, writes, nearest, sampled);
    d.constants.set(0, perspective);
    d.constants.set(1, encoded_.channels);
    d.constants.set(2, encoded_.steps);
    d.constants.set(3, writes == Writes::plates ? 8 : device_.caps().impostorCorners);
    describeStreams(d, primitive, shades(writes));
    d.layout = *layoutOf(writes, nearest, sampled).pipeline;
    d.renderPass = context.renderPass;
    d.subpass = context.subpass;
    d.colorCount = context.colorCount;
    d.colorsWritten = writes == Writes::plates || writes == Writes::depth ? 0 : 1;
    const bool writesDepth = writes == Writes::plates || writes == Writes::depth ||
                             (shades(writes) && nearest == Nearest::fragdepth);
    d.depth = writesDepth ? gpu::DepthUse::write : gpu::DepthUse::test;
    d.blend = writes == Writes::encoded ? gpu::Blend::minimum : gpu::Blend::replace;
    return *pipelines_.emplace(key, gpu::makePipeline(device_, d)).first->second;
}

vk::DescriptorSet Geometry::textureSet(graph::PassContext& context, vk::ImageView atlas, Nearest nearest,
                                       vk::ImageView encodedDepth) {
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    const vk::DescriptorSet set =
        context.descriptors.allocate(layoutOf(Writes::color, nearest, context.inputIsSampled).set);
    const vk::DescriptorImageInfo atlasInfo(*linear_, atlas, kRead);
    const vk::DescriptorImageInfo depthInfo(context.inputIsSampled ? *nearest_ : vk::Sampler(), encodedDepth, kRead);
    std::vector<vk::WriteDescriptorSet> writes;
    writes.emplace_back(set, 0, 0, vk::DescriptorType::eCombinedImageSampler, atlasInfo);
    if (nearest == Nearest::encoded)
        writes.emplace_back(set, 1, 0,
                            context.inputIsSampled ? vk::DescriptorType::eCombinedImageSampler
                                                   : vk::DescriptorType::eInputAttachment,
                            depthInfo);
    device_->updateDescriptorSets(writes, {});
    return set;
}

void Geometry::draw(graph::PassContext& context, const SceneBuffers& scene, Writes writes, Nearest nearest,
                    bool perspective, const layout::ViewConstants& view, vk::DescriptorSet textures) {
    const vk::raii::CommandBuffer& commands = context.commands;
    const vk::PipelineLayout layout = *layoutOf(writes, nearest, context.inputIsSampled).pipeline;
    const auto one = [&](Primitive primitive, std::uint32_t count, std::uint32_t corners, vk::DeviceSize offset,
                         const gpu::Buffer& looks) {
        if (count == 0) return;
        commands.bindPipeline(vk::PipelineBindPoint::eGraphics,
                              pipeline(context, primitive, writes, nearest, perspective));
        commands.pushConstants<layout::ViewConstants>(layout, kStages, 0, view);
        if (textures) commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, layout, 0, textures, {});
        commands.bindVertexBuffers(0, {*scene.shapes.handle, *looks.handle}, {offset, 0});
        commands.draw(corners, count, 0, 0);
    };
    const bool plates = writes == Writes::plates;
    const auto corners = static_cast<std::uint32_t>(plates ? 8 : device_.caps().impostorCorners);
    one(Primitive::sphere, scene.sphereCount, corners, 0, scene.sphereLooks);
    if (!plates) one(Primitive::cylinder, scene.cylinderCount, 4, scene.cylinderOffset, scene.cylinderLooks);
}

}  // namespace nacre::passes
