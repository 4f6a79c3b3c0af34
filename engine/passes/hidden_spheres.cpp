#include "engine/passes/hidden_spheres.h"

#include <algorithm>
#include <array>

namespace nacre::passes {
namespace {

constexpr std::uint32_t kDepths = 1024;  // that the order tells apart
constexpr float kMargin = 0.05f;         // Å that something hidden is farther away, for what shaders round differently

const glm::vec4* rowsOf(const PlacedCopies& placed, std::uint32_t copy) {
    return placed.rows.data() + 3 * std::size_t{copy};
}

}  // namespace

void HiddenSpheres::list(const PlacedCopies& copies, const Chunks& chunks, const TileView& view) {
    all_.clear();
    for (const PlacedCopies::Call& call : copies.spheres) {
        const glm::vec4& z = rowsOf(copies, call.copy)[2];
        const std::uint32_t end = call.first + call.count;
        for (std::uint32_t first = call.first; first < end;) {
            const std::uint32_t next = std::min(end, (first / Chunk::kPrimitives + 1) * Chunk::kPrimitives);
            const Chunk& chunk = chunks.spheres[first / Chunk::kPrimitives];
            const float depth = z.x * chunk.center.x + z.y * chunk.center.y + z.z * chunk.center.z + z.w;
            all_.push_back({view.origin - depth - chunk.radius, call.copy, first, next - first, 0});
            first = next;
        }
    }
}

void HiddenSpheres::order(const TileView& view) {
    const auto depthOf = [&](const Some& some) {
        const float share = (some.near - view.nearest) / view.range;
        return static_cast<std::uint32_t>(std::min(std::max(share * kDepths, 0.0f), kDepths - 1.0f));
    };
    std::array<std::uint32_t, kDepths + 1> at{};
    for (const Some& some : all_) ++at[depthOf(some) + 1];
    for (std::uint32_t i = 1; i <= kDepths; ++i) at[i] += at[i - 1];
    order_.resize(all_.size());
    for (std::uint32_t i = 0; i < all_.size(); ++i) order_[at[depthOf(all_[i])]++] = i;
}

void HiddenSpheres::look(Some& some, const glm::vec4* rows, const Representation& r, const TileView& view) {
    for (std::uint32_t i = 0; i < some.count; ++i) {
        const Sphere& s = r.spheres[some.first + i];
        const glm::vec3 center = placed(rows, s.center);
        const Disc disc = discOf(view, center, reachOf(view, center.z, s.radius));
        const glm::vec2 at = pixelOf(view, disc.center);
        const float reach = disc.radius * view.pixels;
        if (coverage_.hides(at - reach, at + reach, view.origin - center.z - s.radius - kMargin)) continue;
        some.shown |= 1u << i;
        coverage_.cover(view, center, s.radius);
    }
}

void HiddenSpheres::drop(PlacedCopies& copies, const Representation& r, const Chunks& chunks, const TileView& view,
                         double radiusPixels) {
    coverage_.begin(view, radiusPixels);
    list(copies, chunks, view);
    order(view);
    for (const std::uint32_t i : order_) look(all_[i], rowsOf(copies, all_[i].copy), r, view);
    // What shows, in the order of the stream: neighbours in one call.
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
