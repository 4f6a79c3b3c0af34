#include "engine/software/tile_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/threads.h"

namespace nacre {
namespace {

struct VertexRange {
    std::size_t first = SIZE_MAX, end = 0;
    void add(const VertexRange& other) {
        first = std::min(first, other.first);
        end = std::max(end, other.end);
    }
};

/// Vertices of a call's triangles. If most of a mesh is drawn, its known range.
VertexRange findVertices(const TileScenery& s, const TileCall& call) {
    constexpr std::uint32_t kFew = 8;  // for a smaller share of a mesh, its triangles are searched
    for (const MeshRun& mesh : s.meshes) {
        const auto within = [&](std::uint32_t first, std::uint32_t count) {
            return call.first >= first && call.first + call.count <= first + count && call.count >= count / kFew;
        };
        if (within(mesh.first, mesh.count)) return {mesh.firstVertex, mesh.endVertex};
        for (const MeshRun::Level& level : mesh.levels)
            if (within(static_cast<std::uint32_t>(s.triangles.size()) + level.first, level.count))
                return {mesh.firstVertex, level.endVertex};
    }
    VertexRange range;
    for (const Triangle& t : s.callTriangles(call))
        range.add({std::min({t.a, t.b, t.c}), std::max({t.a, t.b, t.c}) + std::size_t{1}});
    return range;
}

/// End of the triangles of the mesh, or level, that contains this one; 0: none.
std::uint32_t endOfMesh(const TileScenery& s, std::uint32_t triangle) {
    for (const MeshRun& mesh : s.meshes) {
        const auto has = [&](std::uint32_t first, std::uint32_t count) {
            return triangle >= first && triangle - first < count;
        };
        if (has(mesh.first, mesh.count)) return mesh.first + mesh.count;
        for (const MeshRun::Level& level : mesh.levels) {
            const std::uint32_t first = static_cast<std::uint32_t>(s.triangles.size()) + level.first;
            if (has(first, level.count)) return first + level.count;
        }
    }
    return 0;
}

/// Whether any pixel centre is inside a box, with a margin for shaders' rounding.
bool holdsCenter(glm::vec2 low, glm::vec2 high) {
    constexpr float kRoom = 1.0f / 32;
    const auto along = [](float from, float to) { return std::floor(to - 0.5f + kRoom) >= from - 0.5f - kRoom; };
    return along(low.x, high.x) && along(low.y, high.y);
}

/// Radius of a wire, as in shaders/common/hit.glsl, slightly enlarged.
float wireRadius(const TileView& view, float stored, float z) {
    if (stored >= 0) return stored;
    const float atOrigin = -stored * view.wireScale / view.pixels * 1.001f;
    return view.perspective ? atOrigin * (view.origin - z) / view.origin : atOrigin;
}

}  // namespace

void TileLists::add(const TileView& view, std::uint32_t number, glm::vec2 low, glm::vec2 high, float near,
                    std::vector<Kept>& kept) const {
    constexpr float kBin = 1.0f / kBinPixels;
    // Pixels are sampled at their centres: half a pixel of margin at the bins' edges covers rounding.
    const float x0 = low.x * kBin, y0 = low.y * kBin, x1 = high.x * kBin, y1 = high.y * kBin;
    if (!(x1 >= 0) || !(y1 >= 0) || !(x0 < static_cast<float>(across_)) || !(y0 < static_cast<float>(down_))) return;
    Kept k;
    k.number = number;
    k.x = static_cast<std::uint16_t>(std::max(x0, 0.0f));
    k.y = static_cast<std::uint16_t>(std::max(y0, 0.0f));
    k.endX = static_cast<std::uint16_t>(std::min(x1 + 1.0f, static_cast<float>(across_)));
    k.endY = static_cast<std::uint16_t>(std::min(y1 + 1.0f, static_cast<float>(down_)));
    if (masked() && !drawsAny(k)) return;
    k.step = static_cast<std::uint32_t>(
        std::clamp((near - view.nearest) * (kDepthSteps / view.range), 0.0f, static_cast<float>(kDepthSteps - 1)));
    kept.push_back(k);
}

/// A sphere or a cylinder. @param reach  half of its width, pixels
void TileLists::addRound(const TileView& view, std::uint32_t number, glm::vec2 low, glm::vec2 high, float near,
                         float reach) {
    const std::size_t before = kept_.size();
    add(view, number, low, high, near, kept_);
    if (reach < view.small && kept_.size() > before) small_.push_back(static_cast<std::uint32_t>(before));
}

void TileLists::addSpheres(const TileView& view, std::span<const Sphere> spheres, const TileCall& call) {
    for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
        const glm::vec3 center = placed(call.rows, spheres[i].center);
        const float Z = view.origin - center.z, radius = spheres[i].radius;
        if (Z + radius < view.clipNear || Z - radius > view.clipFar) continue;
        const Disc disc = boundingDisc(view, center, outlinedRadius(view, center.z, radius));
        const glm::vec2 at = toPixel(view, disc.center);
        const float reach = disc.radius * view.pixels;
        addRound(view, call.number + i, at - reach, at + reach, Z - radius, reach);
    }
}

