#include "engine/occlusion/open_texels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>

#include "engine/occlusion/open_patch.h"
#include "engine/occlusion/patch_coordinates.h"
#include "engine/scene/build/translucency.h"
#include "engine/simd/lanes.h"
#include "engine/threads.h"

namespace nacre {
namespace {

/// Å. Larger than rounding errors, so that coinciding surfaces stay open.
constexpr float kDeep = 1e-3f;
/// Maximum number of neighbours per primitive; normal matter has about forty. A texel inside another neighbour counts
/// as open. This costs work but changes no light: no direction reaches it.
constexpr std::size_t kMostNeighbours = 512;

/// Which of several places are inside a primitive.
Mask inside(const Sphere& s, Lanes x, Lanes y, Lanes z) {
    x -= s.center.x, y -= s.center.y, z -= s.center.z;
    const float r = s.radius - kDeep;
    return x * x + y * y + z * z < Lanes{} + r * r;
}

Mask inside(const Cylinder& c, Lanes x, Lanes y, Lanes z) {
    const glm::vec3 axis = c.b - c.a;
    x -= c.a.x, y -= c.a.y, z -= c.a.z;
    const Lanes t = (x * axis.x + y * axis.y + z * axis.z) / glm::dot(axis, axis);
    x -= axis.x * t, y -= axis.y * t, z -= axis.z * t;
    const float r = c.radius - kDeep;
    return (t > Lanes{}) & (t < Lanes{} + 1.0f) & (x * x + y * y + z * z < Lanes{} + r * r);
}

/// Octahedral normals of a patch, as in shaders/common/patch.glsl.
struct OctahedralNormals {
    std::vector<float> x, y, z;  // padded to whole lanes

    explicit OctahedralNormals(std::uint32_t edge) {
        const auto along = [&](std::uint32_t i) {
            return static_cast<float>(i) / static_cast<float>(edge - 1) * 2.0f - 1.0f;
        };
        for (std::uint32_t i = 0; i < edge * edge; ++i) add(along(i % edge), along(i / edge));
        while (x.size() % kLanes != 0) add(0, 0);
    }

private:
    void add(float px, float py) {
        glm::vec3 n(px, py, 1.0f - std::abs(px) - std::abs(py));
        if (n.z < 0.0f) {
            n.x = (1.0f - std::abs(py)) * (px >= 0.0f ? 1.0f : -1.0f);
            n.y = (1.0f - std::abs(px)) * (py >= 0.0f ? 1.0f : -1.0f);
        }
        n = glm::normalize(n);
        x.push_back(n.x), y.push_back(n.y), z.push_back(n.z);
    }
};

/// Finds the open texels of primitives one by one, and appends them and their words to its own list.
class Finder {
public:
    Finder(const OcclusionLayout& layout, const Representation& r, const PrimitiveTree& tree)
        : layout_(layout), r_(r), tree_(tree), normals_(layout.sphereEdge) {
        for (std::uint32_t x = 0; x < layout.around; ++x) {
            const float angle = (static_cast<float>(x) / static_cast<float>(layout.around - 1) - 0.5f) * 2.0f *
                                std::numbers::pi_v<float>;
            circle_.emplace_back(std::cos(angle), std::sin(angle));
        }
    }

    /// @param wanted  also collect the words
    void sphere(std::uint32_t i, bool wanted = true) {
        const std::uint32_t edge = layout_.sphereEdge;
        found.firstOfSphere.push_back(static_cast<std::uint32_t>(found.texels.size()));
        collect(i);
        begin({edge, edge}, true);
        for (std::uint32_t k = 0; k < edge * edge; k += kLanes) {
            const Sphere& s = r_.spheres[i];
            Lanes x = s.center.x + loadLanes(&normals_.x[k]) * s.radius;
            Lanes y = s.center.y + loadLanes(&normals_.y[k]) * s.radius;
            Lanes z = s.center.z + loadLanes(&normals_.z[k]) * s.radius;
            for (std::uint32_t lane = 0; r_.ellipsoid(i) && lane < std::min(edge * edge - k, kLanes); ++lane) {
                const std::size_t n = std::size_t{k} + lane;
                const glm::vec3 p = r_.pointOfBall(i, {normals_.x[n], normals_.y[n], normals_.z[n]});
                x[lane] = p.x, y[lane] = p.y, z[lane] = p.z;
            }
            openEach(openLanes(x, y, z), k, std::min(edge * edge - k, kLanes), i * edge * edge);
        }
        if (wanted) words({edge, edge}, i, 0);
        found.sphereTexels = found.texels.size();
    }

    void skipSphere() { found.firstOfSphere.push_back(static_cast<std::uint32_t>(found.texels.size())); }

