#include "engine/molecule/superpose.h"

#include <algorithm>
#include <cmath>
#include <gemmi/qcp.hpp>
#include <vector>

namespace nacre {

Superposition superpose(std::span<const glm::dvec3> fixed, std::span<const glm::dvec3> moving) {
    const std::size_t count = std::min(fixed.size(), moving.size());
    const auto positions = [&](std::span<const glm::dvec3> points) {
        std::vector<gemmi::Position> list;
        list.reserve(count);
        for (std::size_t i = 0; i < count; ++i) list.emplace_back(points[i].x, points[i].y, points[i].z);
        return list;
    };
    const std::vector<gemmi::Position> a = positions(fixed), b = positions(moving);
    const gemmi::SupResult result = gemmi::superpose_positions(a.data(), b.data(), count, nullptr);
    Superposition s;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) s.rotation[column][row] = result.transform.mat[row][column];
    s.shift = {result.transform.vec.x, result.transform.vec.y, result.transform.vec.z};
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 d = s(moving[i]) - fixed[i];
        sum += d.x * d.x + d.y * d.y + d.z * d.z;
    }
    s.rmsd = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
    return s;
}

}  // namespace nacre
