#include "engine/occlusion/seen_texels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace nacre {
namespace {

/// Marks the texels at the corners of those cells of a sphere's patch that hold a normal towards the viewer.
std::vector<bool> seenOfSphere(std::uint32_t edge, const glm::dvec3& towards) {
    // An unnormalised octahedral normal is linear in the patch coordinates except at folds. Between points at this
    // distance, its component towards the viewer changes by at most 2 per coordinate.
    constexpr std::uint32_t kPoints = 8;
    const double cell = 2.0 / (edge - 1), apart = cell / kPoints;
    std::vector<bool> seen(std::size_t{edge} * edge, false);
    const auto sees = [&](std::uint32_t x, std::uint32_t y) {
        for (std::uint32_t j = 0; j <= kPoints; ++j)
            for (std::uint32_t i = 0; i <= kPoints; ++i) {
                const double px = x * cell + i * apart - 1, py = y * cell + j * apart - 1;
                glm::dvec3 n(px, py, 1 - std::abs(px) - std::abs(py));
                if (n.z < 0) {
                    n.x = (1 - std::abs(py)) * (px >= 0 ? 1 : -1);
                    n.y = (1 - std::abs(px)) * (py >= 0 ? 1 : -1);
                }
                if (glm::dot(n, towards) >= -2 * apart) return true;
            }
        return false;
    };
    for (std::uint32_t y = 0; y + 1 < edge; ++y)
        for (std::uint32_t x = 0; x + 1 < edge; ++x) {
            if (!sees(x, y)) continue;
            const std::size_t first = std::size_t{y} * edge + x;
            for (const std::size_t corner : {first, first + 1, first + edge, first + edge + 1}) seen[corner] = true;
        }
    return seen;
}

/// Marks a vertex texel, outer or inner, if a triangle shows that side. A triangle seen edge-on, or too thin for pixel
/// rounding, may show either side.
std::vector<bool> seenOfVertices(const OcclusionLayout& layout, const Representation& r, const ViewDirection& from,
                                 const occlusion::HiddenTriangles& hidden) {
    constexpr float kFlat = 0.1f;
    constexpr double kThinPixels = 0.1;
    std::vector<bool> seen(2 * std::size_t{layout.vertexCount}, false);
    const glm::vec3 towards = from.towards;
    const auto thinnest = static_cast<float>(kThinPixels / from.pixelsPerAngstrom);
    const std::size_t count = r.triangles.size() + r.coarseTriangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle& t = drawnTriangle(r, i);
        const auto at = [&](std::uint32_t vertex) { return decodePosition(r.meshVertices[vertex], t.step()); };
        const glm::vec3 a = at(t.a), b = at(t.b), c = at(t.c), ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
        if (hidden.hides(a, b, c)) continue;
        const float length = glm::length(normal), facing = glm::dot(normal, towards);
        const float longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
        const bool either = !(std::abs(facing) > kFlat * length) || !(length > thinnest * longest);
        for (const std::uint32_t vertex : {t.a, t.b, t.c}) {
            if (either || facing > 0) seen[2 * std::size_t{vertex}] = true;
            if (either || facing < 0) seen[2 * std::size_t{vertex} + 1] = true;
        }
    }
    return seen;
}

/// One word per four texels, one bit each.
std::vector<std::uint8_t> packTexels(const std::vector<bool>& texels) {
    std::vector<std::uint8_t> words((texels.size() + 3) / 4, 0);
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (texels[i]) words[i / 4] |= static_cast<std::uint8_t>(1u << i % 4);
    return words;
}

}  // namespace

std::optional<ViewDirection> onlyViewDirection(const RenderSettings& settings) {
    const View& view = settings.view;
    // A stored bake serves other views. Clipping planes expose surfaces, and perspective turns them. Light bounces from
    // surfaces that the view does not show.
    if (!settings.occlusion.once || !settings.occlusion.cache.empty() || settings.occlusion.bounce ||
        settings.effects.clip.on() || settings.debug != DebugView::none || view.projection == Projection::perspective)
        return {};
    return ViewDirection{glm::transpose(view.rotation) * glm::dvec3(0, 0, 1), view.pixelsPerAngstrom};
}

void keepSeen(OpenTexels& open, const OcclusionLayout& layout, const Representation& r,
              const ViewDirection& viewDirection, const occlusion::HiddenTriangles& hidden) {
    if (layout.sphereEdge == 1) return;
    const std::uint32_t edge = layout.sphereEdge, perRow = layout.width / 4;
    const std::vector<bool> ofSphere = seenOfSphere(edge, viewDirection.towards);
    const std::vector<std::uint8_t> ofVertices = packTexels(seenOfVertices(layout, r, viewDirection, hidden));
    const std::uint64_t vertexRow = std::uint64_t{layout.sphereRows} + layout.cylinderRows;
    const auto findSeen = [&](std::uint32_t word) -> std::uint32_t {
        const std::uint32_t row = word / perRow, column = word % perRow;
        if (row < layout.sphereRows) {
            std::uint32_t seen = 0;
            for (std::uint32_t k = 0; k < 4; ++k)
                seen |= std::uint32_t{ofSphere[std::size_t{row % edge} * edge + (4 * column + k) % edge]} << k;
            return seen;
        }
        if (row < vertexRow) return 15;
        const std::uint64_t place = word - vertexRow * perRow;
        return place < ofVertices.size() ? ofVertices[place] : 0u;
    };
    std::vector<std::uint32_t> keptBefore(open.texels.size() + 1, 0);
    const auto keep = [&](const AtlasWord& word, std::uint16_t entry) { keptBefore[word.base + entry + 1] = 1; };
    for (AtlasWord& word : open.words) {
        const std::uint32_t seen = findSeen(word.address);
        for (std::uint32_t i = 0; i < 4; ++i) {
            AtlasWord::Source& source = word.sources[i];
            if (source.entry == AtlasWord::kNone) continue;
            if ((seen >> i & 1) == 0) {
                source = {};
                continue;
            }
            keep(word, source.entry);
            keep(word, source.beyond);
        }
    }
    std::erase_if(open.words, [](const AtlasWord& word) {
        return std::all_of(std::begin(word.sources), std::end(word.sources),
                           [](const AtlasWord::Source& source) { return source.entry == AtlasWord::kNone; });
    });
    for (std::size_t i = 0; i < open.texels.size(); ++i) {
        if (keptBefore[i + 1]) open.texels[keptBefore[i]] = open.texels[i];
        keptBefore[i + 1] += keptBefore[i];
    }
    open.texels.resize(keptBefore.back());
    open.sphereTexels = keptBefore[open.sphereTexels];
    for (std::uint32_t& first : open.firstOfSphere) first = keptBefore[first];
    followKept(open.words, keptBefore);
}

}  // namespace nacre