    void cylinder(std::uint32_t i, bool wanted = true) {
        const Cylinder& c = r_.cylinders[i];
        const std::uint32_t around = layout_.around, along = layout_.along;
        collect(static_cast<std::uint32_t>(r_.spheres.size()) + i);
        begin({around, along}, false);
        glm::vec3 u, v;
        frameAbout(glm::normalize(c.b - c.a), u, v);
        const auto base = static_cast<std::uint32_t>(layout_.sphereTexels()) + i * around * along;
        const std::uint32_t count = around * along;
        for (std::uint32_t k = 0; k < count; k += kLanes) {
            Lanes x{}, y{}, z{};
            const std::uint32_t lanes = std::min(count - k, kLanes);
            for (std::uint32_t lane = 0; lane < lanes; ++lane) {
                const glm::vec2 turn = circle_[(k + lane) % around];
                const float way = static_cast<float>((k + lane) / around) / static_cast<float>(along - 1);
                const glm::vec3 p = glm::mix(c.a, c.b, way) + c.radius * (u * turn.x + v * turn.y);
                x[lane] = p.x, y[lane] = p.y, z[lane] = p.z;
            }
            openEach(openLanes(x, y, z), k, lanes, base);
        }
        if (wanted) words({around, along}, i, layout_.sphereRows);
    }

    OpenTexels found;

private:
    void collect(std::uint32_t self) {
        around_.clear();
        tree_.near(self, [&](std::uint32_t item) {
            if (!isOpaque(item)) return true;  // translucent shapes occlude nothing
            around_.push_back(item);
            return around_.size() < kMostNeighbours;
        });
    }
    bool isOpaque(std::uint32_t item) const {
        const std::size_t spheres = r_.spheres.size();
        if (item < spheres && item < r_.sphereLooks.size())
            return classifyTranslucency(r_.sphereLooks[item]) == Translucency::opaque;
        if (item >= spheres && item - spheres < r_.cylinderLooks.size())
            return classifyTranslucency(r_.cylinderLooks[item - spheres]) == Translucency::opaque;
        return true;
    }
    /// Bits for kLanes places; set: outside all primitives around.
    std::uint32_t openLanes(Lanes x, Lanes y, Lanes z) const {
        Mask in{};
        for (const std::uint32_t item : around_) {
            if (const EllipsoidRows* rows = r_.ellipsoid(item)) {
                const float most = 1 - kDeep / rows->inner();
                for (std::uint32_t k = 0; k < kLanes; ++k) {
                    const glm::vec3 p = glm::vec3(x[k], y[k], z[k]) - r_.spheres[item].center;
                    in[k] |= glm::length(rows->toUnit(p)) < most ? -1 : 0;
                }
            } else if (item < r_.spheres.size())
                in |= inside(r_.spheres[item], x, y, z);
            else
                in |= inside(r_.cylinders[item - r_.spheres.size()], x, y, z);
            if (packSigns(in) == kAllLanes) return 0;
        }
        return ~packSigns(in) & kAllLanes;
    }
    /// Opens successive texels of a patch by bits. @param base  of the patch in the linear order
    void openEach(std::uint32_t bits, std::uint32_t first, std::uint32_t lanes, std::uint32_t base) {
        for (bits &= (1u << lanes) - 1; bits != 0; bits &= bits - 1) {
            const std::uint32_t texel = first + static_cast<std::uint32_t>(std::countr_zero(bits));
            patch_.open(texel, static_cast<std::uint16_t>(found.texels.size() - base_));
            found.texels.push_back(base + texel);
        }
    }
    void begin(const glm::ivec2& size, bool sphere) {
        patch_.begin(size, sphere);
        base_ = static_cast<std::uint32_t>(found.texels.size());
    }
    /// Appends the words of one patch.
    void words(const glm::uvec2& size, std::uint32_t shape, std::uint32_t top) {
        const std::uint32_t perRow = layout_.width / size.x;
        const std::uint32_t left = shape % perRow * size.x, row = top + shape / perRow * size.y;
        patch_.addWords(row * layout_.width + left, layout_.width, base_, found.words);
    }

    static constexpr std::uint32_t kAllLanes = (1u << kLanes) - 1;
    const OcclusionLayout& layout_;
    const Representation& r_;
    const PrimitiveTree& tree_;
    OctahedralNormals normals_;
    std::vector<glm::vec2> circle_;  // directions around a cylinder
    std::vector<std::uint32_t> around_;
    OpenPatch patch_;
    std::uint32_t base_ = 0;
};

/// One value per sphere: all open.
void openSpheres(OpenTexels& all, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        all.firstOfSphere.push_back(i);
        all.texels.push_back(i);
        if (i % 4 == 0) all.words.push_back({i / 4, i, {}});
        all.words.back().sources[i % 4] = {static_cast<std::uint16_t>(i % 4), static_cast<std::uint16_t>(i % 4)};
    }
    all.sphereTexels = count;
}

/// The sample contains every n-th primitive.
std::uint32_t sampledEach(std::size_t count) {
    constexpr std::size_t kSample = 500;
    return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(count / kSample));
}

