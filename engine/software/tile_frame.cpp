#include "engine/software/tile_frame.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "engine/passes/view_constants.h"
#include "engine/threads.h"

namespace nacre::passes {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr auto kReadByTiles = Usage::eStorageBuffer | Usage::eUniformTexelBuffer;

/// Loop iterations of an invocation available for edges, and those used by a subgroup's pixels besides the list.
constexpr std::uint64_t kTurnsOfEdges = 60'000, kTurnsOfFilling = 48;

/// Half width in pixels below which a primitive may be missed by all pixels around it.
constexpr double kSmallPixels = 0.75;
/// From this size on, a pixel's samples show almost only what the centres of the nine pixels around show.
constexpr double kLargePixels = 6;

void listCalls(const SceneView& seen, const std::vector<PlacedCopies::Call>& calls, std::uint32_t first,
               std::vector<TileCall>& list) {
    list.clear();
    for (const PlacedCopies::Call& c : calls)
        list.push_back({&seen.copies.rows[3 * std::size_t{c.copy}], c.first, c.count,
                        c.copy * seen.constants.primitives + first + 1});
}

static_assert(TileLists::kDepthSteps == layout::kListSteps);

layout::TileConstants makeConstants(const layout::ViewConstants& c, const PlacedCopies& copies,
                                    const TileLists& lists) {
    layout::TileConstants t{};
    if (!copies.rows.empty()) t.row0 = copies.rows[0], t.row1 = copies.rows[1], t.row2 = copies.rows[2];
    t.origin = c.origin;
    t.primitives = c.primitives;
    t.axisPixel = c.axisPixel;
    t.pixel = c.pixel;
    t.depthStart = c.depthStart;
    t.perRange = c.perRange;
    t.spheres = c.spheres;
    t.across = lists.across();
    t.offsets = static_cast<std::uint32_t>(lists.tiles().size());
    t.wirePixel = c.wirePixel;
    t.clipNear = c.clipNear;
    t.atlasTexel = c.atlasTexel;
    t.patchTexels = c.patchTexels;
    t.patchesInRow = c.patchesInRow;
    t.clipFar = c.clipFar;
    t.contourWidth = c.contourWidth;
    t.contourDepth = c.contourDepth;
    t.cylinders = c.cylinders;
    return t;
}

/// Where compute shades, a workgroup draws several tiles in turn: to start one costs a software device as much as
/// shading some rows of pixels. Their lists together are as long as one list may be. @param walks  of a list
std::uint32_t groupsOfTiles(const TileLists& lists, bool shaded, std::uint32_t walks, std::uint32_t longestList) {
    constexpr std::uint32_t kMost = 16, kGroups = 64;  // tiles per group; groups that keep all processors busy
    const auto tiles = static_cast<std::uint32_t>(lists.tiles().size());
    const std::uint32_t together = longestList / (walks * std::max(lists.longest(), 1u));
    const std::uint32_t ofGroup = shaded ? std::clamp(std::min(tiles / kGroups, together), 1u, kMost) : 1;
    return (tiles + ofGroup - 1) / ofGroup;
}

/// Maximum number of workgroups that draw edges. Each fills its lanes repeatedly: on a software device an empty
/// workgroup costs as much as a full one. No loop may exceed lavapipe's limit.
/// @param byDevice  the lengths of lists are unknown
std::uint32_t groupsOfEdges(const TileLists& lists, const gpu::TileCaps& caps, bool byDevice) {
    constexpr std::uint64_t kFew = 64, kRow = 65535;
    const std::uint64_t fillings =
        lists.tiles().size() * (TileLists::kTilePixels * TileLists::kTilePixels / caps.lanes);
    if (byDevice) return static_cast<std::uint32_t>(std::min(fillings, kRow));
    const std::uint64_t turns = kTurnsOfFilling + std::uint64_t{lists.longest()} * 3 / 2;
    const std::uint64_t least = fillings * turns / kTurnsOfEdges + 1;
    return static_cast<std::uint32_t>(std::min(std::max(least, caps.texels ? kFew : lists.tiles().size()), kRow));
}

}  // namespace

