#include "engine/passes/tile_frame.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace nacre::passes {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr auto kRead = Usage::eStorageBuffer | Usage::eUniformTexelBuffer;

/// The same where edges are drawn: a tile may be gone through eight times.
constexpr std::uint32_t kLongestListOfEdges = 6000;

/// Half a width in pixels below which a primitive may be seen by none of the pixels about it.
constexpr double kSmallPixels = 0.75;

TileView tileView(const SceneView& seen, const View& view, graph::Extent image, TileWork work) {
    const layout::ViewConstants& c = seen.constants;
    TileView v;
    v.width = image.width;
    v.height = image.height;
    v.perspective = seen.perspective;
    v.quarterTurns = seen.quarterTurns;
    v.axis = c.axisPixel;
    v.pixels = static_cast<float>(view.pixelsPerAngstrom);
    v.origin = c.origin;
    v.nearest = c.depthStart;
    v.range = 1.0f / c.perRange;
    if (seen.effects.clip.on()) v.clipNear = c.clipNear, v.clipFar = c.clipFar;
    v.contour = c.contourWidth;
    v.centers = !work.edges;
    v.layers = work.kept;
    return v;
}

std::vector<TileCall> callsOf(const SceneView& seen, const std::vector<PlacedCopies::Call>& calls,
                              std::uint32_t first) {
    std::vector<TileCall> list;
    list.reserve(calls.size());
    for (const PlacedCopies::Call& c : calls)
        list.push_back({&seen.copies.rows[3 * std::size_t{c.copy}], c.first, c.count,
                        c.copy * seen.constants.primitives + first + 1});
    return list;
}

layout::TileConstants constantsOf(const layout::ViewConstants& c, const PlacedCopies& copies, const TileLists& lists) {
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
    t.offsets = static_cast<std::uint32_t>(2 * lists.tiles().size());
    t.depthStep = 2.0f / TileLists::kDepthSteps;
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

}  // namespace

TileCounts countsOf(const TileLists& lists) {
    return {lists.tiles().size(), lists.kept(), lists.keptSpheres(), lists.entries(), lists.longest()};
}

std::shared_ptr<const TileFrame> TileFrames::prepare(const Representation& r, const SceneView& seen, const View& view,
                                                     graph::Extent image, TileWork work) {
    auto free = std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame.use_count() == 1; });
    if (free == frames_.end()) free = frames_.insert(free, std::make_shared<TileFrame>());
    TileFrame& frame = **free;
    const std::vector<TileCall> spheres = callsOf(seen, seen.copies.spheres, 0);
    const std::vector<TileCall> cylinders = callsOf(seen, seen.copies.cylinders, seen.constants.spheres);
    const std::vector<TileCall> triangles =
        callsOf(seen, seen.copies.triangles, seen.constants.spheres + seen.constants.cylinders);
    const TileScenery scenery{r.spheres, spheres, r.cylinders, cylinders, r.triangles, r.meshVertices, triangles};
    frame.lists.build(tileView(seen, view, image, work), scenery);
    if (frame.lists.longest() > kLongestListOfEdges && std::exchange(work.edges, false) && !triangles.empty())
        frame.lists.build(tileView(seen, view, image, work), scenery);
    if (frame.lists.longest() > kLongestList) return nullptr;
    frame.copies = !r.copies.transforms.empty();
    frame.constants = constantsOf(seen.constants, seen.copies, frame.lists);
    frame.shaded = work.shaded;
    upload(frame, seen.copies, image, work.kept);
    clearColors(frame);
    frame.edges.drawn = work.edges;
    frame.edges.everywhere = seen.smallestPixels < kSmallPixels;
    if (frame.edges.drawn) uploadEdges(frame, image);
    return *free;
}

void reserve(const gpu::Device& device, TileBuffer& b, std::size_t bytes, vk::BufferUsageFlags usage, vk::Format format,
             const char* name) {
    if (*b.buffer.handle && b.buffer.size >= bytes) return;
    const std::size_t room =
        *b.buffer.handle ? bytes + bytes / 2 : bytes;  // what turns may need more in its next frame
    b = {};
    b.buffer = gpu::makeBuffer(device, room, usage, gpu::Access::upload, name);
    if (device.caps().tiles.texels && format != vk::Format::eUndefined)
        b.texels = gpu::makeTexelView(device, b.buffer, format, name);
}