void append(OpenTexels& all, OpenTexels&& part) {
    if (all.texels.empty() && all.words.empty() && all.firstOfSphere.empty()) {
        all = std::move(part);
        return;
    }
    const auto base = static_cast<std::uint32_t>(all.texels.size());
    all.texels.insert(all.texels.end(), part.texels.begin(), part.texels.end());
    all.sphereTexels += part.sphereTexels;
    for (const std::uint32_t first : part.firstOfSphere) all.firstOfSphere.push_back(base + first);
    for (AtlasWord word : part.words) {
        word.base += base;
        all.words.push_back(word);
    }
}

/// Vertices have two texels each, four texels per word; no other value can replace theirs.
void addVertices(OpenTexels& all, const OcclusionLayout& layout) {
    const std::uint64_t top = std::uint64_t{layout.sphereRows} + layout.cylinderRows;
    const auto first = static_cast<std::uint32_t>(layout.patchTexels());
    for (std::uint32_t i = 0; i < 2 * layout.vertexCount; ++i) {
        if (i % 4 == 0)
            all.words.push_back({static_cast<std::uint32_t>((top * layout.width + i) / 4),
                                 static_cast<std::uint32_t>(all.texels.size()),
                                 {}});
        const auto entry = static_cast<std::uint16_t>(i % 4);
        all.words.back().sources[entry] = {entry, entry};
        all.texels.push_back(first + i);
    }
}

}  // namespace

OpenTexels openTexels(const OcclusionLayout& layout, const Representation& r, const PrimitiveTree& tree,
                      const std::stop_token& stop, const std::vector<bool>& hidden) {
    OpenTexels all;
    const auto spheres = static_cast<std::uint32_t>(r.spheres.size());
    const auto count = spheres + static_cast<std::uint32_t>(r.cylinders.size());
    const bool whole = layout.sphereEdge == 1;
    if (whole) openSpheres(all, spheres);
    const std::uint32_t first = whole ? spheres : 0;

    constexpr std::uint32_t kLeast = 128;  // primitives per thread: starting one takes as long as a dozen primitives
    const std::uint32_t parts = std::min({threadsPerTask(), 16u, 1 + (count - first) / kLeast});
    std::vector<Finder> finders(parts, Finder(layout, r, tree));
    inParallel(parts, [&](std::size_t part) {
        const auto bound = [&](std::size_t n) {
            std::uint32_t i = first + static_cast<std::uint32_t>(std::uint64_t{count - first} * n / parts);
            while (i < spheres && i % layout.spherePatches() * layout.sphereEdge % 4 != 0) ++i;  // parts share no word
            return i;
        };
        for (std::uint32_t i = bound(part); i < bound(part + 1) && !stop.stop_requested(); ++i)
            if (i >= spheres)
                finders[part].cylinder(i - spheres);
            else if (hidden.empty() || !hidden[i])
                finders[part].sphere(i);
            else
                finders[part].skipSphere();
    });
    for (Finder& finder : finders) append(all, std::move(finder.found));
    all.firstOfSphere.push_back(static_cast<std::uint32_t>(all.sphereTexels));
    addVertices(all, layout);
    return all;
}

void followKept(std::span<AtlasWord> words, std::span<const std::uint32_t> keptBefore) {
    for (AtlasWord& word : words) {
        const std::uint32_t base = word.base;
        word.base = keptBefore[base];
        const auto follow = [&](std::uint16_t& entry) {
            if (entry == AtlasWord::kNone) return;
            const std::uint32_t before = keptBefore[base + entry];
            entry = keptBefore[base + entry + 1] == before ? AtlasWord::kNone  // dropped
                                                           : static_cast<std::uint16_t>(before - word.base);
        };
        for (AtlasWord::Source& source : word.sources) {
            follow(source.entry);
            follow(source.beyond);
        }
    }
}

bool samplesAll(const Representation& r) {
    return sampledEach(r.spheres.size()) == 1 && sampledEach(r.cylinders.size()) == 1;
}

double openShare(const OcclusionLayout& layout, const Representation& r, const PrimitiveTree& tree) {
    if (layout.patchTexels() == 0 || layout.sphereEdge == 1) return 1.0;
    Finder finder(layout, r, tree);
    std::uint64_t texels = 0;
    for (std::uint32_t i = 0; i < r.spheres.size(); i += sampledEach(r.spheres.size())) {
        finder.sphere(i, false);
        texels += std::uint64_t{layout.sphereEdge} * layout.sphereEdge;
    }
    for (std::uint32_t i = 0; i < r.cylinders.size(); i += sampledEach(r.cylinders.size())) {
        finder.cylinder(i, false);
        texels += std::uint64_t{layout.around} * layout.along;
    }
    return static_cast<double>(finder.found.texels.size()) / static_cast<double>(texels);
}

}  // namespace nacre
