#include "engine/occlusion/hidden_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/occlusion/mesh_heights.h"

namespace nacre::occlusion {
namespace {

constexpr float kNothing = -1e30f;

/// Minimum of each value and its neighbours, `around` on either side. @param step  distance of neighbours
void takeLeast(std::vector<float>& values, std::size_t line, std::size_t lines, std::size_t step, std::size_t nextLine,
               int around) {
    std::vector<float> before(line);
    for (std::size_t l = 0; l < lines; ++l) {
        float* at = values.data() + l * nextLine;
        for (std::size_t i = 0; i < line; ++i) before[i] = at[i * step];
        for (std::size_t i = 0; i < line; ++i)
            for (int k = -around; k <= around; ++k) {
                const auto other = static_cast<std::ptrdiff_t>(i) + k;
                const bool outside = other < 0 || other >= static_cast<std::ptrdiff_t>(line);
                at[i * step] = std::min(at[i * step], outside ? kNothing : before[static_cast<std::size_t>(other)]);
            }
    }
}

}  // namespace

HiddenTriangles::HiddenTriangles(const OccluderMeshes& meshes, const glm::dvec3& towards, double radius,
                                 std::uint32_t pixels)
    : pixels_(pixels), perAngstrom_(static_cast<float>(pixels / (2 * radius))), deep_(kDeepPixels / perAngstrom_) {
    const glm::dvec3 other = std::abs(towards.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, towards)), up = glm::cross(towards, right);
    rows_[0] = glm::vec4(right, 0);
    rows_[1] = glm::vec4(up, 0);
    rows_[2] = glm::vec4(towards, 0);
    lowest_.assign(std::size_t{pixels} * pixels, kNothing);
    MeshHeights heights;
    meshes.each([&](const OccluderMesh& mesh) {
        heights.draw(mesh, 0, mesh.triangles.size(), rows_, {lowest_.data(), pixels, pixels, perAngstrom_});
    });
    takeLeast(lowest_, pixels, pixels, 1, pixels, kAround);
    takeLeast(lowest_, pixels, pixels, pixels, 1, kAround);
}

bool HiddenTriangles::hides(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const {
    if (lowest_.empty()) return false;
    const float middle = static_cast<float>(pixels_) / 2;
    const auto onMap = [&](const glm::vec3& p) {
        return glm::vec3(middle + glm::dot(glm::vec3(rows_[0]), p) * perAngstrom_,
                         middle - glm::dot(glm::vec3(rows_[1]), p) * perAngstrom_, glm::dot(glm::vec3(rows_[2]), p));
    };
    const glm::vec3 onA = onMap(a), onB = onMap(b), onC = onMap(c);
    const glm::vec3 low = glm::min(onA, glm::min(onB, onC)), high = glm::max(onA, glm::max(onB, onC));
    if (!(std::min(low.x, low.y) >= 0 && std::max(high.x, high.y) < static_cast<float>(pixels_))) return false;
    const glm::ivec3 first(low), last(high);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            if (lowest_[static_cast<std::size_t>(y) * pixels_ + static_cast<std::size_t>(x)] < high.z + deep_)
                return false;
    return true;
}

}  // namespace nacre::occlusion
