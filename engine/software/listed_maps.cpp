#include "engine/software/listed_maps.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/occlusion/pipelines.h"
#include "engine/passes/view_constants.h"
#include "engine/software/software.h"
#include "engine/threads.h"
#include "engine/tiles/tile_bindings.h"
#include "shaders.h"

namespace nacre::occlusion {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr auto kRead = Usage::eUniformTexelBuffer | Usage::eStorageBuffer;
constexpr graph::State kHeightState{
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT, {}};
constexpr float kNoHeight = -1e30f;  // height of an empty place of a map, as in shaders/tile_depth.comp

// Shapes, rows of copies, lists, heights to read, heights to write.
constexpr std::array kTileMapsTexels{passes::kTexel, passes::kTexel, passes::kTexel, passes::kTexel, passes::kStorage};
constexpr auto kTileMapsStorage = passes::asStorage(kTileMapsTexels);

const gpu::Layout& tileMapsLayout(gpu::PipelineContext& context) {
    const bool texels = context.device.caps().tiles.texels;
    return context.pipelines.layout({"depth maps by tiles layout", texels ? kTileMapsTexels : kTileMapsStorage,
                                     passes::kCompute, sizeof(layout::MapConstants)});
}

gpu::ComputePipeline tileMapsPipeline(gpu::PipelineContext& context, const passes::SceneBuffers& scene) {
    const bool cylinders = scene.cylinderCount > 0;
    const bool texels = context.device.caps().tiles.texels;
    const auto code = texels ? (cylinders ? shaders::tileDepthTexelsCylinders : shaders::tileDepthTexelsSpheres)
                             : (cylinders ? shaders::tileDepthStorageCylinders : shaders::tileDepthStorageSpheres);
    gpu::ComputePipeline d{"depth maps by tiles", code, {}, *tileMapsLayout(context).pipeline};
    d.constants.set(layout::kCopiesId, true);
    passes::setEllipsoids(d.constants, scene);
    d.constants.set(layout::kTilesInBinId, TileLists::kTilesInBin);
    d.constants.set(layout::kLanesId, context.device.caps().tiles.lanes);
    return d;
}

}  // namespace

std::unique_ptr<TileMaps> makeListedMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                                         const Representation& representation, std::uint32_t pixels, double radius,
                                         std::uint32_t across, OccluderMeshes occluders) {
    return std::make_unique<ListedMaps>(device, scene, representation, pixels, radius, across, std::move(occluders));
}

gpu::ShaderWords questionsToTexelMaps(Texels texels) {
    switch (texels) {
        case Texels::spheres:
            return shaders::occlusionAccumulateSphereTexels;
        case Texels::wholeSpheres:
            return shaders::occlusionAccumulateWholeTexels;
        case Texels::cylinders:
            return shaders::occlusionAccumulateCylinderTexels;
        case Texels::vertices:
            break;
    }
    return shaders::occlusionAccumulateVertexTexels;
}

ListedMaps::ListedMaps(const gpu::Device& device, const passes::SceneBuffers& scene,
                       const Representation& representation, std::uint32_t pixels, double radius, std::uint32_t across,
                       OccluderMeshes occluders)
    : device_(device),
      scene_(scene),
      representation_(representation),
      pixels_(pixels),
      apart_(apartFor(pixels)),
      across_(across),
      radius_(radius),
      occluders_(std::move(occluders)) {
    heights_ = gpu::makeBuffer(device, bytesFor(pixels, across), Usage::eStorageBuffer | Usage::eUniformTexelBuffer,
                               scene.triangleCount > 0 ? gpu::Access::readback : gpu::Access::upload, "depth maps");
    if (device.caps().tiles.texels)
        heightTexels_ = gpu::makeTexelView(device, heights_, vk::Format::eR32Sfloat, "depth maps");
}