static_assert(TileView::kNoPlane == layout::kNoPlane);

TileView tileView(const SceneView& seen, const View& view, graph::Extent image, bool centers) {
    const layout::ViewConstants& c = seen.constants;
    TileView v{screenView(c, view, image.width, image.height)};
    if (seen.effects.clip.on()) v.clipNear = c.clipNear, v.clipFar = c.clipFar;
    v.contour = std::max(c.contourWidth, seen.rims.widest());
    v.wireScale = seen.wireScale;
    v.centers = centers;
    v.frontsOnly = seen.frontsOnly;
    return v;
}

std::unique_ptr<TileFrames> makeTileFrames(const gpu::Device& device) { return std::make_unique<ListedFrames>(device); }

/// Made when the host first draws a scene's spheres. Kept when only colours change.
const SphereBoxes& ListedFrames::sceneBoxes(const Representation& r, const SceneView& seen) {
    if (!seen.owner || boxed_.lock() != seen.owner) {
        boxes_ = makeSphereBoxes(r);
        boxed_ = seen.owner;
    }
    return boxes_;
}

const MeasuredPrimitives& ListedFrames::measuredPrimitives(const Representation& r, const SceneView& seen) {
    if (!seen.owner || measured_.lock() != seen.owner) {
        sizes_ = measurePrimitives(r);
        measured_ = seen.owner;
    }
    return sizes_;
}

std::shared_ptr<const TileFrame> ListedFrames::prepare(const Representation& r, const SceneView& seen, const View& view,
                                                       graph::Extent image, TileWork work) {
    const std::shared_ptr<ListedFrame>& free = frames_.free();
    ListedFrame& frame = *free;
    const std::uint32_t firstTriangle = seen.constants.spheres + seen.constants.cylinders;
    listCalls(seen, seen.copies.spheres, 0, spheres_);
    listCalls(seen, seen.copies.cylinders, seen.constants.spheres, cylinders_);
    listCalls(seen, seen.copies.triangles, firstTriangle, triangles_);
    const SphereBoxes* boxes = work.frontSpheres ? &sceneBoxes(r, seen) : nullptr;
    const TileScenery scenery{r.spheres,      spheres_,   r.cylinders,       cylinders_, r.wires, r.triangles,
                              r.meshVertices, triangles_, r.coarseTriangles, r.meshes,   boxes,   work.triangleChunks};
    TileView asked = tileView(seen, view, image, !work.edges && !work.subsamples);
    asked.layers = work.kept;
    asked.edges = work.edges;
    asked.small = work.edges ? static_cast<float>(kSmallPixels) : 0.0f;
    asked.mask = work.mask;
    frame.tooMany = false;
    // An empty scene has no buffers to list from.
    if (spheres_.empty() && cylinders_.empty() && triangles_.empty()) work.byDevice = false;
    if (work.byDevice) {
        const std::uint64_t bins =
            TileBins::pixels(image.width, image.height) / (TileBins::kPixels * TileBins::kPixels);
        const MeasuredPrimitives& sizes = measuredPrimitives(r, seen);
        const std::uint64_t most = boundEntries(seen, sizes.largest, bins);
        const std::uint64_t primitives =
            seen.copies.sphereCount() + seen.copies.cylinderCount() + seen.copies.triangleCount();
        const std::uint32_t room = device_.caps().tiles.entries;
        const ListRounds rounds = planRounds(most, std::min(most, primitives), room);
        // Samples of edges look at the lists of all bins.
        frame.tooMany = rounds.count == 0 || (rounds.count > 1 && work.edges);
        if (frame.tooMany) return free;
        frame.lists.cover(asked);
        uploadCalls(frame, asked.small, std::min<std::uint64_t>(most, room),
                    chooseShare(boundEntries(seen, sizes.mean, bins), primitives));
        frame.byDevice->rounds = rounds;
    } else {
        frame.byDevice = nullptr;
        frame.lists.build(asked, scenery);
        if (frame.lists.longest() > work.longestList) return free;
    }
    const std::uint32_t walks = seen.rims.any() ? 2 : 1;
    frame.groups = work.byDevice ? static_cast<std::uint32_t>(frame.lists.tiles().size())
                                 : groupsOfTiles(frame.lists, work.shaded, walks, device_.caps().tiles.longestList);
    frame.copies = !r.copies.transforms.empty();
    frame.constants = makeConstants(seen.constants, seen.copies, frame.lists);
    frame.shaded = work.shaded;
    frame.cleared = work.shaded && !work.byDevice && (!r.cylinders.empty() || !r.wires.empty() || !r.triangles.empty());
    upload(frame, seen.copies, image, work.kept);
    frame.edgeData.drawn = work.edges;
    frame.edgeData.everywhere = seen.smallestPixels < kSmallPixels;
    // A surface at grazing angles has triangles that no pixel centre hits, and an outline may be narrower than a pixel.
    frame.edgeData.listed =
        seen.smallestPixels < kLargePixels || !r.triangles.empty() || seen.constants.contourWidth > 0;
    if (frame.edgeData.drawn) uploadEdges(frame, image, work.shaded ? work.places : nullptr);
    frame.edgeData.alone = work.edgesAlone;
    return free;
}

