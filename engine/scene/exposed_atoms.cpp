#include "engine/scene/exposed_atoms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace nacre {
namespace {

/// The nearest sphere in each cell of a grid across a direction.
class Sight {
public:
    Sight(std::span<const Sphere> spheres, const glm::vec3& way) : way_(way) {
        across_ = glm::normalize(glm::cross(way, std::abs(way.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
        up_ = glm::cross(way, across_);
        glm::vec2 low(std::numeric_limits<float>::max()), high = -low;
        for (const Sphere& s : spheres) {
            low = glm::min(low, seen(s) - s.radius);
            high = glm::max(high, seen(s) + s.radius);
        }
        // Large parts have larger cells: their number stays bounded.
        constexpr float kCell = 1, kMost = 1024;  // Å, cells per side
        cell_ = std::max({kCell, (high.x - low.x) / kMost, (high.y - low.y) / kMost});
        low_ = low;
        wide_ = static_cast<int>((high.x - low.x) / cell_) + 1;
        high_ = static_cast<int>((high.y - low.y) / cell_) + 1;
        near_.assign(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_), {});
        for (std::uint32_t i = 0; i < spheres.size(); ++i) put(spheres[i], i);
    }
    void addTo(std::vector<float>& areas) const {
        for (const Nearest& n : near_)
            if (n.sphere != UINT32_MAX) areas[n.sphere] += cell_ * cell_;
    }

private:
    struct Nearest {
        float at = -std::numeric_limits<float>::max();
        std::uint32_t sphere = UINT32_MAX;
    };
    glm::vec2 seen(const Sphere& s) const { return {glm::dot(s.center, across_), glm::dot(s.center, up_)}; }
    void put(const Sphere& s, std::uint32_t number) {
        const glm::vec2 at = (seen(s) - low_) / cell_;
        const float reach = s.radius / cell_, depth = glm::dot(s.center, way_);
        const auto first = [&](float c) { return std::max(static_cast<int>(std::ceil(c - reach - 0.5f)), 0); };
        for (int y = first(at.y); y < high_ && static_cast<float>(y) + 0.5f <= at.y + reach; ++y)
            for (int x = first(at.x); x < wide_ && static_cast<float>(x) + 0.5f <= at.x + reach; ++x) {
                const glm::vec2 aside = glm::vec2(x, y) + 0.5f - at;
                const float h = reach * reach - glm::dot(aside, aside);
                Nearest& n =
                    near_[static_cast<std::size_t>(y) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(x)];
                if (h > 0 && depth + std::sqrt(h) * cell_ > n.at) n = {depth + std::sqrt(h) * cell_, number};
            }
    }

    glm::vec3 way_, across_{}, up_{};
    glm::vec2 low_{};
    float cell_ = 1;
    int wide_ = 0, high_ = 0;
    std::vector<Nearest> near_;
};

std::array<glm::vec3, 26> directions() {
    std::array<glm::vec3, 26> ways{};
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) ways[count++] = glm::normalize(glm::vec3(x, y, z));
    return ways;
}

}  // namespace

std::span<const glm::vec3> cubeDirections() {
    static const std::array<glm::vec3, 26> kWays = directions();
    return kWays;
}

std::vector<float> exposedAreas(std::span<const Sphere> spheres) {
    std::vector<float> areas(spheres.size());
    for (const glm::vec3& way : cubeDirections()) Sight(spheres, way).addTo(areas);
    return areas;
}

}  // namespace nacre
