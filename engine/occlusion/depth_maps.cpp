#include "engine/occlusion/depth_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "engine/passes/geometry_passes.h"
#include "engine/passes/select_opacity.h"
#include "engine/passes/vertex_costs.h"
#include "engine/passes/view_constants.h"
#include "engine/scene/instances/mesh_levels.h"

namespace nacre::occlusion {
namespace {

// Pixels across the radius of a sphere or cylinder. With finer maps the error of the patches dominates.
constexpr double kPixelsPerSphere = 2.7, kPixelsPerCylinder = 1.5;
// Pixels per radius of curvature of a mesh, and limits per Å. Surfaces bend by 0.7 to 0.9 per Å, cartoons by 1.5
// to 1.9. Beside 1,024 directions and 5 pixels per Å, 1AON's Gaussian surface has 43.2 dB with 2.5 pixels, 42.0
// with 1.6 (two thirds of the time), 40.5 with 1.25. The RMS error of 4HHB's cartoon is 0.037 with 2.5 and with 4, and
// larger with 2.
constexpr double kPixelsPerBend = 2.2, kFewestOfMesh = 1.25, kMostOfMesh = 2.5;
// A mesh covers more pixels per atom than sticks and balls do. One resolution suits a cartoon with some sticks: finer
// maps for the haem sticks of 4HHB (5 % of the primitives) would not improve the ribbons.
constexpr double kShareOfMesh = 16;
// Above this number of triangles in all copies, maps have fewer pixels per Å, down to a minimum share. For example, the
// cartoon of 1TQN in 27 cells has 19 million triangles: a pixel is 0.6 instead of 0.4 Å, and the error 0.19 instead of
// 0.095 Å.
constexpr double kManyTriangles = 8e6, kLeastShare = 0.4;
constexpr double kSmallest = 128, kLargest = 2048;
// Narrow patches need fewer pixels per Å, down to a minimum share.
constexpr double kLeastOfDetail = 0.5;
// Moving atoms have few directions, whose noise outweighs that of coarser maps (docs/ambient_occlusion.md).
constexpr double kShareOfMoving = 0.6;
constexpr std::uint64_t kMostBytesPerPixel = 4 + 8;  // encoded depth in RGBA16F, and the depth buffer
// Primitives per draw of the tile path: their lists take about 30 bytes each on the host.
constexpr std::uint64_t kMostPrimitives = 1'400'000;
// Memory for the maps of a batch on graphics cards, which have memory of their own, whatever the budget: a submission
// costs them as much as drawing some maps.
constexpr std::uint64_t kRoomOfCards = std::uint64_t{256} << 20;
/// Render target states between the graphs of a direction drawn in parts.
const graph::State kPartState = graph::verbState(graph::Verb::samples, graph::PassKind::compute);
std::uint32_t bytesPerPixel(OcclusionMaps path, const graph::EncodedFormat& encoded) {
    switch (path) {
        case OcclusionMaps::encoded:
            return 4 + graph::bytesPerTexel(encoded.format);
        case OcclusionMaps::tiles:
            return 8;  // a height, and as much for lists
        default:
            return 4;
    }
}

/// The parts of draw calls that lie in a model's runs.
std::vector<passes::PlacedCopies::Call> within(const std::vector<passes::PlacedCopies::Call>& calls,
                                               const std::vector<ModelRun>& runs) {
    std::vector<passes::PlacedCopies::Call> parts;
    for (const passes::PlacedCopies::Call& call : calls)
        for (const ModelRun& run : runs) {
            const std::uint32_t first = std::max(call.first, run.first);
            const std::uint32_t end = std::min(call.first + call.count, run.first + run.count);
            if (first < end) parts.push_back({call.copy, first, end - first});
        }
    return parts;
}

/// Instances of the draw calls from `first` to `end`; advances `at`.
std::vector<passes::PlacedCopies::Call> between(const std::vector<passes::PlacedCopies::Call>& calls,
                                                std::uint64_t first, std::uint64_t end, std::uint64_t& at) {
    std::vector<passes::PlacedCopies::Call> parts;
    for (const passes::PlacedCopies::Call& call : calls) {
        const std::uint64_t from = std::clamp(first, at, at + call.count), to = std::clamp(end, at, at + call.count);
        if (from < to)
            parts.push_back(
                {call.copy, call.first + static_cast<std::uint32_t>(from - at), static_cast<std::uint32_t>(to - from)});
        at += call.count;
    }
    return parts;
}

/// Share of the resolution for meshes in many copies: a picture of all copies shows each one small.
double shareOfPixels(const Representation& r) {
    double triangles = 0;
    for (const PrimitiveRun& run : r.copies.triangles)
        triangles += static_cast<double>(run.count) * static_cast<double>(r.copies.lists[run.list].size());
    return std::clamp(std::sqrt(kManyTriangles / std::max(triangles, 1.0)), kLeastShare, 1.0);
}

/// Mean curvature of a scene's meshes, 1/Å: by area, of a sample of the triangles, along the edge that turns most.
double meanCurvature(const Representation& r) {
    constexpr std::size_t kSample = 20'000;
    const std::size_t step = r.triangles.size() / kSample + 1;
    double curvatures = 0, areas = 0;
    for (std::size_t i = 0; i < r.triangles.size(); i += step) {
        const Triangle& t = r.triangles[i];
        std::array<glm::vec3, 3> at, normal;
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshVertex& vertex = r.meshVertices[std::array{t.a, t.b, t.c}[k]];
            at[k] = decodePosition(vertex, t.step());
            normal[k] = decodeNormal(vertex);
        }
        double most = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double length = glm::distance(at[k], at[(k + 1) % 3]);
            if (length > 0) most = std::max(most, glm::distance(normal[k], normal[(k + 1) % 3]) / length);
        }
        const double area = glm::length(glm::cross(at[1] - at[0], at[2] - at[0])) / 2;
        curvatures += most * area;
        areas += area;
    }
    return curvatures / std::max(areas, 1e-9);
}