/// Tiles are drawn where something may show. Elsewhere the colours of the frame before go.
void TileFrames::clearColors(TileFrame& f) {
    constexpr std::size_t kBin = TileLists::kBinPixels;
    const TileLists& lists = f.lists;
    const std::size_t pitch = lists.across() * kBin;
    auto* colors = reinterpret_cast<std::uint32_t*>(f.numbers.buffer.mapped);
    if (!f.shaded || f.coloredAcross != lists.across()) {
        f.colored.clear();
        f.coloredAcross = f.shaded ? lists.across() : 0;
        if (f.shaded) std::memset(colors, 0, f.numbers.buffer.size);
    }
    for (const TileLists::Span& s : f.colored)
        for (std::size_t x = s.x; x < s.endX; ++x) {
            const std::size_t bin = s.y * std::size_t{lists.across()} + x;
            if (s.y < lists.down() && lists.offsets()[bin] != lists.offsets()[bin + 1]) continue;
            for (std::size_t y = s.y * kBin; y < (s.y + 1) * kBin; ++y)
                std::fill_n(colors + y * pitch + x * kBin, kBin, 0u);
        }
    if (f.shaded) f.colored.assign(lists.spans().begin(), lists.spans().end());
}

void TileFrames::upload(TileFrame& f, const PlacedCopies& copies, graph::Extent image, std::uint32_t kept) const {
    TileLists& lists = f.lists;
    const std::size_t rowBytes = copies.rows.size() * sizeof(glm::vec4);
    reserve(device_, f.words, 4 * lists.words(), kRead, vk::Format::eR32Uint, "lists of tiles");
    reserve(device_, f.rows, rowBytes, kRead, vk::Format::eR32G32B32A32Sfloat, "copies");
    const auto before = f.numbers.buffer.size;
    reserve(device_, f.numbers, 4 * kept * TileLists::pixelsOfBins(image.width, image.height),
            kRead | Usage::eTransferSrc, vk::Format::eR32Uint, "primitive numbers");
    // A new buffer is larger; its handle may be the old one again.
    if (f.numbers.buffer.size != before) f.coloredAcross = 0;
    reserve(device_, f.spans, lists.spans().size() * sizeof(TileSpanVertex), Usage::eVertexBuffer,
            vk::Format::eUndefined, "rows of tiles");

    lists.write(reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped));
    std::memcpy(f.rows.buffer.mapped, copies.rows.data(), rowBytes);
    auto* spans = reinterpret_cast<TileSpanVertex*>(f.spans.buffer.mapped);
    const glm::vec2 ndc = 2.0f * TileLists::kBinPixels / glm::vec2(image.width, image.height);
    for (const TileLists::Span& s : lists.spans())
        *spans++ = {glm::vec4(glm::vec2(s.x, s.y) * ndc, glm::vec2(s.endX, s.endY) * ndc) - 1.0f,
                    s.x * TileLists::kBinPixels, s.slot * TileLists::kTilePixels * TileLists::kTilePixels};
}

void TileFrames::uploadEdges(TileFrame& f, graph::Extent image) const {
    const TileLists& lists = f.lists;
    const std::size_t across = lists.across() + 2, bins = across * (lists.down() + 2);
    reserve(device_, f.edges.slots, 4 * bins, kRead, vk::Format::eR32Uint, "tiles of bins");
    if (f.shaded)
        reserve(device_, f.edges.numbers, 4 * TileLists::pixelsOfBins(image.width, image.height), kRead,
                vk::Format::eR32Uint, "primitive numbers");
    else
        reserve(device_, f.edges.colors, 8 * TileLists::pixelsOfBins(image.width, image.height), kRead,
                vk::Format::eR32G32Uint, "edge colours");
    auto* slots = reinterpret_cast<std::uint32_t*>(f.edges.slots.buffer.mapped);
    std::fill_n(slots, bins, layout::kNoEdge);
    constexpr std::uint32_t kTilesOfBin = TileLists::kTilesInBin * TileLists::kTilesInBin;
    for (const TileLists::Span& s : lists.spans())
        for (std::uint32_t x = s.x; x < s.endX; ++x)
            slots[(s.y + 1) * across + x + 1] = s.slot + (x - s.x) * kTilesOfBin;
}

}  // namespace nacre::passes