void TileLists::addCylinders(const TileView& view, const TileScenery& s, const TileCall& call) {
    for (std::uint32_t i = call.first; i < call.first + call.count; ++i) {
        const Cylinder& c = i < s.cylinders.size() ? s.cylinders[i] : s.wires[i - s.cylinders.size()];
        const glm::vec3 a = placed(call.rows, c.a), b = placed(call.rows, c.b);
        const float radius = wireRadius(view, c.radius, 0.5f * (a.z + b.z));
        const Disc da = boundingDisc(view, a, outlinedRadius(view, a.z, radius)),
                   db = boundingDisc(view, b, outlinedRadius(view, b.z, radius));
        const glm::vec2 pa = toPixel(view, da.center), pb = toPixel(view, db.center);
        const float ra = da.radius * view.pixels, rb = db.radius * view.pixels;
        addRound(view, call.number + i, glm::min(pa - ra, pb - rb), glm::max(pa + ra, pb + rb),
                 view.origin - std::max(a.z, b.z) - radius, std::min(ra, rb));
    }
}

std::vector<TileLists::MeshPart> TileLists::meshParts(const TileScenery& s) {
    std::vector<MeshPart> parts;
    for (const TileCall& call : s.triangleCalls) {
        const std::span<const Triangle> triangles = s.callTriangles(call);
        for (std::uint32_t first = 0, end = 0; end < call.count; first = end) {
            const float step = triangles[first].step();
            if (const std::uint32_t mesh = endOfMesh(s, call.first + first); mesh != 0)
                end = std::min(call.count, mesh - call.first);  // a mesh has one depth step
            while (end < call.count && triangles[end].step() == step) ++end;
            if (parts.empty() || parts.back().rows != call.rows || parts.back().step != step)
                parts.push_back({call.rows, step, {}});
            parts.back().calls.push_back({call.rows, call.first + first, end - first, call.number});
        }
    }
    return parts;
}

/// Places the vertices of triangles in the picture: pixels and Z.
void TileLists::placeCorners(const TileView& view, const TileScenery& s, const MeshPart& part) {
    corners_.resize(s.vertices.size());
    const CornerPlace place(view, part.rows);
    const auto placeRange = [&](const VertexRange& range) {
        constexpr std::size_t kSlice = 16384, kWidest = 16;
        if (range.first >= range.end) return;
        inParallel((range.end - range.first) / kSlice + 1, [&](std::size_t slice) {
            const std::size_t first = range.first + slice * kSlice, end = std::min(first + kSlice, range.end);
            const std::size_t some = (end - first) / kWidest * kWidest;
            lanes_.place(place, &s.vertices[first], some, part.step, &corners_[first]);
            for (std::size_t i = first + some; i < end; ++i)
                corners_[i] = place(decodePosition(s.vertices[i], part.step));
        });
    };
    VertexRange range;  // of neighbouring calls
    for (const TileCall& call : part.calls) {
        const VertexRange next = findVertices(s, call);
        if (next.first > range.end || range.first > next.end) placeRange(std::exchange(range, {}));
        range.add(next);
    }
    placeRange(range);
}

void TileLists::addTriangle(const TileView& view, std::uint32_t number, const glm::vec3& a, const glm::vec3& b,
                            const glm::vec3& c, std::vector<Kept>& kept) const {
    constexpr float kRoom = 1e-3f;  // Å, for rounding of Z
    const float outside = view.contour * view.pixels;
    const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    if (high.z + kRoom < view.clipNear || low.z - kRoom > view.clipFar) return;
    const glm::vec2 from = glm::vec2(low) - outside, to = glm::vec2(high) + outside;
    if (view.centers && !holdsCenter(from, to)) return;
    add(view, number, from, to, low.z - kRoom, kept);
}

