#include "engine/tiles/listed_frame.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "engine/threads.h"

namespace nacre::passes {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr auto kReadByTiles = Usage::eStorageBuffer | Usage::eUniformTexelBuffer;

/// Loop iterations of an invocation available for edges, and those used by a subgroup's pixels besides the list.
constexpr std::uint64_t kTurnsOfEdges = 60'000, kTurnsOfFilling = 48;

/// From this size on, a pixel's samples show almost only what the centres of the nine pixels around show.
constexpr double kLargePixels = 6;

layout::TileConstants makeConstants(const layout::ViewConstants& c, const PlacedCopies& copies, const TileSet& tiles) {
    layout::TileConstants t{};
    if (!copies.rows.empty()) t.row0 = copies.rows[0], t.row1 = copies.rows[1], t.row2 = copies.rows[2];
    t.origin = c.origin;
    t.primitives = c.primitives;
    t.axisPixel = c.axisPixel;
    t.pixel = c.pixel;
    t.depthStart = c.depthStart;
    t.perRange = c.perRange;
    t.spheres = c.spheres;
    t.across = tiles.across();
    t.offsets = static_cast<std::uint32_t>(tiles.tiles().size());
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
std::uint32_t groupsOfTiles(const ListedFrame& frame, std::uint32_t walks, std::uint32_t longestList) {
    constexpr std::uint32_t kMost = 16, kGroups = 64;  // tiles per group; groups that keep all processors busy
    const auto tiles = static_cast<std::uint32_t>(frame.tiles().tiles().size());
    if (frame.byDevice) return tiles;
    const std::uint32_t together = longestList / (walks * std::max(frame.host->longest(), 1u));
    const std::uint32_t ofGroup = frame.shaded() ? std::clamp(std::min(tiles / kGroups, together), 1u, kMost) : 1;
    return (tiles + ofGroup - 1) / ofGroup;
}

/// Maximum number of workgroups that draw edges. Each fills its lanes repeatedly: on a software device an empty
/// workgroup costs as much as a full one. No loop may exceed lavapipe's limit.
std::uint32_t groupsOfEdges(const ListedFrame& frame, const gpu::TileCaps& caps) {
    constexpr std::uint64_t kFew = 64, kRow = 65535;
    const std::size_t tiles = frame.tiles().tiles().size();
    const std::uint64_t fillings = tiles * (TileSet::kTilePixels * TileSet::kTilePixels / caps.lanes);
    if (frame.byDevice) return static_cast<std::uint32_t>(std::min(fillings, kRow));  // lists of unknown lengths
    const std::uint64_t turns = kTurnsOfFilling + std::uint64_t{frame.host->longest()} * 3 / 2;
    const std::uint64_t least = fillings * turns / kTurnsOfEdges + 1;
    return static_cast<std::uint32_t>(std::min(std::max(least, caps.texels ? kFew : tiles), kRow));
}

}  // namespace

std::unique_ptr<TileFrames> makeTileFrames(const gpu::Device& device, std::unique_ptr<HostLister> lister) {
    return std::make_unique<ListedFrames>(device, std::move(lister));
}

const MeasuredPrimitives& ListedFrames::measuredPrimitives(const Representation& r, const SceneView& seen) {
    if (!seen.owner || measured_.lock() != seen.owner) {
        sizes_ = measurePrimitives(r);
        measured_ = seen.owner;
    }
    return sizes_;
}

/// @returns false: there are more entries than may be listed
bool ListedFrames::prepareLists(ListedFrame& frame, const ListedView& v, const TileWork& work) {
    const PlacedCopies& copies = v.seen.copies;
    frame.tooMany = false;
    // An empty scene has no buffers to list from.
    const bool empty = copies.spheres.empty() && copies.cylinders.empty() && copies.triangles.empty();
    if (!work.byDevice || (empty && work.result != TileResult::image)) {
        frame.byDevice = nullptr;
        if (!frame.host) frame.host = lister_->makeLists();
        lister_->build(*frame.host, v, work);
        return frame.host->longest() <= work.longestList;
    }
    const std::uint64_t bins = TileBins::count(v.image.width, v.image.height);
    const MeasuredPrimitives& sizes = measuredPrimitives(v.representation, v.seen);
    const std::uint64_t most = boundEntries(v.seen, sizes.largest, bins);
    const std::uint64_t primitives = copies.sphereCount() + copies.cylinderCount() + copies.triangleCount();
    const std::uint32_t room = device_.caps().tiles.entries;
    const ListRounds rounds = planRounds(most, std::min(most, primitives), room);
    // Samples of edges look at the lists of all bins.
    frame.tooMany = rounds.count == 0 || (rounds.count > 1 && work.edges);
    if (frame.tooMany) return false;
    frame.covered.cover(v.image.width, v.image.height, work.mask);
    uploadCalls(frame, v.seen, work.small(), std::min<std::uint64_t>(most, room),
                chooseShare(boundEntries(v.seen, sizes.mean, bins), primitives));
    frame.byDevice->rounds = rounds;
    return true;
}

std::shared_ptr<const TileFrame> ListedFrames::prepare(const ListedView& v, TileWork work) {
    const std::shared_ptr<ListedFrame>& free = frames_.free();
    ListedFrame& frame = *free;
    const Representation& r = v.representation;
    const SceneView& seen = v.seen;
    if (!prepareLists(frame, v, work)) return free;
    frame.result = work.result;
    frame.groups = groupsOfTiles(frame, seen.rims.any() ? 2 : 1, device_.caps().tiles.longestList);
    frame.copies = !r.copies.transforms.empty();
    frame.constants = makeConstants(seen.constants, seen.copies, frame.tiles());
    frame.cleared =
        frame.shaded() && !frame.byDevice && (!r.cylinders.empty() || !r.wires.empty() || !r.triangles.empty());
    upload(frame, seen.copies, v.image);
    frame.edgeData.drawn = work.edges;
    frame.edgeData.everywhere = seen.smallestPixels < TileWork::kSmallPixels;
    // A surface at grazing angles has triangles that no pixel centre hits, and an outline may be narrower than a pixel.
    frame.edgeData.listed =
        seen.smallestPixels < kLargePixels || !r.triangles.empty() || seen.constants.contourWidth > 0;
    if (frame.edgeData.drawn) uploadEdges(frame, v.image, frame.shaded() ? work.places : nullptr);
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

/// Tiles are drawn where something may be visible. Elsewhere words of earlier frames are cleared, unless the device
/// makes the lists: it writes all pixels.
void ListedFrames::prepareWords(PixelWords& words, const ListedFrame& f, graph::Extent image, TileResult result,
                                const char* name) const {
    constexpr std::size_t kBin = TileSet::kBinPixels;
    const TileSet& tiles = f.tiles();
    const std::size_t bytes = 4 * pixelWords(result) * TileBins::pixels(image.width, image.height);
    const bool grows = words.buffer.size < bytes;
    if (grows) words.quads = nullptr, words.picture = nullptr;
    reserve(device_, words, bytes, kReadByTiles | Usage::eTransferSrc,
            result == TileResult::layers ? vk::Format::eR32G32Uint : vk::Format::eR32Uint, name);
    if (result == TileResult::layers) return;  // only drawn tiles are read, by one view
    if (grows && device_.caps().tiles.texels)
        words.quads = gpu::makeTexelView(device_, words.buffer, vk::Format::eR32G32B32A32Uint, name);
    // Where streams are storage buffers, passes that read the picture still read texels.
    if (grows && device_.caps().tiles.shade && !device_.caps().tiles.texels)
        words.picture = gpu::makeTexelView(device_, words.buffer, vk::Format::eR32Uint, name);
    if (f.byDevice) return;
    const std::size_t pitch = tiles.across() * kBin;
    auto* pixels = reinterpret_cast<std::uint32_t*>(words.buffer.mapped);
    const auto clear = [&](std::size_t x, std::size_t y, std::size_t across, std::size_t down) {
        for (std::size_t row = y; row < y + down; ++row) std::fill_n(pixels + row * pitch + x, across, 0u);
    };
    if (grows || words.across != tiles.across()) {
        words.written.clear();
        words.across = tiles.across();
        words.cleared = 0;
    }
    if (words.cleared < bytes) {  // only the used part of a buffer that has room to grow
        std::memset(words.buffer.mapped + words.cleared, 0, bytes - words.cleared);
        words.cleared = bytes;
    }
    for (const TileSet::Span& s : words.written)
        for (std::size_t x = s.x; x < s.endX; ++x)
            if (s.y >= tiles.down() || !f.holds(s.y * std::size_t{tiles.across()} + x))
                clear(x * kBin, s.y * kBin, kBin, kBin);
    words.written.assign(tiles.spans().begin(), tiles.spans().end());
    if (f.cleared && (&words != &f.numbers || !f.seeded()))
        for (const TileSet::Span& s : words.written) clear(s.x * kBin, s.y * kBin, (s.endX - s.x) * kBin, kBin);
    if (!tiles.masked()) return;
    constexpr std::size_t kTile = TileSet::kTilePixels;
    for (const TileSet::Span& s : tiles.spans())
        for (std::uint32_t y = s.y * TileSet::kTilesInBin; y < s.endY * TileSet::kTilesInBin; ++y)
            for (std::uint32_t x = s.x * TileSet::kTilesInBin; x < s.endX * TileSet::kTilesInBin; ++x)
                if (!tiles.draws(x, y)) clear(x * kTile, y * kTile, kTile, kTile);
}

/// Writes the primitive that each pixel begins with, if the device reads it.
void ListedFrames::writeSeeds(ListedFrame& f) {
    constexpr std::uint32_t kBin = TileSet::kBinPixels;
    auto* words = reinterpret_cast<std::uint32_t*>(f.numbers.buffer.mapped);
    const std::size_t pitch = std::size_t{f.tiles().across()} * kBin;
    constexpr std::size_t kSlice = 32;
    const std::span<const TileSet::Span> spans = f.tiles().spans();
    inParallel((spans.size() + kSlice - 1) / kSlice, [&](std::size_t slice) {
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, spans.size()); ++i) {
            const TileSet::Span& s = spans[i];
            for (std::uint32_t y = s.y * kBin; y < (s.y + 1u) * kBin; ++y)
                f.host->writeSeeds(s.x * kBin, y, (s.endX - s.x) * kBin, words + y * pitch + s.x * kBin);
        }
    });
}