void reserve(const gpu::Device& device, TileBuffer& b, std::size_t bytes, vk::BufferUsageFlags usage, vk::Format format,
             const char* name) {
    if (*b.buffer.handle && b.buffer.size >= bytes) return;
    const std::size_t room = *b.buffer.handle ? bytes + bytes / 2 : bytes;  // a rotating scene may soon need more
    b = {};
    b.buffer = gpu::makeBuffer(device, room, usage, gpu::Access::upload, name);
    if (!device.caps().tiles.texels) return;
    if (format != vk::Format::eUndefined) b.texels = gpu::makeTexelView(device, b.buffer, format, name);
}

/// Tiles are drawn where something may be visible. Elsewhere words of earlier frames are cleared.
void ListedFrames::prepareWords(PixelWords& words, const TileLists& lists, graph::Extent image, std::uint32_t kept,
                                bool all, bool clears, const char* name) const {
    constexpr std::size_t kBin = TileLists::kBinPixels;
    const std::size_t bytes = 4 * kept * TileBins::pixels(image.width, image.height);
    const bool grows = words.buffer.size < bytes;
    if (grows) words.quads = nullptr, words.picture = nullptr;
    reserve(device_, words, bytes, kReadByTiles | Usage::eTransferSrc, vk::Format::eR32Uint, name);
    if (grows && device_.caps().tiles.texels)
        words.quads = gpu::makeTexelView(device_, words.buffer, vk::Format::eR32G32B32A32Uint, name);
    // Where streams are storage buffers, passes that read the picture still read texels.
    if (grows && device_.caps().tiles.shade && !device_.caps().tiles.texels)
        words.picture = gpu::makeTexelView(device_, words.buffer, vk::Format::eR32Uint, name);
    if (!clears) return;
    if (grows || words.across != lists.across()) {
        words.written.clear();
        words.across = lists.across();
        words.cleared = 0;
    }
    if (words.cleared < bytes) {  // only the used part of a buffer that has room to grow
        std::memset(words.buffer.mapped + words.cleared, 0, bytes - words.cleared);
        words.cleared = bytes;
    }
    const std::size_t pitch = kept * lists.across() * kBin;
    auto* pixels = reinterpret_cast<std::uint32_t*>(words.buffer.mapped);
    for (const TileLists::Span& s : words.written)
        for (std::size_t x = s.x; x < s.endX; ++x) {
            const std::size_t bin = s.y * std::size_t{lists.across()} + x;
            if (s.y < lists.down() && lists.holds(bin)) continue;
            for (std::size_t y = s.y * kBin; y < (s.y + 1) * kBin; ++y)
                std::fill_n(pixels + y * pitch + kept * x * kBin, kept * kBin, 0u);
        }
    words.written.assign(lists.spans().begin(), lists.spans().end());
    if (all)
        for (const TileLists::Span& s : words.written)
            for (std::size_t y = s.y * kBin; y < (s.y + std::size_t{1}) * kBin; ++y)
                std::fill_n(pixels + y * pitch + kept * s.x * kBin, kept * (s.endX - s.x) * kBin, 0u);
    if (!lists.masked()) return;
    constexpr std::size_t kTile = TileLists::kTilePixels;
    for (const TileLists::Span& s : words.written)
        for (std::uint32_t y = s.y * TileLists::kTilesInBin; y < s.endY * TileLists::kTilesInBin; ++y)
            for (std::uint32_t x = s.x * TileLists::kTilesInBin; x < s.endX * TileLists::kTilesInBin; ++x) {
                if (lists.draws(x, y)) continue;
                for (std::size_t row = y * kTile; row < (y + 1) * kTile; ++row)
                    std::fill_n(pixels + row * pitch + kept * x * kTile, kept * kTile, 0u);
            }
}

