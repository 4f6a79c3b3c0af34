#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/scene/occlusion_layout.h"

namespace nacre {
namespace {

/// A uniform grid over primitives: which of them come near a box.
class Grid {
public:
    Grid(const Representation& r) {
        glm::vec3 low(1e30f), high(-1e30f);
        float reach = 0.5f;
        const auto grow = [&](const glm::vec3& p, float radius) {
            low = glm::min(low, p - radius);
            high = glm::max(high, p + radius);
        };
        for (const Sphere& s : r.spheres) grow(s.center, s.radius), reach = std::max(reach, s.radius);
        for (const Cylinder& c : r.cylinders) grow(c.a, c.radius), grow(c.b, c.radius);
        low_ = low;
        // Cells of a diameter, but never more of them than a few per primitive.
        const double volume = double(high.x - low.x) * (high.y - low.y) * (high.z - low.z);
        const double most = 4.0 * static_cast<double>(r.spheres.size() + r.cylinders.size()) + 64.0;
        cell_ = std::max(2.0f * reach, static_cast<float>(std::cbrt(volume / most)));
        for (int i = 0; i < 3; ++i) size_[i] = std::clamp(static_cast<int>((high[i] - low[i]) / cell_) + 1, 1, 1 << 10);
        count(r);
    }

    /// Calls visit(primitive) for spheres (index) and cylinders (spheres + index) that may come within the box.
    template <typename Visit>
    void near(const glm::vec3& low, const glm::vec3& high, Visit&& visit) const {
        const glm::ivec3 a = at(low), b = at(high);
        for (int z = a.z; z <= b.z; ++z)
            for (int y = a.y; y <= b.y; ++y)
                for (int x = a.x; x <= b.x; ++x) {
                    const std::size_t c = index(x, y, z);
                    for (std::uint32_t i = starts_[c]; i < starts_[c + 1]; ++i) visit(items_[i]);
                }
    }

private:
    glm::ivec3 at(const glm::vec3& p) const {
        glm::ivec3 c;
        for (int i = 0; i < 3; ++i) c[i] = std::clamp(static_cast<int>((p[i] - low_[i]) / cell_), 0, size_[i] - 1);
        return c;
    }
    std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * size_[1] + y) * static_cast<std::size_t>(size_[0]) + x;
    }
    template <typename Put>
    void cells(const Representation& r, Put&& put) const {
        std::uint32_t item = 0;
        const auto box = [&](const glm::vec3& low, const glm::vec3& high) {
            const glm::ivec3 a = at(low), b = at(high);
            for (int z = a.z; z <= b.z; ++z)
                for (int y = a.y; y <= b.y; ++y)
                    for (int x = a.x; x <= b.x; ++x) put(index(x, y, z), item);
            ++item;
        };
        for (const Sphere& s : r.spheres) box(s.center - s.radius, s.center + s.radius);
        for (const Cylinder& c : r.cylinders) box(glm::min(c.a, c.b) - c.radius, glm::max(c.a, c.b) + c.radius);
    }
    void count(const Representation& r) {
        starts_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
        cells(r, [&](std::size_t c, std::uint32_t) { ++starts_[c + 1]; });
        for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
        items_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        cells(r, [&](std::size_t c, std::uint32_t item) { items_[next[c]++] = item; });
    }

    glm::vec3 low_{};
    float cell_ = 1;
    glm::ivec3 size_{1};
    std::vector<std::uint32_t> starts_, items_;
};

/// Inside by more than rounding, so that surfaces that coincide stay open.
constexpr float kDeep = 1e-3f;

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
    if (edge == 1) return normals;
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

class Burial {
public:
    explicit Burial(const Representation& r) : r_(r), grid_(r) {}

    void collect(std::uint32_t self, const glm::vec3& low, const glm::vec3& high) {
        around_.clear();
        grid_.near(low, high, [&](std::uint32_t item) {
            if (item != self) around_.push_back(item);
        });
        std::sort(around_.begin(), around_.end());
        around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
        last_ = 0;
    }
    bool buried(const glm::vec3& p) {
        // Neighbouring texels are mostly buried by the same neighbour: ask that one first.
        if (last_ < around_.size() && holds(around_[last_], p)) return true;
        for (std::size_t i = 0; i < around_.size(); ++i)
            if (holds(around_[i], p)) return last_ = i, true;
        return false;
    }

private:
    bool holds(std::uint32_t item, const glm::vec3& p) const {
        return item < r_.spheres.size() ? inside(r_.spheres[item], p)
                                        : inside(r_.cylinders[item - r_.spheres.size()], p);
    }
    const Representation& r_;
    Grid grid_;
    std::vector<std::uint32_t> around_;
    std::size_t last_ = 0;
};

/// Two unit vectors that make a frame with w; the same as frameAbout() in shaders/common/patch.glsl.
void frameAbout(const glm::vec3& w, glm::vec3& u, glm::vec3& v) {
    const float s = w.z >= 0.0f ? 1.0f : -1.0f;
    const float a = -1.0f / (s + w.z), b = w.x * w.y * a;
    u = {1.0f + s * w.x * w.x * a, s * b, -s * w.x};
    v = {b, s + w.y * w.y * a, -w.y};
}

}  // namespace

std::vector<std::uint32_t> openTexels(const OcclusionLayout& layout, const Representation& r) {
    std::vector<std::uint32_t> open;
    if (layout.texelCount() == 0) return open;
    Burial burial(r);
    const std::vector<glm::vec3> normals = octahedralNormals(layout.sphereEdge);
    std::uint32_t texel = 0;
    for (std::uint32_t i = 0; i < r.spheres.size(); ++i) {
        const Sphere& s = r.spheres[i];
        if (layout.sphereEdge == 1) {  // one value for the whole sphere
            open.push_back(texel++);
            continue;
        }
        burial.collect(i, s.center - s.radius, s.center + s.radius);
        for (const glm::vec3& n : normals) {
            if (!burial.buried(s.center + n * s.radius)) open.push_back(texel);
            ++texel;
        }
    }
    texel = static_cast<std::uint32_t>(layout.sphereTexels());
    for (std::uint32_t i = 0; i < r.cylinders.size(); ++i) {
        const Cylinder& c = r.cylinders[i];
        burial.collect(static_cast<std::uint32_t>(r.spheres.size()) + i, glm::min(c.a, c.b) - c.radius,
                       glm::max(c.a, c.b) + c.radius);
        glm::vec3 u, v;
        frameAbout(glm::normalize(c.b - c.a), u, v);
        for (std::uint32_t y = 0; y < layout.along; ++y)
            for (std::uint32_t x = 0; x < layout.around; ++x) {
                const float angle = (static_cast<float>(x) / static_cast<float>(layout.around - 1) - 0.5f) * 2.0f *
                                    std::numbers::pi_v<float>;
                const glm::vec3 p = glm::mix(c.a, c.b, static_cast<float>(y) / static_cast<float>(layout.along - 1)) +
                                    c.radius * (u * std::cos(angle) + v * std::sin(angle));
                if (!burial.buried(p)) open.push_back(texel);
                ++texel;
            }
    }
    return open;
}

}  // namespace nacre
