#include "engine/passes/occlusion.h"

#include <algorithm>
#include <cmath>

#include "engine/passes/read_back.h"
#include "engine/passes/view_constants.h"
#include "shaders.h"

namespace nacre::passes {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr std::uint32_t kGridPixels = 2048;     // a batch of depth maps is one square grid of this size
constexpr double kPixelsPerAngstrom = 2.5;      // wanted in a depth map
constexpr std::uint32_t kGroup = 64;            // local_size_x
constexpr std::uint32_t kGroupsPerRow = 32768;  // of a dispatch; the floor allows 65,535
constexpr std::uint32_t kSmallestMap = 128;

constexpr graph::State kComputeBuffer{
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};
std::vector<glm::vec4> rowsOf(const std::vector<glm::dmat3>& frames) {
    std::vector<glm::vec4> rows;
    for (const glm::dmat3& f : frames)
        for (int i = 0; i < 3; ++i) rows.emplace_back(f[0][i], f[1][i], f[2][i], 0.0);
    return rows;
}

}  // namespace

OcclusionBake::OcclusionBake(const gpu::Device& device, Geometry& geometry, Nearest nearest, const SceneBuffers& scene,
                             const Representation& representation, const OcclusionLayout& layout, int directions)
    : device_(device),
      geometry_(geometry),
      nearest_(nearest),
      scene_(scene),
      representation_(representation),
      layout_(layout),
      directions_(occlusionDirections(directions)),
      radius_(representation.radius) {
    double sum = 0;
    for (const Sphere& s : representation.spheres) sum += s.radius;
    meanRadius_ = sum / static_cast<double>(std::max<std::size_t>(representation.spheres.size(), 1));
    const double wanted = std::ceil(2.0 * radius_ * kPixelsPerAngstrom / 8.0) * 8.0;
    mapPixels_ = static_cast<std::uint32_t>(std::clamp<double>(wanted, kSmallestMap, kGridPixels));
    perRow_ = kGridPixels / mapPixels_;

    const std::vector<std::uint32_t> open = openTexels(layout_, representation);
    texels_ = static_cast<std::uint32_t>(open.size());
    const std::vector<glm::vec4> rows = rowsOf(directions_);
    rows_ = gpu::makeBuffer(device, std::span(rows), Usage::eStorageBuffer, "occlusion directions");
    list_ = gpu::makeBuffer(device, std::span(open), Usage::eStorageBuffer, "occlusion texels");
    std::vector<float> sums(layout_.texelCount(), -1.0f);
    for (const std::uint32_t texel : open) sums[texel] = 0.0f;
    sums_ = gpu::makeBuffer(device, std::span<const float>(sums), Usage::eStorageBuffer, "occlusion sums");
    words_ = gpu::makeBuffer(device, std::uint64_t{layout_.width} * layout_.height,
                             Usage::eStorageBuffer | Usage::eTransferSrc, gpu::Access::upload, "occlusion bytes");
    atlas_ = gpu::makeImage(device, {VK_FORMAT_R8_UNORM, {layout_.width, layout_.height}},
                            vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst, false,
                            "occlusion atlas");
    sampler_ = gpu::makeSampler(device, vk::Filter::eNearest, "depth maps");

    using Type = vk::DescriptorType;
    constexpr Type kBindings[] = {Type::eStorageBuffer, Type::eStorageBuffer, Type::eStorageBuffer,
                                  Type::eStorageBuffer, Type::eCombinedImageSampler};
    accumulateLayout_ = gpu::makeLayout(device, kBindings, vk::ShaderStageFlagBits::eCompute,
                                        sizeof(layout::OcclusionConstants), "occlusion accumulation layout");
    finishLayout_ = gpu::makeLayout(device, std::span(kBindings).first(4), vk::ShaderStageFlagBits::eCompute,
                                    sizeof(layout::OcclusionConstants), "occlusion finish layout");
    gpu::Specialization constants;
    const gpu::EncodedFormat& encoded = device.caps().encoded;
    constants.set(1, nearest == Nearest::encoded ? encoded.channels : 1);
    constants.set(2, nearest == Nearest::encoded ? encoded.steps : 0);
    accumulate_ = gpu::makeComputePipeline(device, shaders::occlusionAccumulate, constants, *accumulateLayout_.pipeline,
                                           "occlusion accumulation");
    finish_ = gpu::makeComputePipeline(device, shaders::occlusionFinish, constants, *finishLayout_.pipeline,
                                       "occlusion finish");
}

