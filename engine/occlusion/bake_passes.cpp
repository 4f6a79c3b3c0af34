// Dispatches of a bake: depth map tests, and their sums into the atlas.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/matrix.hpp>

#include "engine/occlusion/bake.h"
#include "engine/occlusion/pipelines.h"
#include "engine/passes/read_back.h"
#include "engine/passes/view_constants.h"

namespace nacre::occlusion {
namespace {

using Type = vk::DescriptorType;
constexpr std::uint32_t kGroup = 64;            // local_size_x
constexpr std::uint32_t kGroupsPerRow = 32768;  // of a dispatch; Vulkan guarantees 65,535

void bind(const gpu::Device& device, vk::DescriptorSet set, std::uint32_t binding, Type type, vk::Buffer buffer,
          vk::DeviceSize offset = 0, vk::DeviceSize size = VK_WHOLE_SIZE) {
    const vk::DescriptorBufferInfo info(buffer, offset, size);
    device->updateDescriptorSets(vk::WriteDescriptorSet(set, binding, 0, type, {}, info), {});
}

void dispatch(const vk::raii::CommandBuffer& commands, std::uint64_t invocations) {
    const auto groups = static_cast<std::uint32_t>((invocations + kGroup - 1) / kGroup);
    const std::uint32_t wide = std::min(groups, kGroupsPerRow);
    if (groups) commands.dispatch(wide, (groups + wide - 1) / wide, 1);
}

layout::NarrowDirections narrowed(std::span<const layout::Direction> directions) {
    layout::NarrowDirections few{};
    for (std::size_t i = 0; i < directions.size(); ++i) {
        few.rows[2 * i] = directions[i].u;
        few.rows[2 * i + 1] = directions[i].v;
        few.heights[i / 4][static_cast<int>(i % 4)] = directions[i].w.w;
    }
    return few;
}

}  // namespace

layout::OcclusionConstants Bake::constants() const {
    const View view = maps_.view(glm::dmat3(1));
    const layout::ViewConstants v = passes::viewConstants(view, 0, 0);
    layout::OcclusionConstants c{};
    c.mapPixels = static_cast<int>(maps_.pixels());
    c.apart = static_cast<int>(maps_.tiles() ? maps_.tiles()->apart() : maps_.pixels());
    c.pitch = static_cast<int>(maps_.tiles() ? maps_.tiles()->pitch() : 0);
    c.pixelsPerAngstrom = static_cast<float>(view.pixelsPerAngstrom);
    c.pixel = static_cast<float>(1.0 / view.pixelsPerAngstrom);
    c.depthAt0 = (v.origin - v.depthStart) * v.perRange;
    c.depthPerPixel = c.pixel * v.perRange;
    c.sphereEdge = layout_.sphereEdge;
    c.around = layout_.around;
    c.along = layout_.along;
    c.spheres = layout_.sphereCount;
    c.firstVertex = scene_.sphereCount + 2 * scene_.cylinderCount + scene_.triangleCount;
    c.firstVertexTexel = static_cast<std::uint32_t>(layout_.patchTexels());
    return c;
}

float Bake::spreadOfTaps() const {
    // A few sticks among full atoms must not make the bake four times as expensive.
    if (2 * std::uint64_t{layout_.cylinderCount} <= layout_.sphereCount) return 0;
    return widestTaps();
}

float Bake::widestTaps() const { return static_cast<float>(std::min(2.0 * std::sqrt(128.0 / directions()), 2.5)); }

float Bake::spreadOfVertices() const {
    // Four taps reduce the RMS error of 4HHB's cartoon (62,000 vertices) from 0.042 to 0.037. Surfaces have few thin
    // parts and many vertices.
    constexpr std::uint32_t kMost = 200'000;
    return layout_.vertexCount <= kMost ? widestTaps() : spreadOfTaps();
}

/// How texels of each kind sample the maps of a batch.
Accumulation Bake::accumulation(OcclusionCopies::Run::Of of, std::uint32_t batch) const {
    using Of = OcclusionCopies::Run::Of;
    const Texels spheres = layout_.sphereEdge == 1 ? Texels::wholeSpheres : Texels::spheres;
    const bool vertices = of == Of::vertices;
    return {vertices              ? Texels::vertices
            : of == Of::cylinders ? Texels::cylinders
                                  : spheres,
            batch, maps_.encoded(), maps_.tiles() != nullptr, scene_.ellipsoidOffset > 0, narrow_, maps_.across(batch),
            vertices ? spreadOfVertices() : spreadOfTaps(),
            // Neighbouring vertices of a mesh sample the map too, so two taps suffice: they raise the RMS error of
            // 4HHB's cartoon by 0.001 against four.
            vertices ? 2u : 4u};
}

void Bake::wantPipelines(gpu::Executor& executor, const Allowance& least, const Allowance& most) const {
    if (!executor.makesPipelinesAhead() || complete()) return;
    const Work first = nextWork(least);
    const std::uint32_t smallest = batchFor(first.count), largest = batchFor(nextWork(most).count);
    executor.prepare([&](gpu::PipelineContext& c) {
        for (std::uint32_t batch = smallest; batch <= largest; batch *= 4)
            for (const OcclusionCopies::Run& run : copies_.runs)
                if (run.count > 0) c.pipelines.want(accumulationPipeline(c, accumulation(run.of, batch)));
        c.pipelines.want(finishPipeline(c));
    });
    // Last: a caller that waits for the bake can compile the first pipelines itself meanwhile.
    maps_.wantPipelines(executor, !drawnAtOnce(first, least));
}

vk::DescriptorSet Bake::accumulationSet(gpu::PassContext& context, std::optional<graph::Image> maps,
                                        std::uint32_t group) {
    const vk::DescriptorSet set =
        context.descriptors.allocate(accumulationLayout(context, !maps).set, "occlusion accumulation");
    bind(device_, set, 2, Type::eStorageBuffer, *list_.handle);
    bind(device_, set, 3, Type::eStorageBuffer, *sums_.handle);
    if (!maps && maps_.tiles()->texels()) {
        const vk::BufferView heights = maps_.tiles()->texels(), directions = *directionTexels_,
                             shapes = *scene_.shapeTexels;
        const vk::WriteDescriptorSet writes[] = {{set, 0, 0, 1, Type::eUniformTexelBuffer, {}, {}, &shapes},
                                                 {set, 1, 0, 1, Type::eUniformTexelBuffer, {}, {}, &directions},
                                                 {set, 4, 0, 1, Type::eUniformTexelBuffer, {}, {}, &heights}};
        device_->updateDescriptorSets(writes, {});
        return set;
    }
    bind(device_, set, 0, Type::eStorageBuffer, *scene_.shapes.handle);
    bind(device_, set, 1, Type::eUniformBuffer, *batchDirections_.handle, group * kGroupBytes, kGroupBytes);
    if (!maps) {
        bind(device_, set, 4, Type::eStorageBuffer, *maps_.tiles()->buffer().handle);
        return set;
    }
    const vk::DescriptorImageInfo info(context.pipelines.sampler(vk::Filter::eNearest), context.view(*maps),
                                       vk::ImageLayout::eShaderReadOnlyOptimal);
    device_->updateDescriptorSets(vk::WriteDescriptorSet(set, 4, 0, Type::eCombinedImageSampler, info), {});
    return set;
}

void Bake::recordAccumulation(gpu::PassContext& context, std::optional<graph::Image> maps, std::uint32_t batch,
                              const Work& work) {
    constexpr auto kCompute = vk::PipelineBindPoint::eCompute;
    const vk::PipelineLayout pipelineLayout = *accumulationLayout(context, !maps).pipeline;
    layout::OcclusionConstants c = constants();
    std::vector<vk::DescriptorSet> sets(copies_.groups.size());
    std::size_t at = 0;  // index into the model's texels
    for (const OcclusionCopies::Run& run : copies_.runs) {
        if (run.model != work.model) continue;
        const std::size_t from = std::clamp(work.asked, at, at + run.count) - at;
        const std::size_t to = std::clamp(work.askedThen, at, at + run.count) - at;
        at += run.count;
        if (from == to) continue;
        if (!sets[run.group]) sets[run.group] = accumulationSet(context, maps, run.group);
        c.firstDirection = run.group * static_cast<std::uint32_t>(kGroupBytes / sizeof(glm::vec4));
        c.firstEntry = static_cast<std::uint32_t>(run.first + from);
        c.entries = static_cast<std::uint32_t>(to - from);
        c.step = run.step;
        const Accumulation what = accumulation(run.of, batch);
        const gpu::ComputePipeline pipeline = accumulationPipeline(context, what);
        context.commands.bindPipeline(kCompute, context.pipelines.compute(pipeline));
        context.commands.bindDescriptorSets(kCompute, pipelineLayout, 0, sets[run.group], {});
        context.commands.pushConstants<layout::OcclusionConstants>(pipelineLayout, vk::ShaderStageFlagBits::eCompute, 0,
                                                                   c);
        const bool pairs = asksByPairs(what);
        dispatch(context.commands, pairs ? (to - from + 1) / 2 : to - from);
    }
}

/// Writes the directions of a batch for each group of copies. Each direction first moves the tested copy to its
/// position. Missing directions are zero. Units: map pixels; rows run downwards.
/// @param first  index of the batch's first direction
void Bake::writeDirections(std::span<const glm::dmat3> frames, int first) {
    auto* group = batchDirections_.mapped;
    const double scale = maps_.view(glm::dmat3(1)).pixelsPerAngstrom, middle = maps_.pixels() / 2.0;
    const glm::dmat3 toPixels(scale, 0, 0, 0, -scale, 0, 0, 0, scale);
    for (const std::vector<glm::dmat4x3>& places : copies_.groups) {
        std::array<layout::Direction, DepthMaps::kMostPerBatch> directions{};
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const glm::dmat4x3& place = places[(static_cast<std::size_t>(first) + i) / 2 % places.size()];
            const glm::dmat3 frame = toPixels * frames[i];
            const glm::dmat3 rows = glm::transpose(frame * glm::dmat3(place[0], place[1], place[2]));
            const glm::dvec3 shift = frame * place[3] + glm::dvec3(middle, middle, 0);
            directions[i] = {glm::vec4(rows[0], shift.x), glm::vec4(rows[1], shift.y), glm::vec4(rows[2], shift.z)};
        }
        if (narrow_) {
            const layout::NarrowDirections few = narrowed(directions);
            std::memcpy(group, &few, sizeof few);
        } else {
            std::memcpy(group, directions.data(), sizeof directions);
        }
        group += kGroupBytes;
    }
}

