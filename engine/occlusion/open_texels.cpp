#include "engine/occlusion/open_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>

#include "engine/threads.h"

namespace nacre {
namespace {

/// Inside by more than rounding, so that surfaces that coincide stay open.
constexpr float kDeep = 1e-3f;
/// Neighbours examined per primitive; normal matter has about forty. A texel inside a later one counts as open: costs
/// work but changes no light, since no direction reaches it.
constexpr std::size_t kMostNeighbours = 512;
constexpr std::uint16_t kBuried = AtlasWord::kNone;

bool inside(const Sphere& s, const glm::vec3& p) {
    const glm::vec3 d = p - s.center;
    const float r = s.radius - kDeep;
    return glm::dot(d, d) < r * r;
}

bool inside(const Cylinder& c, const glm::vec3& p) {
    const glm::vec3 axis = c.b - c.a, d = p - c.a;
    const float t = glm::dot(d, axis) / glm::dot(axis, axis);
    if (t <= 0.0f || t >= 1.0f) return false;
    const glm::vec3 side = d - axis * t;
    const float r = c.radius - kDeep;
    return glm::dot(side, side) < r * r;
}

/// The octahedral normals of a patch, as shaders/common/patch.glsl has them.
std::vector<glm::vec3> octahedralNormals(std::uint32_t edge) {
    std::vector<glm::vec3> normals;
    for (std::uint32_t y = 0; y < edge; ++y)
        for (std::uint32_t x = 0; x < edge; ++x) {
            const float px = static_cast<float>(x) / static_cast<float>(edge - 1) * 2.0f - 1.0f;
            const float py = static_cast<float>(y) / static_cast<float>(edge - 1) * 2.0f - 1.0f;
            glm::vec3 n(px, py, 1.0f - std::abs(px) - std::abs(py));
            if (n.z < 0.0f) {
                n.x = (1.0f - std::abs(py)) * (px >= 0.0f ? 1.0f : -1.0f);
                n.y = (1.0f - std::abs(px)) * (py >= 0.0f ? 1.0f : -1.0f);
            }
            normals.push_back(glm::normalize(n));
        }
    return normals;
}

/// Two unit vectors that make a frame with w; the same as frameAbout() in shaders/common/patch.glsl.
void frameAbout(const glm::vec3& w, glm::vec3& u, glm::vec3& v) {
    const float s = w.z >= 0.0f ? 1.0f : -1.0f;
    const float a = -1.0f / (s + w.z), b = w.x * w.y * a;
    u = {1.0f + s * w.x * w.x * a, s * b, -s * w.x};
    v = {b, s + w.y * w.y * a, -w.y};
}

/// Maps a texel one or two steps beyond a patch's edge into the patch: beyond an edge follows its mirrored half
/// (sphere) or the opposite edge (cylinder).
glm::ivec2 folded(glm::ivec2 p, const glm::ivec2& size, bool sphere) {
    if (!sphere) {
        if (p.x < 0) p.x += size.x - 1;
        if (p.x >= size.x) p.x -= size.x - 1;
        return p;
    }
    for (int i = 0; i < 2; ++i) {
        if (p[i] >= 0 && p[i] < size[i]) continue;
        p[i] = p[i] < 0 ? -p[i] : 2 * (size[i] - 1) - p[i];
        p[1 - i] = size[1 - i] - 1 - p[1 - i];
    }
    return p;
}

/// Steps to the 24 nearest texels, the nearest first.
std::span<const glm::ivec2> nearSteps() {
    static const std::vector<glm::ivec2> steps = [] {
        std::vector<glm::ivec2> list;
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                if (x || y) list.emplace_back(x, y);
        std::stable_sort(list.begin(), list.end(), [](const glm::ivec2& a, const glm::ivec2& b) {
            return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
        });
        return list;
    }();
    return steps;
}

/// Finds the open texels of one primitive after the other, and appends them and their words to a list of its own.
class Finder {
public:
    Finder(const OcclusionLayout& layout, const Representation& r, const PrimitiveTree& tree)
        : layout_(layout), r_(r), tree_(tree), normals_(octahedralNormals(layout.sphereEdge)) {}