/// Mean pixels per Å that the primitives need.
double wantedResolution(const Representation& r) {
    double sum = 0;
    for (const Sphere& s : r.spheres) sum += kPixelsPerSphere / s.radius;
    for (const Cylinder& c : r.cylinders) sum += kPixelsPerCylinder / c.radius;
    const double meshes = kShareOfMesh * static_cast<double>(r.meshLooks.size());
    if (meshes > 0) {
        const double ofMesh = std::clamp(kPixelsPerBend * meanCurvature(r), kFewestOfMesh, kMostOfMesh);
        sum += ofMesh * shareOfPixels(r) * meshes;
    }
    const double count = static_cast<double>(r.spheres.size() + r.cylinders.size()) + meshes;
    return sum / std::max(count, 1.0);
}

std::uint64_t countCopies(const Representation& r) { return std::max<std::size_t>(r.copies.transforms.size(), 1); }

/// Primitives that the tile path lists per map.
std::uint64_t listedPrimitives(const Representation& r) {
    return (r.spheres.size() + r.cylinders.size()) * countCopies(r);
}

}  // namespace

std::uint64_t DepthMapSizes::mostBytes(std::uint32_t pixels) {
    return std::max(kMostBytesPerPixel * pixels * pixels, 2 * TileMaps::bytesFor(pixels, 1));
}

std::uint64_t DepthMapSizes::listedBytes(std::uint32_t pixels, std::uint32_t batch, std::uint64_t primitives) {
    return TileMaps::bytesFor(pixels, mapsAcross(batch)) + primitives * batch * TileMaps::kBytesPerPrimitive;
}

std::uint64_t DepthMapSizes::batchBytes(const Representation& representation, std::uint32_t pixels,
                                        std::uint64_t room) {
    const std::uint64_t primitives = listedPrimitives(representation);
    for (const std::uint32_t batch : {DepthMaps::kMostPerBatch, 4u})
        if (const std::uint64_t bytes = listedBytes(pixels, batch, primitives);
            bytes <= room && primitives * batch <= kMostPrimitives)
            return bytes;
    return 0;
}

std::uint32_t DepthMapSizes::pixelsFor(const Representation& representation, std::uint64_t room, std::uint32_t detail,
                                       bool moving) {
    const double share = std::clamp(detail / kFullDetail, kLeastOfDetail, 1.0) *
                         (moving && representation.meshVertices.empty() ? kShareOfMoving : 1.0);
    const double wanted = std::ceil(2.0 * representation.radius * share * wantedResolution(representation) / 8.0) * 8.0;
    auto pixels = static_cast<std::uint32_t>(std::clamp(wanted, std::min(kSmallest, 4.0 * detail), kLargest));
    while (pixels > 8 && mostBytes(pixels) > room) pixels -= 8;
    return pixels;
}