void ListedMaps::begin(std::span<const passes::PlacedCopies> maps) {
    rows_.clear();
    calls_.clear();
    for (const passes::PlacedCopies& map : maps) rows_.insert(rows_.end(), map.rows.begin(), map.rows.end());
    copies_ = maps.empty() ? 1 : static_cast<std::uint32_t>(maps[0].rows.size() / 3);
    asides_ = rows_;
    const std::uint32_t inCopy = scene_.primitives();
    const double pixel = 2 * radius_ / pixels_, apart = apart_ * pixel;  // Å
    for (std::uint32_t i = 0; i < maps.size(); ++i) {
        const std::uint32_t firstCopy = i * copies_;
        for (std::size_t row = 3 * std::size_t{firstCopy}; row < 3 * std::size_t{firstCopy + copies_}; row += 3) {
            asides_[row].w += static_cast<float>(i % across_ * apart);
            asides_[row + 1].w -= static_cast<float>(i / across_ * apart);
        }
        const auto add = [&](const std::vector<passes::PlacedCopies::Call>& calls, passes::Primitive kind,
                             const std::vector<glm::vec4>& rows, std::uint32_t before) {
            for (const passes::PlacedCopies::Call& c : calls) {
                const std::uint32_t copy = firstCopy + c.copy;
                const OccluderMesh* mesh = nullptr;
                if (kind == passes::Primitive::triangle)
                    mesh = &occluders_.of(representation_, c.first, c.count, static_cast<float>(pixel));
                calls_.push_back(
                    {{&rows[3 * std::size_t{copy}], c.first, c.count, copy * inCopy + before + 1}, kind, i, mesh});
            }
        };
        // Triangles first: the host draws a map before the device does.
        add(maps[i].triangles, passes::Primitive::triangle, rows_, scene_.sphereCount + scene_.cylinderCount);
        add(maps[i].spheres, passes::Primitive::sphere, asides_, 0);
        add(maps[i].cylinders, passes::Primitive::cylinder, asides_, scene_.sphereCount);
    }
    reserve(device_, rowTexels_, rows_.size() * sizeof(glm::vec4), kRead, vk::Format::eR32G32B32A32Sfloat,
            "copies on depth maps");
    std::memcpy(rowTexels_.buffer.mapped, rows_.data(), rows_.size() * sizeof(glm::vec4));
    // At most the existing maps: an incomplete batch has fewer rows.
    const std::size_t rowsOfMaps = (maps.size() + across_ - 1) / across_;
    std::fill_n(reinterpret_cast<float*>(heights_.mapped), rowsOfMaps * apart_ * pitch(), kNoHeight);
}

void ListedMaps::wantPipelines(gpu::PipelineContext& context) const {
    if (scene_.sphereCount + scene_.cylinderCount > 0) context.pipelines.want(tileMapsPipeline(context, scene_));
}

TileView ListedMaps::view() const {
    TileView v;
    v.width = v.height = pitch();
    v.pixels = static_cast<float>(pixels_ / (2 * radius_));
    v.axis = glm::vec2(static_cast<float>(pixels_) / 2);
    v.origin = static_cast<float>(radius_);
    v.nearest = 0;
    v.range = static_cast<float>(2 * radius_);
    return v;
}

/// The parts of calls between two primitives of the batch.
void ListedMaps::take(std::uint64_t first, std::uint64_t end) {
    spheres_.clear();
    cylinders_.clear();
    triangles_.clear();
    std::uint64_t before = 0;
    for (const Call& c : calls_) {
        const std::uint64_t from = std::clamp(first, before, before + c.call.count) - before;
        const std::uint64_t to = std::clamp(end, before, before + c.call.count) - before;
        before += c.call.count;
        TileCall part = c.call;
        part.first += static_cast<std::uint32_t>(from);
        part.count = static_cast<std::uint32_t>(to - from);
        if (part.count == 0) continue;
        if (c.kind == passes::Primitive::triangle) {
            // A coarser mesh has fewer triangles: draw the same fraction.
            const std::uint64_t drawn = c.mesh->triangles.size();
            triangles_.resize(c.map + 1);
            triangles_[c.map].push_back({part.rows, c.mesh, from * drawn / c.call.count, to * drawn / c.call.count});
        } else {
            (c.kind == passes::Primitive::sphere ? spheres_ : cylinders_).push_back(part);
        }
    }
}

