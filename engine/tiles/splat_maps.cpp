#include "engine/tiles/splat_maps.h"

#include <cstring>

#include "engine/tiles/tile_bindings.h"
#include "shaders.h"

namespace nacre::occlusion {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr graph::State kMapState{
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};
constexpr std::uint32_t kEmpty = ~0xF149F2CAu;  // orderedBits(-1e30) of shaders/common/ordered.glsl

// Shapes, rows of copies, calls; heights.
constexpr std::array kTypes{passes::kStorage, passes::kStorage, passes::kStorage, passes::kStorage};

/// Push constants of shaders/map_heights.comp.
struct MapHeightConstants {
    float origin = 0, pixel = 0, middle = 0;
    std::uint32_t primitives = 0, spheres = 0, cylinders = 0;
    std::uint32_t mapPixels = 0, apart = 0, pitch = 0;
    std::uint32_t across = 0, copies = 0;
    std::uint32_t first = 0, end = 0;
};

const gpu::Layout& splatLayout(gpu::PipelineContext& context) {
    return context.pipelines.layout({"depth maps by compute", kTypes, passes::kCompute, sizeof(MapHeightConstants)});
}

gpu::ComputePipeline splatPipeline(gpu::PipelineContext& context, const passes::SceneBuffers& buffers) {
    const passes::TileScene scene = passes::tileScene(buffers);
    using passes::TileScene;
    gpu::ComputePipeline d{"depth maps by compute", NACRE_TILE_SCENE(mapHeights), {}, *splatLayout(context).pipeline};
    d.constants.set(layout::kCopiesId, true);
    passes::setEllipsoids(d.constants, buffers);
    return d;
}

/// Makes a buffer of words or rows, larger if needed.
template <typename T>
void put(const gpu::Device& device, gpu::Buffer& buffer, const std::vector<T>& contents, const char* name) {
    const std::size_t bytes = contents.size() * sizeof(T);
    if (!*buffer.handle || buffer.size < bytes)
        buffer = gpu::makeBuffer(device, bytes, Usage::eStorageBuffer, gpu::Access::upload, name);
    if (bytes) std::memcpy(buffer.mapped, contents.data(), bytes);
}

}  // namespace

std::unique_ptr<TileMaps> makeSplatMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                                        std::uint32_t pixels, double radius, std::uint32_t across) {
    return std::make_unique<SplatMaps>(device, scene, pixels, radius, across);
}

SplatMaps::SplatMaps(const gpu::Device& device, const passes::SceneBuffers& scene, std::uint32_t pixels, double radius,
                     std::uint32_t across)
    : device_(device),
      scene_(scene),
      pixels_(pixels),
      apart_(apartFor(pixels)),
      across_(across),
      radius_(radius),
      heights_(gpu::makeBuffer(device, bytesFor(pixels, across), Usage::eStorageBuffer | Usage::eTransferDst,
                               gpu::Access::upload, "depth maps")) {}

void SplatMaps::begin(std::span<const passes::PlacedCopies> maps) {
    rowsOfMaps_.clear();
    words_.assign(passes::kCallsHeader, 0);
    copies_ = maps.empty() ? 1 : static_cast<std::uint32_t>(maps[0].rows.size() / 3);
    std::uint32_t items = 0, calls = 0;
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
        rowsOfMaps_.insert(rowsOfMaps_.end(), maps[i].rows.begin(), maps[i].rows.end());
        const auto add = [&](const std::vector<passes::PlacedCopies::Call>& ofKind, std::uint32_t before) {
            for (const passes::PlacedCopies::Call& c : ofKind) {
                words_.push_back(items);
                words_.push_back((i * copies_ + c.copy) * scene_.primitives() + before + c.first + 1);
                items += c.count;
                ++calls;
            }
        };
        add(maps[i].spheres, 0);
        add(maps[i].cylinders, scene_.sphereCount);
        add(maps[i].triangles, scene_.sphereCount + scene_.cylinderCount);
    }
    words_[0] = calls;
    words_[1] = items_ = items;
    put(device_, calls_, words_, "calls of depth maps");
    put(device_, rows_, rowsOfMaps_, "copies on depth maps");
}

void SplatMaps::wantPipelines(gpu::PipelineContext& context) const {
    context.pipelines.want(splatPipeline(context, scene_));
}

graph::Buffer SplatMaps::import(graph::Graph& g, gpu::Imports& imports) const {
    const graph::Buffer maps = g.importBuffer("depth maps", heights_.size, kMapState);
    imports.bind(maps, heights_);
    return maps;
}

graph::Buffer SplatMaps::declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) {
    const graph::Buffer maps = import(g, imports);
    if (first == 0)
        g.transfer("empty depth maps").copiesTo(maps).record([this](gpu::PassContext& c) {
            c.commands.fillBuffer(*heights_.handle, 0, VK_WHOLE_SIZE, kEmpty);
        });
    g.compute("depth maps by compute").writes(maps).record([=, this](gpu::PassContext& c) { record(c, first, end); });
    return maps;
}

void SplatMaps::record(gpu::PassContext& context, std::uint64_t first, std::uint64_t end) const {
    constexpr std::uint64_t kGroup = 64;
    const std::uint64_t last = std::min<std::uint64_t>(end, items_);
    if (first >= last) return;
    MapHeightConstants c;
    c.origin = static_cast<float>(radius_);
    c.pixel = static_cast<float>(2 * radius_ / pixels_);
    c.middle = static_cast<float>(pixels_) / 2;
    c.primitives = scene_.primitives();
    c.spheres = scene_.sphereCount;
    c.cylinders = scene_.cylinderCount;
    c.mapPixels = pixels_;
    c.apart = apart_;
    c.pitch = pitch();
    c.across = across_;
    c.copies = copies_;
    c.first = static_cast<std::uint32_t>(first);
    c.end = static_cast<std::uint32_t>(last);
    passes::bindTiles(context, splatLayout(context), splatPipeline(context, scene_), c, [&](passes::TileBindings& to) {
        to.store(scene_.shapes);
        to.store(rows_);
        to.store(calls_);
        to.store(heights_);
    });
    passes::dispatchTiles(context, (last - first + kGroup - 1) / kGroup);
}

}  // namespace nacre::occlusion