DepthMapSizes::DepthMapSizes(const gpu::Caps& caps, const Representation& representation, OcclusionMaps path,
                             std::uint32_t width, std::uint64_t room)
    : pixels(width) {
    const bool tiles = path == OcclusionMaps::tiles, lists = tiles && !caps.tiles.lists;
    if (caps.apartMemory) room = std::max(room, kRoomOfCards);
    const std::uint32_t each = bytesPerPixel(path, caps.encodedMaps);
    const std::uint64_t listed = listedPrimitives(representation);
    const auto countBytes = [&](std::uint32_t batch) {
        return tiles ? listedBytes(pixels, batch, lists ? listed : 0) : std::uint64_t{each} * pixels * pixels * batch;
    };
    // The tile path numbers the primitives of a batch with 32 bits.
    const std::uint64_t drawn = listed + representation.triangles.size() * countCopies(representation);
    for (const std::uint32_t batch : {4u, DepthMaps::kMostPerBatch})
        if (countBytes(batch) <= room && pixels * mapsAcross(batch) <= caps.maxImageSize &&
            (!tiles || drawn * batch < 1ull << 31) && (!lists || listed * batch <= kMostPrimitives))
            perBatch = batch;
    bytes = countBytes(perBatch);
    mostPrimitives = std::uint64_t{1} << 31;
    if (!lists) return;
    const std::uint64_t ofHeights = listedBytes(pixels, perBatch, 0);
    bytes = std::min(bytes, std::max(room, 2 * ofHeights));
    const std::uint64_t fit = std::min((bytes - ofHeights) / TileMaps::kBytesPerPrimitive, kMostPrimitives);
    // A map whose lists take more than the room is drawn in parts. A part may be listed primitives alone.
    if (listed * perBatch > fit) mostPrimitives = std::max<std::uint64_t>(fit, 1);
}

DepthMaps::DepthMaps(const gpu::Device& device, const passes::SceneBuffers& scene, const Representation& representation,
                     OcclusionMaps path, const DepthMapSizes& sizes, OccluderMeshes occluders)
    : device_(device),
      scene_(scene),
      representation_(representation),
      path_(path),
      sizes_(sizes),
      radius_(representation.radius),
      translucent_(translucentParts(representation)) {
    const auto dealOut = [&](const std::vector<ModelRun>& runs, std::vector<ModelRun> Runs::*kind) {
        for (const ModelRun& run : runs) {
            if (run.model >= runs_.size()) runs_.resize(run.model + 1);
            (runs_[run.model].*kind).push_back(run);
        }
    };
    dealOut(representation.sphereModels, &Runs::spheres);
    dealOut(representation.cylinderModels, &Runs::cylinders);
    dealOut(representation.triangleModels, &Runs::triangles);
    if (runs_.empty()) runs_.emplace_back();
    double sum = 0;
    for (const Sphere& s : representation.spheres) sum += s.radius;
    meanRadius_ = sum / static_cast<double>(std::max<std::size_t>(representation.spheres.size(), 1));
    mostInstances_ = path == OcclusionMaps::tiles ? sizes_.mostPrimitives : instancesThatFit();
    if (path == OcclusionMaps::tiles && sizes_.bytes > 0)
        tiles_ = device.caps().tiles.lists ? makeSplatMaps(device, scene, pixels(), radius_, mapsAcross(perBatch()))
                                           : makeListedMaps(device, scene, representation, pixels(), radius_,
                                                            mapsAcross(perBatch()), std::move(occluders));
}

View DepthMaps::view(const glm::dmat3& frame) const {
    View view;
    view.width = view.height = pixels();
    view.rotation = frame;
    view.radius = radius_;
    view.pixelsPerAngstrom = pixels() / (2.0 * radius_);
    return view;
}

/// The constants of map i of a batch.
layout::ViewConstants DepthMaps::constants(const glm::dmat3& frame, std::uint32_t i, std::uint32_t across) const {
    const std::uint32_t x = i % across * pixels(), y = i / across * pixels();
    return passes::viewConstants(view(frame), x + pixels() / 2.0, y + pixels() / 2.0);
}

/// Draws of one map of a model.
passes::PlacedCopies DepthMaps::placed(const glm::dmat3& frame, std::uint32_t model, MapPart part) const {
    const View seen = view(frame);
    // Only the finest level has the model of each triangle.
    const double error = runs_.size() > 1 ? 0 : errorInSpace(seen, DepthMapSizes::kMeshError);
    passes::PlacedCopies all = passes::placeCopies(representation_, seen, nullptr, 0, error);
    // Translucent primitives do not occlude.
    passes::select(all, translucent_, passes::Opacity::opaque);
    if (runs_.size() > 1) {
        all.spheres = within(all.spheres, runs_[model].spheres);
        all.cylinders = within(all.cylinders, runs_[model].cylinders);
        all.triangles = within(all.triangles, runs_[model].triangles);
    }
    if (part.first == 0 && part.end == MapPart().end) return all;
    std::uint64_t at = 0;
    all.spheres = between(all.spheres, part.first, part.end, at);
    all.cylinders = between(all.cylinders, part.first, part.end, at);
    all.triangles = between(all.triangles, part.first, part.end, at);
    return all;
}

