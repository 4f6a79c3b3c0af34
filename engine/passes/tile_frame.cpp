#include "engine/passes/tile_frame.h"

#include <algorithm>
#include <cstring>

namespace nacre::passes {
namespace {

using Usage = vk::BufferUsageFlagBits;
constexpr auto kRead = Usage::eStorageBuffer | Usage::eUniformTexelBuffer;

/// Turns of all loops that lavapipe 22.3 grants an invocation are 65,535; it then leaves them and says nothing. One
/// goes by every entry, and as many again by the chunks.
constexpr std::uint32_t kLongestList = 28000;

TileView tileView(const SceneView& seen, const View& view, graph::Extent image) {
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
    return t;
}

}  // namespace

std::shared_ptr<const TileFrame> TileFrames::prepare(const Representation& r, const SceneView& seen, const View& view,
                                                     graph::Extent image) {
    auto free = std::find_if(frames_.begin(), frames_.end(), [](const auto& frame) { return frame.use_count() == 1; });
    if (free == frames_.end()) free = frames_.insert(free, std::make_shared<TileFrame>());
    TileFrame& frame = **free;
    const std::vector<TileCall> spheres = callsOf(seen, seen.copies.spheres, 0);
    const std::vector<TileCall> cylinders = callsOf(seen, seen.copies.cylinders, seen.constants.spheres);
    frame.lists.build(tileView(seen, view, image), r.spheres, spheres, r.cylinders, cylinders);
    if (frame.lists.longest() > kLongestList) return nullptr;
    frame.copies = !r.copies.transforms.empty();
    frame.constants = constantsOf(seen.constants, seen.copies, frame.lists);
    upload(frame, seen.copies, image);
    return *free;
}

void TileFrames::reserve(TileBuffer& b, std::size_t bytes, vk::BufferUsageFlags usage, vk::Format format,
                         const char* name) const {
    if (*b.buffer.handle && b.buffer.size >= bytes) return;
    const std::size_t room =
        *b.buffer.handle ? bytes + bytes / 2 : bytes;  // what turns may need more in its next frame
    b = {};
    b.buffer = gpu::makeBuffer(device_, room, usage, gpu::Access::upload, name);
    if (device_.caps().tiles.texels && format != vk::Format::eUndefined)
        b.texels = gpu::makeTexelView(device_, b.buffer, format, name);
}

void TileFrames::upload(TileFrame& f, const PlacedCopies& copies, graph::Extent image) const {
    TileLists& lists = f.lists;
    const std::size_t tiles = 2 * lists.tiles().size(), offsets = lists.offsets().size();
    const std::size_t rowBytes = copies.rows.size() * sizeof(glm::vec4);
    reserve(f.words, 4 * (tiles + offsets + lists.entries()), kRead, vk::Format::eR32Uint, "lists of tiles");
    reserve(f.rows, rowBytes, kRead, vk::Format::eR32G32B32A32Sfloat, "copies");
    reserve(f.numbers, 4 * TileLists::pixelsOfBins(image.width, image.height), kRead, vk::Format::eR32Uint,
            "primitive numbers");
    reserve(f.spans, lists.spans().size() * sizeof(TileSpanVertex), Usage::eVertexBuffer, vk::Format::eUndefined,
            "rows of tiles");

    auto* words = reinterpret_cast<std::uint32_t*>(f.words.buffer.mapped);
    for (const TileLists::Tile& tile : lists.tiles()) {
        *words++ = tile.x | std::uint32_t{tile.y} << 16;
        *words++ = tile.slot;
    }
    const auto base = static_cast<std::uint32_t>(tiles + offsets);
    words = std::transform(lists.offsets().begin(), lists.offsets().end(), words,
                           [&](std::uint32_t offset) { return base + offset; });
    lists.write(words);
    std::memcpy(f.rows.buffer.mapped, copies.rows.data(), rowBytes);
    auto* spans = reinterpret_cast<TileSpanVertex*>(f.spans.buffer.mapped);
    const glm::vec2 ndc = 2.0f * TileLists::kBinPixels / glm::vec2(image.width, image.height);
    for (const TileLists::Span& s : lists.spans())
        *spans++ = {glm::vec4(glm::vec2(s.x, s.y) * ndc, glm::vec2(s.endX, s.endY) * ndc) - 1.0f,
                    s.x * TileLists::kBinPixels, s.slot * TileLists::kTilePixels * TileLists::kTilePixels};
}

}  // namespace nacre::passes