/// Writes each pixel's initial triangle, if the device reads it. The device replaces it by its result.
void ListedFrames::writeSeeds(ListedFrame& f) {
    constexpr std::uint32_t kBin = TileLists::kBinPixels;
    auto* words = reinterpret_cast<std::uint32_t*>(f.numbers.buffer.mapped);
    const std::size_t pitch = std::size_t{f.lists.across()} * kBin;
    constexpr std::size_t kSlice = 32;
    const std::span<const TileLists::Span> spans = f.lists.spans();
    inParallel((spans.size() + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, spans.size()); ++i) {
            const TileLists::Span& s = spans[i];
            for (std::uint32_t y = s.y * kBin; y < (s.y + 1u) * kBin; ++y)
                f.lists.writeSeeds(s.x * kBin, y, (s.endX - s.x) * kBin, words + y * pitch + s.x * kBin);
        }
    });
}

void ListedFrames::upload(ListedFrame& f, const PlacedCopies& copies, graph::Extent image, std::uint32_t kept) const {
    TileLists& lists = f.lists;
    const std::size_t rowBytes = copies.rows.size() * sizeof(glm::vec4);
    if (!f.byDevice) reserve(device_, f.words, 4 * lists.words(), kReadByTiles, vk::Format::eR32Uint, "lists of tiles");
    reserve(device_, f.rows, rowBytes, kReadByTiles, vk::Format::eR32G32B32A32Sfloat, "copies");
    prepareWords(f.numbers, lists, image, kept, f.cleared && !lists.seeded(), !f.byDevice, "primitive numbers");
    if (lists.seeded()) writeSeeds(f);
    reserve(device_, f.spanVertices, lists.spans().size() * sizeof(TileSpanVertex), Usage::eVertexBuffer,
            vk::Format::eUndefined, "rows of tiles");

    if (!f.byDevice) lists.write(reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped));
    std::memcpy(f.rows.buffer.mapped, copies.rows.data(), rowBytes);
    auto* spans = reinterpret_cast<TileSpanVertex*>(f.spanVertices.buffer.mapped);
    const glm::vec2 ndc = 2.0f * TileLists::kBinPixels / glm::vec2(image.width, image.height);
    for (const TileLists::Span& s : lists.spans())
        *spans++ = {glm::vec4(glm::vec2(s.x, s.y) * ndc, glm::vec2(s.endX, s.endY) * ndc) - 1.0f};
}