/// Number of instances of any kind whose vertex outputs fit into a render pass.
std::uint64_t DepthMaps::instancesThatFit() const {
    const graph::GeometryCaps& caps = device_.caps().plan.geometry;
    if (caps.mostVertexBytes == 0) return ~std::uint64_t{0};
    const passes::PrimitiveCounts counts{.radiusPixels = radiusPixels(),
                                         .hasEllipsoids = !representation_.ellipsoids.empty()};
    const passes::SphereShapes shapes =
        passes::chooseShapes(PlateShape::automatic, ImpostorShape::automatic, caps, counts);
    const passes::PassCost plates = passes::computeCost(passes::Handed::plates, caps.storesVaryings, shapes);
    const passes::PassCost depth = passes::computeCost(passes::Handed::depth, caps.storesVaryings, shapes);
    std::uint32_t most = 1;
    if (!representation_.spheres.empty()) most = std::max(most, plates[0].bytes + depth[0].bytes);
    if (!representation_.cylinders.empty()) most = std::max(most, depth[1].bytes);
    if (!representation_.triangles.empty()) most = std::max(most, depth[2].bytes);
    return caps.mostVertexBytes / most;
}

std::uint64_t DepthMaps::instances(std::uint32_t model) const {
    const passes::PlacedCopies all = placed(glm::dmat3(1), model);
    return all.sphereCount() + all.cylinderCount() + all.triangleCount();
}

graph::Work DepthMaps::eachMap(std::span<const glm::dmat3> frames, std::uint32_t across, std::uint32_t model,
                               MapPart part, const passes::GeometryPass& pass) const {
    const auto seen = [=, this](std::uint32_t i) {
        passes::SceneView scene;
        scene.buffers = &scene_;
        scene.copies = placed(frames[i], model, part);
        scene.radiusPixels = radiusPixels();
        scene.constants = constants(frames[i], i, across);
        scene.wholeImage = false;
        return scene;
    };
    const auto record = [=, this](gpu::PassContext& c) {
        const auto side = static_cast<float>(pixels());
        for (std::uint32_t i = 0; i < frames.size(); ++i) {
            const std::uint32_t x = i % across * pixels(), y = i / across * pixels();
            c.commands.setViewport(0, vk::Viewport(static_cast<float>(x), static_cast<float>(y), side, side, 0, 1));
            c.commands.setScissor(0, vk::Rect2D({static_cast<int>(x), static_cast<int>(y)}, {pixels(), pixels()}));
            passes::draw(c, seen(i), pass);
        }
    };
    // the other maps use the same pipelines
    const auto want = [=](gpu::PipelineContext& c) { passes::want(c, seen(0), pass); };
    return {record, want};
}

void DepthMaps::beginTiles(std::span<const glm::dmat3> frames, std::uint32_t model) {
    std::vector<passes::PlacedCopies> maps;
    for (const glm::dmat3& frame : frames) maps.push_back(placed(frame, model));
    tiles_->begin(maps);
}

void DepthMaps::declareDrawn(graph::Graph& g, Images& images, std::span<const glm::dmat3> frames, std::uint32_t across,
                             std::uint32_t model, MapPart part) const {
    auto& [depth, maps] = images;
    std::optional<graph::Clear> clear, clearMaps;
    const graph::EncodedFormat& encoded = device_.caps().encodedMaps;
    if (part.first == 0) clear = graph::Clear{1.0f}, clearMaps = graph::Clear{encoded.farthest};
    g.graphics("opaque prepass")
        .depth(depth, clear)
        .record(eachMap(frames, across, model, part, passes::opaquePrepass(false)));
    if (!maps) {
        g.graphics("nearest depth").depth(depth).record(eachMap(frames, across, model, part, passes::nearestDepth()));
        return;
    }
    g.graphics("depth encoding")
        .depthTest(depth)
        .color(*maps, clearMaps)
        .record(eachMap(frames, across, model, part, passes::depthEncoding(passes::Encoding(encoded))));
}