    /// @param wanted  whether it lists the words of what it finds
    void sphere(std::uint32_t i, bool wanted = true) {
        const Sphere& s = r_.spheres[i];
        const std::uint32_t edge = layout_.sphereEdge;
        found.firstOfSphere.push_back(static_cast<std::uint32_t>(found.texels.size()));
        collect(i);
        begin(std::size_t{edge} * edge);
        for (std::uint32_t k = 0; k < edge * edge; ++k)
            if (!buried(s.center + normals_[k] * s.radius)) open(k, i * edge * edge + k);
        if (wanted) words({edge, edge}, true, i, 0);
        found.sphereTexels = found.texels.size();
    }

    void cylinder(std::uint32_t i, bool wanted = true) {
        const Cylinder& c = r_.cylinders[i];
        const std::uint32_t around = layout_.around, along = layout_.along;
        collect(static_cast<std::uint32_t>(r_.spheres.size()) + i);
        begin(std::size_t{around} * along);
        glm::vec3 u, v;
        frameAbout(glm::normalize(c.b - c.a), u, v);
        const auto base = static_cast<std::uint32_t>(layout_.sphereTexels()) + i * around * along;
        for (std::uint32_t y = 0; y < along; ++y)
            for (std::uint32_t x = 0; x < around; ++x) {
                const float angle =
                    (static_cast<float>(x) / static_cast<float>(around - 1) - 0.5f) * 2.0f * std::numbers::pi_v<float>;
                const glm::vec3 p = glm::mix(c.a, c.b, static_cast<float>(y) / static_cast<float>(along - 1)) +
                                    c.radius * (u * std::cos(angle) + v * std::sin(angle));
                if (!buried(p)) open(y * around + x, base + y * around + x);
            }
        if (wanted) words({around, along}, false, i, layout_.sphereRows);
    }

    OpenTexels found;

private:
    void collect(std::uint32_t self) {
        around_.clear();
        tree_.near(self, [&](std::uint32_t item) {
            around_.push_back(item);
            return around_.size() < kMostNeighbours;
        });
        last_ = 0;
    }
    bool holds(std::uint32_t item, const glm::vec3& p) const {
        return item < r_.spheres.size() ? inside(r_.spheres[item], p)
                                        : inside(r_.cylinders[item - r_.spheres.size()], p);
    }
    bool buried(const glm::vec3& p) {
        // Neighbouring texels are mostly buried by the same neighbour: ask that one first.
        if (last_ < around_.size() && holds(around_[last_], p)) return true;
        for (std::size_t i = 0; i < around_.size(); ++i)
            if (holds(around_[i], p)) return last_ = i, true;
        return false;
    }
    void begin(std::size_t texels) {
        entries_.assign(texels, kBuried);
        base_ = static_cast<std::uint32_t>(found.texels.size());
    }
    void open(std::uint32_t local, std::uint32_t texel) {
        entries_[local] = static_cast<std::uint16_t>(found.texels.size() - base_);
        found.texels.push_back(texel);
    }
    std::uint16_t entryAt(const glm::ivec2& at, const glm::ivec2& size, bool sphere) const {
        const glm::ivec2 p = folded(at, size, sphere);
        if (p.x < 0 || p.y < 0 || p.x >= size.x || p.y >= size.y) return kBuried;
        const int place = p.y * size.x + p.x;
        return entries_[static_cast<std::size_t>(place)];
    }
    /// The patch with the margin that nearestOpen() searches, so that no folding is needed.
    void surround(const glm::ivec2& size, bool sphere) {
        row_ = static_cast<std::size_t>(size.x) + 2 * kAround;
        surrounded_.resize(row_ * (static_cast<std::size_t>(size.y) + 2 * kAround));
        constexpr int kFar = static_cast<int>(kAround);
        auto* next = surrounded_.data();
        for (int y = -kFar; y < size.y + kFar; ++y)
            for (int x = -kFar; x < size.x + kFar; ++x) *next++ = entryAt({x, y}, size, sphere);
        for (std::size_t i = 0; i < steps_.size(); ++i)
            steps_[i] = nearSteps()[i].y * static_cast<std::ptrdiff_t>(row_) + nearSteps()[i].x;
    }
    /// The nearest open texel, if possible one with another open one behind it, and that one (else the same again).
    AtlasWord::Source nearestOpen(int x, int y) const {
        const std::uint16_t* at =
            surrounded_.data() + (static_cast<std::size_t>(y) + kAround) * row_ + static_cast<std::size_t>(x) + kAround;
        AtlasWord::Source best;
        for (const std::ptrdiff_t step : steps_) {
            const std::uint16_t entry = at[step];
            if (entry == kBuried) continue;
            const std::uint16_t beyond = at[2 * step];
            if (beyond != kBuried) return {entry, beyond};
            if (best.entry == kBuried) best = {entry, entry};
        }
        return best;
    }
    /// The words of the patch of a shape, whose patches start at a row of the atlas.
    void words(const glm::ivec2& size, bool sphere, std::uint32_t shape, std::uint32_t top) {
        if (std::all_of(entries_.begin(), entries_.end(), [](std::uint16_t e) { return e == kBuried; })) return;
        surround(size, sphere);
        const auto width = static_cast<std::uint32_t>(size.x), height = static_cast<std::uint32_t>(size.y);
        const std::uint32_t perRow = layout_.width / width;
        const std::uint32_t left = shape % perRow * width, row = top + shape / perRow * height;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; x += 4) {
                AtlasWord word;
                word.address =
                    ((row + static_cast<std::uint32_t>(y)) * layout_.width + left + static_cast<std::uint32_t>(x)) / 4;
                word.base = base_;
                bool any = false;
                for (int k = 0; k < 4; ++k) {
                    const int place = y * size.x + x + k;
                    const std::uint16_t own = entries_[static_cast<std::size_t>(place)];
                    word.sources[k] = own != kBuried ? AtlasWord::Source{own, own} : nearestOpen(x + k, y);
                    any = any || word.sources[k].entry != kBuried;
                }
                if (any) found.words.push_back(word);
            }
    }