void TileLists::addTriangles(const TileView& view, const TileScenery& s) {
    for (const MeshPart& part : meshParts(s)) {
        placeCorners(view, s, part);
        for (const TileCall& call : part.calls) {
            std::uint32_t number = call.number + call.first;
            for (const Triangle& t : s.callTriangles(call))
                addTriangle(view, number++, corners_[t.a], corners_[t.b], corners_[t.c], kept_);
        }
    }
}

void TileLists::addFrontTriangles(const TileView& view, const TileScenery& s) {
    front_.begin(view);
    const std::vector<MeshPart> parts = meshParts(s);
    for (const MeshPart& part : parts) {
        placeCorners(view, s, part);
        runs_.clear();
        for (const TileCall& call : part.calls)
            runs_.push_back({s.callTriangles(call), call.rows, call.number + call.first, s.callChunks(call),
                             call.first % Chunk::kPrimitives});
        front_.draw(runs_, corners_);
    }
    front_.end();
    // They are scattered in memory, so that fetching them takes longest.
    constexpr std::size_t kSlice = 2048;
    const std::size_t slices = (front_.ambiguous() + kSlice - 1) / kSlice;
    keptOfSlices_.resize(std::max(keptOfSlices_.size(), slices));
    inParallel(slices, [&](std::size_t slice) {
        keptOfSlices_[slice].clear();
        for (std::size_t i = slice * kSlice; i < std::min((slice + 1) * kSlice, front_.ambiguous()); ++i)
            addDoubt(view, s, i, parts.size() == 1, keptOfSlices_[slice]);
    });
    for (std::size_t slice = 0; slice < slices; ++slice)
        kept_.insert(kept_.end(), keptOfSlices_[slice].begin(), keptOfSlices_[slice].end());
}

/// @param placed  whether its corners are among those placed last
void TileLists::addDoubt(const TileView& view, const TileScenery& s, std::size_t index, bool placed,
                         std::vector<Kept>& kept) const {
    const glm::vec4* rows = nullptr;
    std::uint32_t number = 0;
    const Triangle& t = front_.doubt(index, rows, number);
    if (placed) return addTriangle(view, number, corners_[t.a], corners_[t.b], corners_[t.c], kept);
    const CornerPlace place(view, rows);
    const auto corner = [&](std::uint32_t v) { return place(decodePosition(s.vertices[v], t.step())); };
    addTriangle(view, number, corner(t.a), corner(t.b), corner(t.c), kept);
}

void TileLists::findSeeds() {
    seeds_.assign(std::size_t{across_} * down_, 0);
    for (std::uint32_t y = 0; y < down_; ++y)
        for (std::uint32_t x = 0; x < across_; ++x) {
            const std::uint32_t left = x * kBinPixels, top = y * kBinPixels;
            const std::uint32_t right = left + kBinPixels, bottom = top + kBinPixels;
            seeds_[std::size_t{y} * across_ + x] = drawsSpheres_ ? frontSpheres_.isSeen(left, top, right, bottom)
                                                                 : front_.isSeen(left, top, right, bottom);
        }
}

void TileLists::order() {
    std::array<std::uint32_t, kDepthSteps + 1> at{};
    for (const Kept& k : kept_) ++at[k.step + 1];
    for (std::uint32_t i = 1; i <= kDepthSteps; ++i) at[i] += at[i - 1];
    order_.resize(kept_.size());
    for (std::uint32_t i = 0; i < kept_.size(); ++i) order_[at[kept_[i].step]++] = i;
}

/// Marks bins without a wanted tile as empty.
void TileLists::mask(const TileView& view) {
    drawnBins_.clear();
    mask_.wanted.clear();
    if (!view.mask) return;
    mask_ = *view.mask;
    for (std::uint32_t y = 0; y < down_; ++y)
        for (std::uint32_t x = 0; x < across_; ++x) {
            bool any = false;
            for (std::uint32_t i = 0; i < kTilesInBin * kTilesInBin; ++i)
                any = any || draws(x * kTilesInBin + i % kTilesInBin, y * kTilesInBin + i / kTilesInBin);
            drawnBins_.push_back(any ? 1 : 0);
        }
}

bool TileLists::drawsAny(const Kept& k) const {
    for (std::size_t y = k.y; y < k.endY; ++y)
        for (std::size_t x = k.x; x < k.endX; ++x)
            if (drawsBin(y * across_ + x)) return true;
    return false;
}

