#include "engine/passes/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/gpu/two_view_shader.h"
#include "engine/passes/bindings.h"
#include "engine/passes/corners.h"
#include "engine/scene/color/colors.h"

namespace nacre::passes {
namespace {

constexpr auto kGraphics = vk::PipelineBindPoint::eGraphics;

constexpr auto kInstance = vk::VertexInputRate::eInstance, kVertex = vk::VertexInputRate::eVertex;
constexpr auto kVec4 = vk::Format::eR32G32B32A32Sfloat;
constexpr vk::VertexInputBindingDescription kSphereBindings[] = {{3, sizeof(EllipsoidRows), kInstance},
                                                                 {0, sizeof(Sphere), kInstance},
                                                                 {2, sizeof(glm::vec3), kVertex},
                                                                 {1, sizeof(SphereLook), kInstance}};
constexpr vk::VertexInputAttributeDescription kSphereAttributes[] = {
    {0, 0, kVec4, 0}, {3, 2, vk::Format::eR32G32B32Sfloat, 0}, {1, 1, vk::Format::eR32G32Uint, 0}};
/// Of impostors. Without ellipsoids their rows have an attribute that no shader uses.
constexpr vk::VertexInputAttributeDescription kImpostorAttributes[] = {
    {4, 0, kVec4, 0}, {5, 0, kVec4, 0}, kSphereAttributes[0], kSphereAttributes[1], kSphereAttributes[2]};
constexpr vk::VertexInputAttributeDescription kEllipsoidAttributes[] = {
    {4, 3, kVec4, 0}, {5, 3, kVec4, 16}, kSphereAttributes[0], kSphereAttributes[1], kSphereAttributes[2]};
constexpr vk::VertexInputBindingDescription kCylinderBindings[] = {{0, sizeof(Cylinder), kInstance},
                                                                   {1, sizeof(CylinderLook), kInstance}};
constexpr vk::VertexInputAttributeDescription kCylinderAttributes[] = {
    {0, 0, kVec4, 0}, {1, 0, kVec4, 16}, {2, 1, vk::Format::eR32G32B32A32Uint, 0}};

/// Streams A and B, or A alone. Triangles, and looks of fetched spheres, are fetched by number instead.
/// @param ellipsoids  there are some, drawn as impostors
gpu::VertexStreams chooseStreams(Primitive primitive, bool looks, bool plates, bool ellipsoids) {
    if (primitive == Primitive::triangle) return {};
    if (primitive == Primitive::sphere) {
        const std::size_t plain = looks ? 3 : 2;
        const auto bindings = std::span(kSphereBindings).subspan(ellipsoids ? 0 : 1);
        if (plates) return {bindings.first(plain), std::span(kSphereAttributes).first(plain)};
        if (!ellipsoids) return {bindings.first(plain), std::span(kImpostorAttributes).first(plain + 2)};
        return {bindings.first(plain + 1), std::span(kEllipsoidAttributes).first(plain + 2)};
    }
    return {std::span(kCylinderBindings).first(looks ? 2 : 1), std::span(kCylinderAttributes).first(looks ? 3 : 2)};
}

/// Set 0 of a pass that reads: the atlas, effect parameters, the shadow map, and the nearest depth.
std::span<const Type> listBindings(const std::optional<Reads>& reads) {
    static constexpr Type kAtlas[] = {kSampled, Type::eUniformBuffer, kSampled};
    static constexpr Type kInput[] = {kSampled, Type::eUniformBuffer, kSampled, Type::eInputAttachment};
    static constexpr Type kTexture[] = {kSampled, Type::eUniformBuffer, kSampled, kSampled};
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
/// As above, with the streams for the vertex stage of triangles. Binding numbers are independent of what is read.
std::span<const Type> listTriangleBindings(const std::optional<Reads>& reads) {
    static constexpr Type kAlone[] = {kStorage, kStorage};
    static constexpr Type kInput[] = {kSampled, Type::eUniformBuffer, kSampled, Type::eInputAttachment, kStorage,
                                      kStorage};
    static constexpr Type kTexture[] = {kSampled, Type::eUniformBuffer, kSampled, kSampled, kStorage, kStorage};
    if (!reads) return kAlone;
    const bool input = reads->from == NearestFrom::inputAttachment || reads->from == NearestFrom::ownAttachment;
    return input ? kInput : kTexture;
}

/// Primitives of one kind, drawn as one polygon each.
struct Draw {
    Primitive primitive;
    const Shaders& shaders;
    const Plate* plate;  ///< null: an impostor, or a triangle
    CornerRange corners;
    bool fetched = false;  ///< by FetchedShaders
};

bool bindsStreams(const GeometryPass& pass, const Draw& drawn) {
    return pass.streams || drawn.fetched || drawn.primitive == Primitive::triangle;
}

const gpu::Layout& passLayout(gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass,
                              const Draw& drawn) {
    const bool streams = bindsStreams(pass, drawn);
    return context.pipelines.layout({pass.reads ? "shading layout" : "geometry layout",
                                     streams ? listTriangleBindings(pass.reads) : listBindings(pass.reads), kDraw,
                                     sizeof(layout::ViewConstants), view.fragments != nullptr, streams ? 2u : 0u,
                                     pass.streams || drawn.fetched});
}

CornerRange impostorCorners(ImpostorShape shape) {
    return shape == ImpostorShape::square    ? kImpostorSquare
           : shape == ImpostorShape::octagon ? kImpostorOctagon
                                             : kPyramid;
}

const std::vector<PlacedCopies::Call>& primitiveCalls(const SceneView& view, Primitive primitive) {
    return primitive == Primitive::sphere     ? view.copies.spheres
           : primitive == Primitive::cylinder ? view.copies.cylinders
                                              : view.copies.triangles;
}

/// Spheres of a radius in the picture, as impostors.
Draw makeImpostors(const GeometryPass& pass, const graph::GeometryCaps& caps, const SceneView& view, double radius) {
    const bool fetched = !view.fragments && !pass.fetched.sphere.vertex.empty() && caps.storesVaryings;
    return {Primitive::sphere, fetched ? pass.fetched.sphere : pass.shaders.sphere, nullptr,
            impostorCorners(chooseImpostor(view.impostor, caps, radius, view.flat())), fetched};
}
Draw platesAs(const GeometryPass& pass, const Plate& plate) {
    return {Primitive::sphere, pass.shaders.sphere, &plate,
            plate.corners == kPlateSquare.count ? kPlateSquare : kPlateOctagon};
}

/// @param work  gets each Draw of a pass
template <typename Work>
void eachDraw(const gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass, const Work& work) {
    if (view.buffers->empty()) return;
    const graph::GeometryCaps& caps = context.device.caps().plan.geometry;
    const auto has = [&](Primitive primitive, const Shaders& shaders) {
        return !shaders.vertex.empty() && !primitiveCalls(view, primitive).empty();
    };
    const auto& [sphere, cylinder, triangle] = pass.shaders;
    if (has(Primitive::sphere, sphere)) {
        if (!pass.plates)
            work(makeImpostors(pass, caps, view, view.radiusPixels));
        else if (view.buffers->ellipsoidOffset == 0)  // ellipsoids do not fill their spheres
            for (const Plate& plate : listPlates(choosePlates(view.plates, caps, view.radiusPixels)))
                work(platesAs(pass, plate));
    }
    if (has(Primitive::cylinder, cylinder)) work({Primitive::cylinder, cylinder, nullptr, {0, 4}});
    const bool fetched = caps.storesVaryings && !view.fragments && !pass.fetched.triangle.vertex.empty();
    if (has(Primitive::triangle, triangle))
        work({Primitive::triangle, fetched ? pass.fetched.triangle : triangle, nullptr, {0, 3}, fetched});
}

const char* drawName(const Draw& drawn) {
    constexpr const char* kNames[] = {"spheres", "cylinders", "triangles"};
    constexpr const char* kFetchedNames[] = {"fetched spheres", "", "fetched triangles"};
    return (drawn.fetched ? kFetchedNames : kNames)[static_cast<std::size_t>(drawn.primitive)];
}

/// Pipelines for the other sphere shapes that a zoom uses (a bake uses none): they differ in the polygon.
std::vector<gpu::GraphicsPipeline> otherShapes(gpu::PipelineContext& context, const SceneView& view,
                                               const GeometryPass& pass, const Draw& drawn,
                                               const gpu::GraphicsPipeline& of) {
    const graph::GeometryCaps& caps = context.device.caps().plan.geometry;
    std::vector<gpu::GraphicsPipeline> others;
    if (drawn.primitive != Primitive::sphere || !view.wholeImage) return others;
    const auto add = [&](const Draw& other) {
        gpu::GraphicsPipeline d = of;
        d.constants.change(layout::kCornersId, other.corners.count);
        if (other.plate) d.constants.change(layout::kRimId, other.plate->rim);
        d.strip = other.corners.count != kPyramid.count;
        others.push_back(d);
    };
    for (const double radius : {0.0, caps.plateOctagons, caps.octagons, caps.domes}) {
        if (std::isinf(radius)) continue;  // never reached
        if (!drawn.plate)
            add(makeImpostors(pass, caps, view, radius));
        else
            for (const Plate& plate : listPlates(choosePlates(PlateShape::automatic, caps, radius)))
                add(platesAs(pass, plate));
    }
    return others;
}

gpu::GraphicsPipeline describePipeline(gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass,
                                       const Draw& drawn) {
    gpu::GraphicsPipeline d = context.pipeline();
    d.detail = drawName(drawn);
    d.vertex = gpu::forViews(drawn.shaders.vertex, context.views);
    d.fragment = gpu::forViews(drawn.shaders.fragment.of(view), context.views);
    setGeometryConstants(d.constants, view, pass.rim);
    d.constants.set(layout::kSnapId, context.device.caps().snapPixels);
    if (pass.rim > 0) d.constants.set(layout::kFogId, view.effects.fog.range != Fog::Range::off);
    if (pass.looks || pass.lights) setShadingConstants(d.constants, view);
    if (pass.distances) d.constants.set(layout::kDistancesId, true);
    d.constants.set(layout::kDepthChannelsId, pass.encoding.channels);
    d.constants.set(layout::kDepthStepsId, pass.encoding.steps);
    d.constants.set(layout::kCornersId, drawn.corners.count);
    if (drawn.plate) d.constants.set(layout::kRimId, drawn.plate->rim);
    // A fragment finds one hit, which may differ from those of its samples.
    if (drawn.plate) d.constants.set(layout::kPlateRoomId, view.samples > 1 ? 0.6f : 0.0f);
    d.streams = chooseStreams(drawn.primitive, pass.looks && !drawn.fetched, drawn.plate != nullptr,
                              view.buffers->ellipsoidOffset > 0);
    d.layout = *passLayout(context, view, pass, drawn).pipeline;
    d.colorsWritten = pass.colorsWritten;
    d.depth = pass.depth;
    d.blend = pass.blend;
    d.ordered = pass.reads && pass.reads->from == NearestFrom::ownAttachment;
    d.strip = drawn.corners.count != kPyramid.count && drawn.primitive != Primitive::triangle;
    return d;
}

void writeReads(gpu::PassContext& context, const SceneView& view, vk::DescriptorSet set, const Reads& reads,
                bool complete) {
    constexpr auto kRead = vk::ImageLayout::eShaderReadOnlyOptimal;
    // The set of triangles has the fourth binding even if nothing reads it.
    const bool texture = reads.from == NearestFrom::texture || (complete && reads.from == NearestFrom::depthBuffer);
    const vk::DescriptorImageInfo atlas(context.pipelines.sampler(vk::Filter::eLinear), reads.atlas, kRead);
    const vk::DescriptorImageInfo nearest(texture ? context.pipelines.sampler(vk::Filter::eNearest) : vk::Sampler(),
                                          reads.nearest ? reads.nearest : reads.atlas,
                                          reads.from == NearestFrom::ownAttachment     ? vk::ImageLayout::eGeneral
                                          : reads.from == NearestFrom::inputAttachment ? context.inputLayout
                                                                                       : kRead);
    const vk::DescriptorImageInfo shadow = describeShadow(context, view, reads.atlas);
    const vk::DescriptorBufferInfo effects(*view.effectConstants->handle, 0, VK_WHOLE_SIZE);
    const vk::WriteDescriptorSet writes[] = {
        {set, 0, 0, Type::eCombinedImageSampler, atlas},
        {set, 1, 0, Type::eUniformBuffer, {}, effects},
        {set, 2, 0, Type::eCombinedImageSampler, shadow},
        {set, 3, 0, texture ? Type::eCombinedImageSampler : Type::eInputAttachment, nearest}};
    const bool three = reads.from == NearestFrom::depthBuffer && !complete;
    context.device->updateDescriptorSets(vk::ArrayProxy<const vk::WriteDescriptorSet>(three ? 3 : 4, writes), {});
}

/// Set 0: the pass's inputs, and the streams if a stage fetches from them by number.
/// @param balls  stream C in place of A
void bindReads(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout,
               const std::optional<Reads>& reads, bool streams, bool balls) {
    if (!reads && !streams) return;
    const vk::DescriptorSet set = context.descriptors.allocate(layout.set, context.pass);
    if (reads) writeReads(context, view, set, *reads, streams);
    if (streams) {
        const std::uint32_t binding = reads ? 4 : 0;
        const gpu::Buffer& first = balls ? view.buffers->balls : view.buffers->shapes;
        const vk::DescriptorBufferInfo shapes(*first.handle, 0, VK_WHOLE_SIZE),
            looks(*view.buffers->looks.handle, 0, VK_WHOLE_SIZE);
        const vk::WriteDescriptorSet writes[] = {{set, binding, 0, Type::eStorageBuffer, {}, shapes},
                                                 {set, binding + 1, 0, Type::eStorageBuffer, {}, looks}};
        context.device->updateDescriptorSets(writes, {});
    }
    context.commands.bindDescriptorSets(kGraphics, *layout.pipeline, 0, set, {});
}

/// First and end of the instances of a kind that the pass draws.
std::array<std::uint64_t, 2> instanceRange(const gpu::PassContext& context, const SceneView& view,
                                           Primitive primitive) {
    if (context.share.count == 1) return {0, ~std::uint64_t{0}};
    const PlacedCopies& all = view.copies;
    return context.share.range(static_cast<std::size_t>(primitive),
                               {all.sphereCount(), all.cylinderCount(), all.triangleCount()});
}

void record(gpu::PassContext& context, const SceneView& view, const GeometryPass& pass, const Draw& drawn) {
    const auto [begin, end] = instanceRange(context, view, drawn.primitive);
    if (begin == end) return;
    const bool sphere = drawn.primitive == Primitive::sphere, triangle = drawn.primitive == Primitive::triangle;
    const bool pyramid = sphere && drawn.corners.count == kPyramid.count;
    const SceneBuffers& scene = *view.buffers;
    const gpu::GraphicsPipeline pipeline = describePipeline(context, view, pass, drawn);
    const gpu::Layout& layout = passLayout(context, view, pass, drawn);
    const vk::raii::CommandBuffer& commands = context.commands;
    commands.bindPipeline(kGraphics, context.pipelines.graphics(
                                         pipeline, [&] { return otherShapes(context, view, pass, drawn, pipeline); }));
    bindReads(context, view, layout, pass.reads, bindsStreams(pass, drawn), sphere && drawn.fetched);
    bindCounter(context, view, layout);
    if (!triangle)
        commands.bindVertexBuffers(0, {*scene.shapes.handle, *scene.looks.handle},
                                   {sphere ? 0 : scene.cylinderOffset, sphere ? 0 : scene.cylinderLookOffset});
    if (sphere) commands.bindVertexBuffers(2, *scene.corners.handle, vk::DeviceSize{0});
    if (sphere && scene.ellipsoidOffset > 0) commands.bindVertexBuffers(3, *scene.shapes.handle, scene.ellipsoidOffset);
    if (pyramid) commands.bindIndexBuffer(*scene.pyramid.handle, 0, vk::IndexType::eUint16);
    layout::ViewConstants constants = view.constants;
    // The vertex stage finds triangles by these counts, for a viewer, a light or a bake.
    constants.spheres = scene.sphereCount;
    constants.cylinders = scene.cylinderCount;
    constants.primitives = scene.primitives();
    if (pass.rim > 0) constants.contourWidth = pass.rim;
    if (context.views > 1) constants.contourDepth = view.otherAxis;
    std::uint64_t at = 0;
    for (const PlacedCopies::Call& all :
         primitiveCalls(view, drawn.primitive)) {  // copies differ by their push constants
        const auto from = static_cast<std::uint32_t>(std::clamp(begin, at, at + all.count) - at);
        const auto to = static_cast<std::uint32_t>(std::clamp(end, at, at + all.count) - at);
        at += all.count;
        if (from == to) continue;
        const PlacedCopies::Call call{all.copy, all.first + from, to - from};
        const glm::vec4* rows = &view.copies.rows[3 * std::size_t{call.copy}];
        constants.row0 = rows[0], constants.row1 = rows[1], constants.row2 = rows[2];
        constants.numberBefore = call.copy * constants.primitives;
        if (context.views > 1) constants.contourWidth = view.copies.otherShifts[call.copy];
        commands.pushConstants<layout::ViewConstants>(*layout.pipeline, kDraw, 0, constants);
        if (triangle) {
            commands.draw(3 * call.count, 1, 3 * call.first, 0);
            continue;
        }
        for (std::uint32_t first = call.first, last = first + call.count; first < last; first += kMostInstances) {
            const std::uint32_t count = std::min(last - first, kMostInstances);
            if (pyramid)
                commands.drawIndexed(kPyramidIndices, count, 0, static_cast<std::int32_t>(drawn.corners.first), first);
            else
                commands.draw(drawn.corners.count, count, drawn.corners.first, first);
        }
    }
}

}  // namespace

vk::DescriptorImageInfo describeShadow(gpu::PassContext& context, const SceneView& view, vk::ImageView atlas) {
    return {context.pipelines.sampler(vk::Filter::eNearest), view.shadow ? context.view(*view.shadow) : atlas,
            vk::ImageLayout::eShaderReadOnlyOptimal};
}

void setEllipsoids(gpu::Specialization& constants, const SceneBuffers& scene, int octants) {
    constants.set(layout::kEllipsoidsId, scene.ellipsoidOffset == 0 ? 0 : scene.cutsOctants ? octants : 1);
}

void setGeometryConstants(gpu::Specialization& constants, const SceneView& view, float rim) {
    constants.set(layout::kPerspectiveId, view.perspective);
    constants.set(layout::kWiresId, view.wireScale > 0);
    setEllipsoids(constants, *view.buffers, view.octants);
    constants.set(layout::kQuarterTurnsId, view.quarterTurns);
    constants.set(layout::kWholeImageId, view.wholeImage);
    constants.set(layout::kCutId, view.cut);
    constants.set(layout::kClipId, view.effects.clip.on());
    constants.set(layout::kFrontsOnlyId, view.frontsOnly);
    constants.set(layout::kContoursId, rim > 0 || (view.effects.contours.width > 0 && !view.effects.linesByGroups()));
}

static_assert(layout::kMatte == static_cast<int>(Material::matte) &&
              layout::kPlastic == static_cast<int>(Material::plastic) &&
              layout::kMetal == static_cast<int>(Material::metal) &&
              layout::kGlow == static_cast<int>(Material::glow) && layout::kMaterials == kMaterials);

void setShadingConstants(gpu::Specialization& constants, const SceneView& view) {
    const Light& light = view.effects.light;
    constants.set(layout::kLightingId, view.lighting);
    constants.set(layout::kOcclusionId, view.occlusion);
    constants.set(layout::kBounceId, view.bounced);
    constants.set(layout::kCapId, static_cast<int>(view.effects.clip.cap));
    constants.set(layout::kCopyColorsId, view.copyColors);
    constants.set(layout::kBlendColorsId, view.blendsColors);
    constants.set(layout::kOwnMaterialId, view.ownMaterials);
    constants.set(layout::kMaterialId, static_cast<int>(light.material));
    constants.set(layout::kFogId, view.effects.fog.range != Fog::Range::off);
    constants.set(layout::kShadowId, view.light != nullptr);
    constants.set(layout::kAmbientId, static_cast<float>(light.ambient));
    constants.set(layout::kDirectId, static_cast<float>(light.direct));
    constants.set(layout::kHighlightId, static_cast<float>(light.highlight));
    constants.set(layout::kGlossId, static_cast<float>(light.gloss));
    constants.set(layout::kPowersId, view.powers);
    constants.set(layout::kDeepeningId, static_cast<float>(light.occlusion));
    constants.set(layout::kCodedId, view.coded);
    constants.set(layout::kCellsId, view.interpolates);
}

void bindCounter(gpu::PassContext& context, const SceneView& view, const gpu::Layout& layout,
                 vk::PipelineBindPoint point) {
    if (!view.fragments) return;
    const vk::DescriptorSet set = context.descriptors.allocate(layout.counterSet, "fragment counter");
    const vk::DescriptorBufferInfo slot = view.fragments->slot(context.pass);
    context.device->updateDescriptorSets(vk::WriteDescriptorSet(set, 0, 0, Type::eStorageBuffer, {}, slot), {});
    context.commands.bindDescriptorSets(point, *layout.pipeline, 1, set, {});
}

void draw(gpu::PassContext& context, const SceneView& view, const GeometryPass& pass) {
    eachDraw(context, view, pass, [&](const Draw& drawn) { record(context, view, pass, drawn); });
}

void want(gpu::PipelineContext& context, const SceneView& view, const GeometryPass& pass) {
    eachDraw(context, view, pass, [&](const Draw& drawn) {
        const gpu::GraphicsPipeline pipeline = describePipeline(context, view, pass, drawn);
        context.pipelines.want(pipeline);
        for (const gpu::GraphicsPipeline& next : otherShapes(context, view, pass, drawn, pipeline))
            context.pipelines.want(next);
    });
}

}  // namespace nacre::passes