/// Maps share no pixels, so each may have its own thread.
void ListedMaps::drawTriangles() {
    meshes_.resize(std::max(meshes_.size(), triangles_.size()));
    inParallel(triangles_.size(), [&](std::size_t map) {
        const auto across = static_cast<std::size_t>(across_);
        float* heights = reinterpret_cast<float*>(heights_.mapped) + (map / across * pitch() + map % across) * apart_;
        for (const MeshCall& call : triangles_[map])
            meshes_[map].draw(*call.mesh, call.first, call.end, call.rows,
                              {heights, pitch(), pixels_, static_cast<float>(pixels_ / (2 * radius_))});
    });
    if (!triangles_.empty()) heights_.flush();
}

/// Lists as many primitives as a list may have entries, and uploads the lists.
void ListedMaps::list(Part& part, std::uint64_t first, std::uint64_t& end) {
    for (;; end = first + (end - first) / 2) {
        take(first, end);
        part.lists.build(view(), {representation_.spheres, spheres_, representation_.cylinders, cylinders_});
        if (part.lists.longest() <= device_.caps().tiles.longestList) break;
    }
    reserve(device_, part.words, 4 * part.lists.words(), kRead, vk::Format::eR32Uint, "lists of depth maps");
    part.lists.write(reinterpret_cast<std::uint32_t*>(part.words.buffer.mapped));
}

graph::Buffer ListedMaps::import(graph::Graph& g, gpu::Imports& imports) const {
    const graph::Buffer maps = g.importBuffer("depth maps", heights_.size, kHeightState);
    imports.bind(maps, heights_);
    return maps;
}

graph::Buffer ListedMaps::declare(graph::Graph& g, gpu::Imports& imports, std::uint64_t first, std::uint64_t end) {
    const graph::Buffer maps = import(g, imports);
    take(first, end);
    drawTriangles();
    for (std::size_t i = 0; first < end; ++i) {
        if (i == parts_.size()) parts_.push_back(std::make_unique<Part>());
        Part& part = *parts_[i];
        std::uint64_t to = end;
        list(part, first, to);
        g.compute("depth maps by tiles").writes(maps).record([&part, this](gpu::PassContext& c) { record(c, part); });
        first = to;
    }
    return maps;
}

void ListedMaps::record(gpu::PassContext& context, const Part& part) const {
    const TileLists& lists = part.lists;
    if (lists.tiles().empty()) return;
    const TileView v = view();
    layout::MapConstants c{};
    c.origin = v.origin;
    c.primitives = scene_.primitives();
    c.axisPixel = v.axis;
    c.pixel = 1 / v.pixels;
    c.perRange = 1 / v.range;
    c.spheres = scene_.sphereCount;
    c.cylinders = scene_.cylinderCount;
    c.across = lists.across();
    c.offsets = static_cast<std::uint32_t>(lists.tiles().size());
    c.binsOfMap = apart_ / TileLists::kBinPixels;
    c.copies = copies_;
    const gpu::ComputePipeline pipeline = tileMapsPipeline(context, scene_);
    passes::bindTiles(context, tileMapsLayout(context), pipeline, c, [&](passes::TileBindings& to) {
        to.read(scene_.shapes, scene_.shapeTexels);
        to.read(rowTexels_);
        to.read(part.words);
        to.read(heights_, heightTexels_);
        to.store(heights_);
    });
    passes::dispatchTiles(context, lists.tiles().size());
}

}  // namespace nacre::occlusion