/// Uploads what the device lists: the calls, and the tiles if they are not the last frame's.
/// @param small  as in TileView @param room  for entries @param share  chooseShare()
void ListedFrames::uploadCalls(ListedFrame& f, float small, std::uint64_t room, std::uint32_t share) const {
    if (!f.byDevice) f.byDevice = std::make_unique<ListsByDevice>();
    ListsByDevice& d = *f.byDevice;
    const std::size_t bins = std::size_t{f.lists.across()} * f.lists.down();
    const std::size_t calls = spheres_.size() + cylinders_.size() + triangles_.size();
    reserve(device_, d.calls, 4 * (kCallsHeader + 2 * calls), Usage::eStorageBuffer, vk::Format::eUndefined, "calls");
    const std::size_t workBytes = 4 * (2 * bins + 2 * room), listBytes = 4 * (f.lists.words() + room);
    const bool grows = f.words.buffer.size < listBytes;
    if (d.work.buffer.size < workBytes || d.across != f.lists.across() || d.down != f.lists.down()) {
        reserve(device_, d.work, workBytes, Usage::eStorageBuffer, vk::Format::eUndefined, "primitives of bins");
        std::memset(d.work.buffer.mapped, 0, 4 * bins);
    }
    reserve(device_, f.words, listBytes, kReadByTiles, vk::Format::eR32Uint, "lists of tiles");
    if (f.lists.masked() || grows || d.across != f.lists.across() || d.down != f.lists.down())
        f.lists.writeTiles(reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped));
    d.across = f.lists.masked() ? 0 : f.lists.across();
    d.down = f.lists.down();
    auto* to = reinterpret_cast<std::uint32_t*>(d.calls.buffer.mapped);
    std::uint32_t* call = to + kCallsHeader;
    d.items = 0;
    for (const std::vector<TileCall>* list : {&spheres_, &cylinders_, &triangles_})
        for (const TileCall& c : *list) {
            *call++ = d.items;
            *call++ = c.number + c.first;
            d.items += c.count;
        }
    to[0] = static_cast<std::uint32_t>(calls);
    to[1] = d.items;
    to[2] = f.lists.down();
    std::memcpy(to + 3, &small, sizeof small);
    to[4] = d.share = share;
}

namespace {

/// Lists wanted pixels by non-empty bins, as the device does. @returns the number of groups
std::uint32_t listPlaces(const TileLists& lists, const EdgePlaces& places, std::uint32_t lanes, std::uint32_t* to) {
    constexpr std::uint32_t kBin = TileLists::kBinPixels;
    const auto down = static_cast<std::uint32_t>(places.pixels.size() / places.across);
    std::uint32_t listed = 0;
    for (const TileLists::Span& s : lists.spans())
        for (std::uint32_t bin = s.x; bin < s.endX; ++bin) {
            for (std::uint32_t y = s.y * kBin; y < std::min((s.y + 1) * kBin, down); ++y)
                for (std::uint32_t x = bin * kBin; x < std::min((bin + 1) * kBin, places.across); ++x)
                    if (places.pixels[std::size_t{y} * places.across + x] != 0) to[listed++] = x | y << 16;
            while (listed % lanes != 0) to[listed++] = layout::kNoEdge;
        }
    return listed / lanes;
}

}  // namespace

void ListedFrames::uploadEdges(ListedFrame& f, graph::Extent image, const EdgePlaces* places) const {
    const std::size_t pixels = TileBins::pixels(image.width, image.height);
    reserve(device_, f.edgeData.pixels, 4 * (layout::kEdgeHeader + pixels), kReadByTiles, vk::Format::eR32Uint,
            "edge pixels");
    if (f.shaded)
        prepareWords(f.edgeData.numbers, f.lists, image, 1, f.cleared, !f.byDevice, "primitive numbers");
    else
        reserve(device_, f.edgeData.colors, 8 * pixels, kReadByTiles, vk::Format::eR32G32Uint, "edge colours");
    auto* words = reinterpret_cast<std::uint32_t*>(f.edgeData.pixels.buffer.mapped);
    f.edgeData.placed = places != nullptr;
    words[0] = places ? listPlaces(f.lists, *places, device_.caps().tiles.lanes, words + layout::kEdgeHeader) : 0;
    words[1] = f.lists.down() * TileLists::kBinPixels;
    f.edgeData.groups = groupsOfEdges(f.lists, device_.caps().tiles, f.byDevice != nullptr);
}

}  // namespace nacre::passes