void ListedFrames::upload(ListedFrame& f, const PlacedCopies& copies, graph::Extent image) const {
    const std::size_t rowBytes = copies.rows.size() * sizeof(glm::vec4);
    reserve(device_, f.rows, rowBytes, kReadByTiles, vk::Format::eR32G32B32A32Sfloat, "copies");
    std::memcpy(f.rows.buffer.mapped, copies.rows.data(), rowBytes);
    if (f.result == TileResult::image) return;
    if (!f.byDevice) {
        reserve(device_, f.words, 4 * f.host->words(), kReadByTiles, vk::Format::eR32Uint, "lists of tiles");
        f.host->write(reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped));
    }
    prepareWords(f.numbers, f, image, f.result,
                 f.result == TileResult::layers ? "colours of layers" : "primitive numbers");
    if (f.seeded()) writeSeeds(f);
    const bool masked = f.result == TileResult::layers && f.tiles().masked();
    const std::vector<TileSet::Span> rows = masked ? f.tiles().drawnRows() : std::vector<TileSet::Span>();
    const std::span<const TileSet::Span> drawn = masked ? rows : f.tiles().spans();
    const float side = masked ? TileSet::kTilePixels : TileSet::kBinPixels;
    f.rowCount = static_cast<std::uint32_t>(drawn.size());
    reserve(device_, f.spanVertices, drawn.size() * sizeof(TileSpanVertex), Usage::eVertexBuffer,
            vk::Format::eUndefined, "rows of tiles");
    auto* spans = reinterpret_cast<TileSpanVertex*>(f.spanVertices.buffer.mapped);
    const glm::vec2 ndc = 2.0f * side / glm::vec2(image.width, image.height);
    for (const TileSet::Span& s : drawn)
        *spans++ = {glm::vec4(glm::vec2(s.x, s.y) * ndc, glm::vec2(s.endX, s.endY) * ndc) - 1.0f};
}