layout::OcclusionConstants OcclusionBake::constants(std::uint32_t first, std::uint32_t count) const {
    View view;
    view.width = view.height = mapPixels_;
    view.radius = radius_;
    view.pixelsPerAngstrom = mapPixels_ / (2.0 * radius_);
    const layout::ViewConstants v = viewConstants(view, 0.0f, 0, 0);
    layout::OcclusionConstants c{};
    const auto pixel = static_cast<float>(1.0 / view.pixelsPerAngstrom);
    c.map = {mapPixels_, perRow_, view.pixelsPerAngstrom, pixel};
    c.depth = {v.depth.x, v.depth.y, radius_, 0};
    c.patches = {layout_.sphereEdge, layout_.around, layout_.along, 0};
    c.texelCount = texels_;
    c.firstDirection = first;
    c.directionCount = count;
    c.sphereCount = layout_.sphereCount;
    c.atlasWidth = layout_.width;
    c.sphereRows = layout_.sphereRows;
    return c;
}

void OcclusionBake::recordMaps(graph::PassContext& context, Writes writes) const {
    for (int i = 0; i < batch_; ++i) {
        View view;
        view.width = view.height = mapPixels_;
        view.rotation = directions_[static_cast<std::size_t>(done_ + i)];
        view.radius = radius_;
        view.pixelsPerAngstrom = mapPixels_ / (2.0 * radius_);
        const std::uint32_t x = static_cast<std::uint32_t>(i) % perRow_ * mapPixels_;
        const std::uint32_t y = static_cast<std::uint32_t>(i) / perRow_ * mapPixels_;
        const auto side = static_cast<float>(mapPixels_);
        context.commands.setViewport(0, vk::Viewport(static_cast<float>(x), static_cast<float>(y), side, side, 0, 1));
        context.commands.setScissor(0,
                                    vk::Rect2D({static_cast<int>(x), static_cast<int>(y)}, {mapPixels_, mapPixels_}));
        const PlacedCopies copies = placeCopies(representation_, view);
        Draw draw{writes, nearest_};
        draw.copies = &copies;
        draw.radiusPixels = meanRadius_ * view.pixelsPerAngstrom;
        draw.view = viewConstants(view, device_.caps().snapPixels, x + mapPixels_ / 2.0, y + mapPixels_ / 2.0);
        geometry_.draw(context, scene_, draw);
    }
}

void OcclusionBake::dispatch(const vk::raii::CommandBuffer& commands, std::uint32_t invocations) const {
    const std::uint32_t groups = (invocations + kGroup - 1) / kGroup;
    const std::uint32_t wide = std::min(groups, kGroupsPerRow);
    if (groups) commands.dispatch(wide, (groups + wide - 1) / wide, 1);
}

namespace {

void bindBuffers(const gpu::Device& device, vk::DescriptorSet set, std::initializer_list<vk::Buffer> buffers) {
    std::uint32_t binding = 0;
    for (const vk::Buffer buffer : buffers) {
        const vk::DescriptorBufferInfo info(buffer, 0, VK_WHOLE_SIZE);
        device->updateDescriptorSets(
            vk::WriteDescriptorSet(set, binding++, 0, vk::DescriptorType::eStorageBuffer, {}, info), {});
    }
}

}  // namespace

void OcclusionBake::recordAccumulation(graph::PassContext& context, graph::Image maps) const {
    const vk::DescriptorSet set = context.descriptors.allocate(accumulateLayout_.set);
    const vk::DescriptorImageInfo info(*sampler_, context.view(maps), vk::ImageLayout::eShaderReadOnlyOptimal);
    device_->updateDescriptorSets(vk::WriteDescriptorSet(set, 4, 0, vk::DescriptorType::eCombinedImageSampler, info),
                                  {});
    bindBuffers(device_, set, {*scene_.shapes.handle, *rows_.handle, *list_.handle, *sums_.handle});
    context.commands.bindPipeline(vk::PipelineBindPoint::eCompute, *accumulate_);
    context.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *accumulateLayout_.pipeline, 0, set, {});
    context.commands.pushConstants<layout::OcclusionConstants>(
        *accumulateLayout_.pipeline, vk::ShaderStageFlagBits::eCompute, 0,
        constants(static_cast<std::uint32_t>(done_), static_cast<std::uint32_t>(batch_)));
    dispatch(context.commands, texels_);
}