void TileLists::count() {
    offsets_.assign(std::size_t{across_} * down_ + 1, 0);
    for (const Kept& k : kept_)
        for (std::uint32_t y = k.y; y < k.endY; ++y) {
            std::uint32_t* row = offsets_.data() + std::size_t{y} * across_ + 1;
            for (std::uint32_t x = k.x; x < k.endX; ++x) ++row[x];
        }
    for (std::size_t bin = 0; bin < drawnBins_.size(); ++bin)
        if (!drawsBin(bin)) offsets_[bin + 1] = 0;
    longest_ = *std::max_element(offsets_.begin(), offsets_.end());
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
}

void TileLists::findSmall() {
    smallBins_.clear();
    if (small_.empty()) return;
    smallBins_.resize(std::size_t{across_} * down_);
    for (const std::uint32_t i : small_)
        for (std::uint32_t y = kept_[i].y; y < kept_[i].endY; ++y)
            for (std::uint32_t x = kept_[i].x; x < kept_[i].endX; ++x) smallBins_[std::size_t{y} * across_ + x] = 1;
}

void TileLists::listTiles() {
    bins_.clear();
    spans_.clear();
    for (std::uint32_t y = 0; y < down_; ++y)
        for (std::uint32_t x = 0; x < across_; ++x) {
            const std::size_t bin = std::size_t{y} * across_ + x;
            if (!holds(bin)) continue;
            const auto left = static_cast<std::uint16_t>(x), top = static_cast<std::uint16_t>(y);
            if (!spans_.empty() && spans_.back().y == y && spans_.back().endX == x)
                ++spans_.back().endX;
            else
                spans_.push_back({left, top, static_cast<std::uint16_t>(x + 1), static_cast<std::uint16_t>(y + 1)});
            bins_.push_back({left, top});
        }
    // A software device gives each thread a run of neighbouring workgroups: interleaving balances the work. A few
    // neighbouring bins stay together: they show the same primitives, whose occlusion is still in the cache.
    constexpr std::size_t kHands = 16, kRun = 4;
    tiles_.clear();
    for (std::size_t hand = 0; hand < kHands; ++hand)
        for (std::size_t b = hand * kRun; b < bins_.size(); b += b % kRun + 1 < kRun ? 1 : (kHands - 1) * kRun + 1)
            for (std::uint32_t i = 0; i < kTilesInBin; ++i)
                for (std::uint32_t j = 0; j < kTilesInBin; ++j) {
                    const std::uint32_t x = bins_[b].x * kTilesInBin + i, y = bins_[b].y * kTilesInBin + j;
                    if (draws(x, y)) tiles_.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
                }
}

void TileLists::build(const TileView& view, const TileScenery& s) {
    across_ = (view.width + kBinPixels - 1) / kBinPixels;
    down_ = (view.height + kBinPixels - 1) / kBinPixels;
    kept_.clear();
    small_.clear();
    mask(view);
    drawsSpheres_ = s.boxes != nullptr;
    if (drawsSpheres_)
        frontSpheres_.draw(view, s.spheres, *s.boxes, s.sphereCalls);
    else
        for (const TileCall& call : s.sphereCalls) addSpheres(view, s.spheres, call);
    keptSpheres_ = kept_.size();
    for (const TileCall& call : s.cylinderCalls) addCylinders(view, s, call);
    const bool drawsTriangles =
        (view.centers || view.edges) && !view.layers && view.contour == 0 && !s.triangleCalls.empty();
    if (drawsTriangles)
        addFrontTriangles(view, s);
    else
        addTriangles(view, s);
    seeded_ = drawsTriangles || drawsSpheres_;
    if (seeded_) findSeeds();
    findSmall();
    order();
    count();
    listTiles();
}

void TileLists::write(std::uint32_t* to) {
    writeTiles(to);
    to += tiles_.size();
    const auto base = static_cast<std::uint32_t>(words() - entries());
    for (const std::uint32_t offset : offsets_) *to++ = base + offset;
    *to++ = 1;
    cursors_.assign(offsets_.begin(), offsets_.end());
    for (const std::uint32_t i : order_) {
        const Kept& k = kept_[i];
        for (std::uint32_t y = k.y; y < k.endY; ++y) {
            const std::size_t first = std::size_t{y} * across_;
            std::uint32_t* row = cursors_.data() + first;
            for (std::uint32_t x = k.x; x < k.endX; ++x)
                if (drawsBin(first + x)) to[row[x]++] = k.number;
        }
    }
}

}  // namespace nacre