/// Uploads what the device lists: the calls, and the tiles if they are not the last frame's.
/// @param small  TileWork::small() @param room  for entries @param share  chooseShare()
void ListedFrames::uploadCalls(ListedFrame& f, const SceneView& seen, float small, std::uint64_t room,
                               std::uint32_t share) const {
    if (!f.byDevice) f.byDevice = std::make_unique<ListsByDevice>();
    ListsByDevice& d = *f.byDevice;
    const TileSet& tiles = f.covered;
    const PlacedCopies& copies = seen.copies;
    const std::size_t bins = std::size_t{tiles.across()} * tiles.down();
    const std::size_t calls = copies.spheres.size() + copies.cylinders.size() + copies.triangles.size();
    reserve(device_, d.calls, 4 * (kCallsHeader + 2 * calls), Usage::eStorageBuffer, vk::Format::eUndefined, "calls");
    const std::size_t workBytes = 4 * (2 * bins + 2 * room), listBytes = 4 * tiles.words(room);
    const bool grows = f.words.buffer.size < listBytes;
    if (d.work.buffer.size < workBytes || d.across != tiles.across() || d.down != tiles.down()) {
        reserve(device_, d.work, workBytes, Usage::eStorageBuffer, vk::Format::eUndefined, "primitives of bins");
        std::memset(d.work.buffer.mapped, 0, 4 * bins);
    }
    reserve(device_, f.words, listBytes, kReadByTiles, vk::Format::eR32Uint, "lists of tiles");
    if (tiles.masked() || grows || d.across != tiles.across() || d.down != tiles.down())
        tiles.writeTiles(reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped));
    d.across = tiles.masked() ? 0 : tiles.across();
    d.down = tiles.down();
    auto* to = reinterpret_cast<std::uint32_t*>(d.calls.buffer.mapped);
    std::uint32_t* call = to + kCallsHeader;
    d.items = 0;
    const auto list = [&](const std::vector<PlacedCopies::Call>& all, std::uint32_t before) {
        for (const PlacedCopies::Call& c : all) {
            *call++ = d.items;
            *call++ = c.copy * seen.constants.primitives + before + c.first + 1;
            d.items += c.count;
        }
    };
    list(copies.spheres, 0);
    list(copies.cylinders, seen.constants.spheres);
    list(copies.triangles, seen.constants.spheres + seen.constants.cylinders);
    to[0] = static_cast<std::uint32_t>(calls);
    to[1] = d.items;
    to[2] = tiles.down();
    std::memcpy(to + 3, &small, sizeof small);
    to[4] = d.share = share;
}

namespace {

/// Lists wanted pixels by non-empty bins, as the device does. @returns the number of groups
std::uint32_t listPlaces(const TileSet& tiles, const EdgePlaces& places, std::uint32_t lanes, std::uint32_t* to) {
    constexpr std::uint32_t kBin = TileSet::kBinPixels;
    const auto down = static_cast<std::uint32_t>(places.pixels.size() / places.across);
    std::uint32_t listed = 0;
    for (const TileSet::Span& s : tiles.spans())
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
    if (f.shaded())
        prepareWords(f.edgeData.numbers, f, image, TileResult::words, "primitive numbers");
    else
        reserve(device_, f.edgeData.colors, 8 * pixels, kReadByTiles, vk::Format::eR32G32Uint, "edge colours");
    auto* words = reinterpret_cast<std::uint32_t*>(f.edgeData.pixels.buffer.mapped);
    f.edgeData.placed = places != nullptr;
    words[0] = places ? listPlaces(f.tiles(), *places, device_.caps().tiles.lanes, words + layout::kEdgeHeader) : 0;
    words[1] = f.tiles().down() * TileSet::kBinPixels;
    f.edgeData.groups = groupsOfEdges(f, device_.caps().tiles);
}

}  // namespace nacre::passes
