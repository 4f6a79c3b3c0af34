#include "engine/software/hidden_spheres.h"

#include <algorithm>
#include <cmath>

#include "engine/software/host_lists.h"
#include "engine/threads.h"

namespace nacre::passes {
namespace {

constexpr float kMargin = 0.05f;  // Å by which a hidden sphere must be farther away, to allow for shaders' rounding

const glm::vec4* placedRows(const PlacedCopies& placed, std::uint32_t copy) {
    return placed.rows.data() + 3 * std::size_t{copy};
}

std::size_t threadsFor(std::size_t chunks) {
    constexpr std::size_t kWorth = 8192;  // chunks per additional thread
    return std::min<std::size_t>(chunks / kWorth + 1, threadsPerTask());
}

}  // namespace

void NearFirstSpheres::list(const PlacedCopies& copies, const Chunks& chunks, const TileView& view) {
    const std::vector<PlacedCopies::Call>& calls = copies.spheres;
    const auto chunkIndex = [](std::uint32_t sphere) { return sphere / Chunk::kPrimitives; };
    begins_.assign(1, 0);
    for (const PlacedCopies::Call& call : calls)
        begins_.push_back(begins_.back() + chunkIndex(call.first + call.count - 1) + 1 - chunkIndex(call.first));
    all_.resize(begins_.back());
    const auto listCall = [&](std::size_t c) {
        const PlacedCopies::Call& call = calls[c];
        const glm::vec4* rows = placedRows(copies, call.copy);
        Some* to = all_.data() + begins_[c];
        const std::uint32_t end = call.first + call.count;
        for (std::uint32_t first = call.first; first < end;) {
            const std::uint32_t next = std::min(end, (chunkIndex(first) + 1) * Chunk::kPrimitives);
            const Chunk& chunk = chunks.spheres[chunkIndex(first)];
            const glm::vec3 center = placed(rows, chunk.center);
            const Disc disc = boundingDisc(view, center, outlinedRadius(view, center.z, chunk.radius));
            const glm::vec2 at = toPixel(view, disc.center);
            *to++ = {view.origin - center.z - chunk.radius,
                     at.x,
                     at.y,
                     disc.radius * view.pixels,
                     call.copy,
                     first,
                     next - first,
                     0};
            first = next;
        }
    };
    const std::size_t threads = threadsFor(all_.size());
    inParallel(threads, [&](std::size_t t) {
        const std::size_t end = calls.size() * (t + 1) / threads;
        for (std::size_t c = calls.size() * t / threads; c < end; ++c) listCall(c);
    });
}

bool NearFirstSpheres::hides(const Some& some, RowBand part) {
    // An invalid ball covers the whole picture and is never hidden.
    if (!std::isfinite(some.x + some.y + some.reach)) return false;
    const float row = some.y / coverage_.side(), rows = some.reach / coverage_.side() + 1;
    if (row + rows < static_cast<float>(part.first) || row - rows > static_cast<float>(part.end)) return true;
    return coverage_.hides({some.x, some.y}, some.reach, some.near - kMargin, part);
}

/// @returns the spheres that may be visible in a part, a bit each @param asked  candidates
std::uint32_t NearFirstSpheres::findShown(const Some& some, std::uint32_t asked, const Scenery& scenery, RowBand part,
                                          bool covers) {
    std::uint32_t shown = 0;
    const glm::vec4* rows = placedRows(scenery.copies, some.copy);
    for (std::uint32_t i = 0; i < some.count; ++i) {
        if (!(asked >> i & 1)) continue;
        const Sphere& s = scenery.spheres[some.first + i];
        const glm::vec3 center = placed(rows, s.center);
        const Disc disc = boundingDisc(scenery.view, center, outlinedRadius(scenery.view, center.z, s.radius));
        const float near = scenery.view.origin - center.z - s.radius - kMargin;
        if (coverage_.hides(toPixel(scenery.view, disc.center), disc.radius * scenery.view.pixels, near, part))
            continue;
        shown |= 1u << i;
        if (covers) coverage_.cover(scenery.view, center, s.radius, part);
    }
    return shown;
}

void NearFirstSpheres::look(const Scenery& scenery, std::size_t of) {
    const RowBand part = parts_[of];
    std::vector<Shown>& shown = shown_[of];
    shown.clear();
    constexpr std::size_t kAhead = 16;  // scattered in memory: prefetched
    for (std::size_t at = 0; at < order_.size(); ++at) {
        __builtin_prefetch(&all_[order_[std::min(at + kAhead, order_.size() - 1)]]);
        const std::uint32_t i = order_[at];
        if (hides(all_[i], part)) continue;
        const std::uint32_t here = findShown(all_[i], ~0u, scenery, part, true);
        if (here != 0) shown.push_back({i, here});
    }
    // Again, now that the largest occluders are known.
    for (Shown& s : shown) s.spheres = findShown(all_[s.some], s.spheres, scenery, part, false);
}

std::unique_ptr<HiddenSpheres> makeHiddenSpheres() { return std::make_unique<NearFirstSpheres>(); }

void NearFirstSpheres::drop(SceneView& seen, const Representation& r, const Chunks& chunks, const View& of,
                            graph::Extent image, bool centers) {
    PlacedCopies& copies = seen.copies;
    const TileView view = tileView(seen, of, image, centers);
    coverage_.begin(view, seen.radiusPixels);
    list(copies, chunks, view);
    orderNearFirst<1024>(view, all_, order_);
    const std::uint32_t rows = coverage_.rows();
    const auto findRow = [&](const Some& some) {
        const float row = std::min(std::max(some.y / coverage_.side(), 0.0f), static_cast<float>(rows - 1));
        return static_cast<std::uint32_t>(row);
    };
    partRows(rows, threadsFor(all_.size()), all_, findRow, inRow_, parts_);
    shown_.resize(std::max(shown_.size(), parts_.size()));
    inParallel(parts_.size(), [&](std::size_t p) { look({view, r.spheres, copies}, p); });
    // A sphere on the border of two parts may be visible in either.
    for (std::size_t p = 0; p < parts_.size(); ++p)
        for (const Shown& s : shown_[p]) all_[s.some].shown |= s.spheres;
    // Visible spheres in stream order: consecutive ones in one call.
    std::vector<PlacedCopies::Call>& calls = copies.spheres;
    calls.clear();
    for (const Some& some : all_)
        for (std::uint32_t i = 0; i < some.count; ++i) {
            if (!(some.shown >> i & 1)) continue;
            const std::uint32_t number = some.first + i;
            if (!calls.empty() && calls.back().copy == some.copy && calls.back().first + calls.back().count == number)
                ++calls.back().count;
            else
                calls.push_back({some.copy, number, 1});
        }
}

}  // namespace nacre::passes
