// Open texels, and the sources of the others, against a search of one texel after the other.

#include "engine/occlusion/open_texels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <random>

#include "engine/threads.h"

namespace nacre::test {
namespace {

/// Spheres so near to each other that most of their surfaces are buried, some of them entirely.
Representation crowd(std::uint32_t seed) {
    std::mt19937 engine(seed);
    const auto chance = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); };
    Representation r;
    for (int i = 0; i < 60; ++i) r.spheres.push_back({{chance(-4, 4), chance(-4, 4), chance(-4, 4)}, chance(1, 2)});
    r.spheres.push_back({r.spheres[0].center, 0.5f});
    return r;
}

OcclusionLayout findLayout(const Representation& r, std::uint32_t edge) {
    for (const OcclusionLayout& layout : occlusionLayouts(r.spheres.size(), 0, 0, 4096, 4096))
        if (layout.sphereEdge == edge) return layout;
    return {};
}

/// A texel's point on the unit sphere, as shaders have it.
glm::vec3 decodeNormal(glm::ivec2 texel, std::uint32_t edge) {
    const glm::vec2 p = glm::vec2(texel) / static_cast<float>(edge - 1) * 2.0f - 1.0f;
    glm::vec3 n(p, 1 - std::abs(p.x) - std::abs(p.y));
    if (n.z < 0)
        n = {(1 - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f), (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f), n.z};
    return glm::normalize(n);
}

/// How deep a point is in any other sphere, Å; negative: how far from all.
double measureDepth(const Representation& r, std::size_t self, const glm::vec3& p) {
    double deepest = -1e9;
    for (std::size_t i = 0; i < r.spheres.size(); ++i)
        if (i != self)
            deepest = std::max(deepest, static_cast<double>(r.spheres[i].radius) -
                                            static_cast<double>(glm::distance(p, r.spheres[i].center)));
    return deepest;
}

/// Beyond an edge of a patch follows its mirrored half.
glm::ivec2 folded(glm::ivec2 p, int edge) {
    for (int i = 0; i < 2; ++i)
        if (p[i] < 0 || p[i] >= edge) {
            p[i] = p[i] < 0 ? -p[i] : 2 * (edge - 1) - p[i];
            p[1 - i] = edge - 1 - p[1 - i];
        }
    return p;
}

class OpenTexelsTest : public testing::TestWithParam<std::uint32_t> {};

TEST_P(OpenTexelsTest, AreThoseOutsideAllOthers) {
    const std::uint32_t edge = GetParam();
    const Representation r = crowd(edge);
    const OpenTexels open = openTexels(findLayout(r, edge), r, PrimitiveTree(r));
    EXPECT_TRUE(std::is_sorted(open.texels.begin(), open.texels.end()));
    EXPECT_EQ(open.sphereTexels, open.texels.size());
    std::size_t buried = 0;
    for (std::uint32_t t = 0; t < r.spheres.size() * edge * edge; ++t) {
        const std::uint32_t self = t / (edge * edge), at = t % (edge * edge);
        const Sphere& s = r.spheres[self];
        const double depth = measureDepth(r, self, s.center + decodeNormal({at % edge, at / edge}, edge) * s.radius);
        const bool listed = std::binary_search(open.texels.begin(), open.texels.end(), t);
        EXPECT_FALSE(listed && depth > 2e-3) << t;
        EXPECT_TRUE(listed || depth >= 0) << t;
        buried += !listed;
    }
    EXPECT_GT(buried, open.texels.size());
}

TEST(OpenTexels, KeepTheSticksOfAllThreads) {
    Representation r;
    for (int i = 0; i < 600; ++i) {
        const auto x = 9.0f * static_cast<float>(i);
        r.cylinders.push_back({{x, 0, 0}, 1, {x + 3, 0, 0}});
    }
    OcclusionLayout layout;
    for (const OcclusionLayout& l : occlusionLayouts(0, r.cylinders.size(), 0, 4096, 4096))
        if (l.sphereEdge > 1) layout = l;
    const auto texelsBy = [&](unsigned threads) {
        setThreadsPerTask(threads);
        return openTexels(layout, r, PrimitiveTree(r)).texels;
    };
    const auto before = texelsBy(1), after = texelsBy(4);
    setThreadsPerTask(0);
    EXPECT_GT(before.size(), r.cylinders.size());
    EXPECT_EQ(after, before);
}

TEST_P(OpenTexelsTest, GiveTheirValuesToTheNearestBuriedOnes) {
    const int edge = static_cast<int>(GetParam());
    const auto patch = static_cast<std::uint32_t>(edge * edge);
    const Representation r = crowd(GetParam() + 100);
    const OcclusionLayout layout = findLayout(r, GetParam());
    const OpenTexels open = openTexels(layout, r, PrimitiveTree(r));
    std::map<std::uint32_t, const AtlasWord*> words;
    for (const AtlasWord& word : open.words) EXPECT_TRUE(words.emplace(word.address, &word).second);
    std::size_t filled = 0, without = 0;
    for (std::uint32_t self = 0; self < r.spheres.size(); ++self) {
        const auto entryAt = [&](glm::ivec2 p) {
            p = folded(p, edge);
            if (p.x < 0 || p.y < 0 || p.x >= edge || p.y >= edge) return -1;
            const auto texel = static_cast<std::uint32_t>(p.y * edge + p.x) + self * patch;
            const auto found = std::lower_bound(open.texels.begin(), open.texels.end(), texel);
            return found != open.texels.end() && *found == texel ? static_cast<int>(found - open.texels.begin()) : -1;
        };
        const std::uint32_t left = self % layout.spherePatches() * GetParam(),
                            top = self / layout.spherePatches() * GetParam();
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                // The nearest step with two open texels in line, else the nearest with one.
                int entry = entryAt({x, y}), beyond = entry;
                std::vector<glm::ivec2> steps;
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx) steps.emplace_back(dx, dy);
                std::stable_sort(steps.begin(), steps.end(), [](const glm::ivec2& a, const glm::ivec2& b) {
                    return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
                });
                for (std::size_t i = 1, own = entry >= 0; i < steps.size() && !own; ++i) {
                    const int near = entryAt(glm::ivec2(x, y) + steps[i]);
                    if (near < 0) continue;
                    const int far = entryAt(glm::ivec2(x, y) + 2 * steps[i]);
                    if (far < 0 && entry >= 0) continue;
                    entry = near, beyond = far < 0 ? near : far;
                    if (far >= 0) break;
                }
                const std::uint32_t at =
                    (top + static_cast<std::uint32_t>(y)) * layout.width + left + static_cast<std::uint32_t>(x);
                const auto word = words.find(at / 4);
                if (entry < 0) {
                    ++without;
                    EXPECT_TRUE(word == words.end() || word->second->sources[at % 4].entry == AtlasWord::kNone);
                    continue;
                }
                ++filled;
                ASSERT_NE(word, words.end());
                const AtlasWord::Source& source = word->second->sources[at % 4];
                EXPECT_EQ(word->second->base + source.entry, static_cast<std::uint32_t>(entry)) << x << ' ' << y;
                EXPECT_EQ(word->second->base + source.beyond, static_cast<std::uint32_t>(beyond)) << x << ' ' << y;
            }
    }
    EXPECT_GT(filled, open.texels.size());
    EXPECT_GT(without, 0u);
}

INSTANTIATE_TEST_SUITE_P(Edges, OpenTexelsTest, testing::Values(3u, 4u, 5u, 7u, 12u, 14u, 17u, 32u));

}  // namespace
}  // namespace nacre::test