void Bake::declareFinish(graph::Graph& g, gpu::Imports& imports) {
    const auto sums = g.importBuffer("occlusion sums", sums_.size, kComputeBuffer);
    const auto bytes = g.importBuffer("occlusion bytes", bytes_.size, kComputeBuffer);
    auto atlas = g.importImage("occlusion atlas", atlas_.desc, passes::kTextureState, !atlasDefined_);
    g.compute("occlusion finish").reads(sums).writes(bytes).record([this](gpu::PassContext& c) {
        const vk::DescriptorSet set = c.descriptors.allocate(finishLayout(c).set, "occlusion finish");
        bind(device_, set, 0, Type::eStorageBuffer, *sums_.handle);
        bind(device_, set, 1, Type::eStorageBuffer, *words_.handle);
        bind(device_, set, 2, Type::eStorageBuffer, *bytes_.handle);
        c.commands.bindPipeline(vk::PipelineBindPoint::eCompute, c.pipelines.compute(finishPipeline(c)));
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *finishLayout(c).pipeline, 0, set, {});
        c.commands.pushConstants<std::uint32_t>(*finishLayout(c).pipeline, vk::ShaderStageFlagBits::eCompute, 0,
                                                static_cast<std::uint32_t>(wordCount_));
        dispatch(c.commands, wordCount_);
    });
    g.transfer("occlusion upload").copiesFrom(bytes).copiesTo(atlas).record([=, this](gpu::PassContext& c) {
        const vk::BufferImageCopy all(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                      {layout_.width, layout_.height, 1});
        c.commands.copyBufferToImage(c.buffer(bytes), c.image(atlas), vk::ImageLayout::eTransferDstOptimal, all);
    });
    g.output(bytes);  // the host stores them
    imports.bind(sums, sums_);
    imports.bind(bytes, bytes_);
    imports.bind(atlas, atlas_);
    atlasDefined_ = true;
}

}  // namespace nacre::occlusion