bool OcclusionBake::step(graph::Executor& executor) {
    batch_ = std::min(static_cast<int>(perRow_ * perRow_), static_cast<int>(directions_.size()) - done_);
    if (batch_ <= 0) return false;
    using graph::Clear;
    graph::Graph g("occlusion");
    const graph::Extent grid{kGridPixels, kGridPixels};
    const auto depth = g.image("depth maps' hardware depth", {VK_FORMAT_D32_SFLOAT, grid});
    const auto sums = g.importBuffer("occlusion sums", sums_.size, kComputeBuffer);
    graph::Image maps = depth;
    g.graphics("opaque prepass").depth(depth, Clear{1.0f}).record([&](auto& c) { recordMaps(c, Writes::plates); });
    if (nearest_ == Nearest::encoded) {
        maps = g.image("depth maps", {device_.caps().encoded.format, grid});
        const Clear farthest{device_.caps().encoded.farthest};
        g.graphics("depth encoding").depthTest(depth).color(maps, farthest).record([&](auto& c) {
            recordMaps(c, Writes::encoded);
        });
    } else {
        g.graphics("nearest depth").depth(depth).record([&](auto& c) { recordMaps(c, Writes::depth); });
    }
    g.compute("occlusion accumulation").samples(maps).writes(sums).record([&](auto& c) {
        recordAccumulation(c, maps);
    });
    graph::Imports imports;
    imports.bind(sums, sums_);
    const graph::Plan plan = graph::compile(g, device_.caps().plan);
    device_.submitAndWait([&](const vk::raii::CommandBuffer& c) { executor.record(c, g, plan, imports); });
    executor.reset();
    done_ += batch_;
    return true;
}

void OcclusionBake::finish(graph::Executor& executor) {
    graph::Graph g("occlusion finish");
    const auto sums = g.importBuffer("occlusion sums", sums_.size, kComputeBuffer);
    const auto words = g.importBuffer("occlusion bytes", words_.size, kComputeBuffer);
    const auto atlas = g.importImage("occlusion atlas", atlas_.desc, kTextureState, !atlasDefined_);
    g.compute("occlusion finish").reads(sums).writes(words).record([&](graph::PassContext& c) {
        const vk::DescriptorSet set = c.descriptors.allocate(finishLayout_.set);
        bindBuffers(device_, set, {*scene_.shapes.handle, *rows_.handle, *words_.handle, *sums_.handle});
        c.commands.bindPipeline(vk::PipelineBindPoint::eCompute, *finish_);
        c.commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *finishLayout_.pipeline, 0, set, {});
        layout::OcclusionConstants k = constants(0, static_cast<std::uint32_t>(done_));
        k.texelCount = static_cast<std::uint32_t>(layout_.texelCount() / 4);
        c.commands.pushConstants<layout::OcclusionConstants>(*finishLayout_.pipeline, vk::ShaderStageFlagBits::eCompute,
                                                             0, k);
        dispatch(c.commands, k.texelCount);
    });
    g.transfer("occlusion upload").copiesFrom(words).copiesTo(atlas).record([&](graph::PassContext& c) {
        const vk::BufferImageCopy all(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {},
                                      {layout_.width, layout_.height, 1});
        c.commands.copyBufferToImage(c.buffer(words), c.image(atlas), vk::ImageLayout::eTransferDstOptimal, all);
    });
    graph::Imports imports;
    imports.bind(sums, sums_);
    imports.bind(words, words_);
    imports.bind(atlas, atlas_);
    graph::Plan plan = graph::compile(g, device_.caps().plan);
    device_.submitAndWait([&](const vk::raii::CommandBuffer& c) { executor.record(c, g, plan, imports); });
    executor.reset();
    atlasDefined_ = true;
}

}  // namespace nacre::passes