    const OcclusionLayout& layout_;
    const Representation& r_;
    const PrimitiveTree& tree_;
    std::vector<glm::vec3> normals_;
    std::vector<std::uint32_t> around_;
    static constexpr std::size_t kAround = 4;  // two steps of two texels
    std::vector<std::uint16_t> entries_;       // of the patch: less base_, or kBuried
    std::vector<std::uint16_t> surrounded_;    // the same, with kAround texels about it
    std::size_t row_ = 0;                      // of surrounded_
    std::array<std::ptrdiff_t, 24> steps_{};   // nearSteps() in it
    std::uint32_t base_ = 0;
    std::size_t last_ = 0;
};

/// One value per sphere: all are open.
void openSpheres(OpenTexels& all, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        all.firstOfSphere.push_back(i);
        all.texels.push_back(i);
        if (i % 4 == 0) all.words.push_back({i / 4, i, {}});
        all.words.back().sources[i % 4] = {static_cast<std::uint16_t>(i % 4), static_cast<std::uint16_t>(i % 4)};
    }
    all.sphereTexels = count;
}

/// Of so many primitives a sample has each this many-th.
std::uint32_t sampledEach(std::size_t count) {
    constexpr std::size_t kSample = 500;
    return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(count / kSample));
}

void append(OpenTexels& all, const OpenTexels& part) {
    const auto base = static_cast<std::uint32_t>(all.texels.size());
    all.texels.insert(all.texels.end(), part.texels.begin(), part.texels.end());
    all.sphereTexels += part.sphereTexels;
    for (const std::uint32_t first : part.firstOfSphere) all.firstOfSphere.push_back(base + first);
    for (AtlasWord word : part.words) {
        word.base += base;
        all.words.push_back(word);
    }
}

/// Vertices have their own texels, four per word: no other value can replace them.
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
                      const std::stop_token& stop) {
    OpenTexels all;
    const auto spheres = static_cast<std::uint32_t>(r.spheres.size());
    const auto count = spheres + static_cast<std::uint32_t>(r.cylinders.size());
    const bool whole = layout.sphereEdge == 1;
    if (whole) openSpheres(all, spheres);
    const std::uint32_t first = whole ? spheres : 0;

    const std::uint32_t parts = std::min(threadsPerTask(), 16u);
    std::vector<Finder> finders(parts, Finder(layout, r, tree));
    inParallel(parts, [&](std::size_t part) {
        const auto bound = [&](std::size_t n) {
            return first + static_cast<std::uint32_t>(std::uint64_t{count - first} * n / parts);
        };
        for (std::uint32_t i = bound(part); i < bound(part + 1) && !stop.stop_requested(); ++i)
            if (i < spheres)
                finders[part].sphere(i);
            else
                finders[part].cylinder(i - spheres);
    });
    for (const Finder& finder : finders) append(all, finder.found);
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