DepthMaps::Images DepthMaps::addImages(graph::Graph& g, std::uint32_t across) const {
    const graph::Extent extent{pixels() * across, pixels() * across};
    const auto depth = g.image("depth maps' hardware depth", {VK_FORMAT_D32_SFLOAT, extent});
    if (!encoded()) return {depth, {}};
    return {depth, g.image("depth maps", {device_.caps().encodedMaps.format, extent})};
}

DepthMaps::Images DepthMaps::addPartImages(graph::Graph& g, bool begins) const {
    const graph::Extent extent{pixels(), pixels()};
    const VkFormat format = encoded() ? device_.caps().encodedMaps.format : VK_FORMAT_D32_SFLOAT;
    const graph::Image map = g.importImage("depth map in parts", {format, extent}, kPartState, begins);
    if (!encoded()) return {map, {}};
    const graph::State depth = graph::verbState(graph::Verb::depth, graph::PassKind::graphics);
    return {g.importImage("its hardware depth", {VK_FORMAT_D32_SFLOAT, extent}, depth, begins), map};
}

void DepthMaps::wantPipelines(gpu::Executor& executor, bool parts) const {
    if (tiles_) return executor.prepare([this](gpu::PipelineContext& c) { tiles_->wantPipelines(c); });
    const glm::dmat3 frame(1);
    // Passes before and after must agree, so that render passes are compatible.
    const auto prepare = [&](std::uint32_t model, MapPart part, const auto& add) {
        graph::Graph g("occlusion ahead");
        Images images = add(g);
        declareDrawn(g, images, {&frame, 1}, 1, model, part);
        const auto state = graph::verbState(graph::Verb::writes, graph::PassKind::compute);
        const auto sums = g.importBuffer("occlusion sums", sizeof(glm::vec2), state);
        g.compute("occlusion accumulation").samples(images.maps.value_or(images.depth)).writes(sums);
        g.output(sums);
        executor.prepare(g, graph::compile(g, device_.caps().plan));
    };
    for (std::uint32_t model = 0; model < models(); ++model) {
        prepare(model, {}, [&](graph::Graph& g) { return addImages(g, 1); });
        if (!parts) continue;
        prepare(model, {}, [&](graph::Graph& g) { return addPartImages(g, true); });
        prepare(model, {1}, [&](graph::Graph& g) { return addPartImages(g, false); });
    }
}

DrawnMaps DepthMaps::declare(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frames,
                             std::uint32_t batch, std::uint32_t model) {
    const std::uint32_t across = mapsAcross(batch);
    if (tiles_) {
        beginTiles(frames, model);
        return {{}, tiles_->declare(g, imports, 0, frames.size() * instances(model))};
    }
    Images images = addImages(g, across);
    declareDrawn(g, images, frames, across, model, {});
    return {images.maps.value_or(images.depth), {}};
}

void DepthMaps::makePartImages() {
    using Usage = vk::ImageUsageFlagBits;
    if (*partMap_.handle) return;
    const graph::Extent extent{pixels(), pixels()};
    const auto depth = Usage::eDepthStencilAttachment | Usage::eSampled;
    if (path_ == OcclusionMaps::fragdepth) {
        partMap_ = gpu::makeImage(device_, {VK_FORMAT_D32_SFLOAT, extent}, depth, false, "depth map in parts");
        return;
    }
    partMap_ = gpu::makeImage(device_, {device_.caps().encodedMaps.format, extent},
                              Usage::eColorAttachment | Usage::eSampled, false, "depth map in parts");
    partDepth_ = gpu::makeImage(device_, {VK_FORMAT_D32_SFLOAT, extent}, depth, false, "its hardware depth");
}

void DepthMaps::declarePart(graph::Graph& g, gpu::Imports& imports, std::span<const glm::dmat3> frame,
                            std::uint32_t model, std::uint64_t first, std::uint64_t end) {
    if (tiles_) {
        if (first == 0) beginTiles(frame, model);
        tiles_->declare(g, imports, first, end);
        return;
    }
    makePartImages();
    const MapPart part{first, end};
    Images images = addPartImages(g, first == 0);
    imports.bind(images.maps.value_or(images.depth), partMap_);
    if (images.maps) imports.bind(images.depth, partDepth_);
    declareDrawn(g, images, frame, 1, model, part);
}

DrawnMaps DepthMaps::drawnParts(graph::Graph& g, gpu::Imports& imports) const {
    if (tiles_) return {{}, tiles_->import(g, imports)};
    const auto map = g.importImage("depth map in parts", partMap_.desc, kPartState);
    imports.bind(map, partMap_);
    return {map, {}};
}

}  // namespace nacre::occlusion
