#include "engine/scene/occlusion_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/error.h"

namespace nacre {
namespace {

constexpr std::uint64_t kBytesPerTexel = 1 + 4 + 4;  // atlas, sum, list entry

struct PatchSize {
    std::uint32_t edge, around, along;
};
// From the finest to the coarsest. A bond is a fifth as wide as an atom: half the texels around it, few along it.
constexpr PatchSize kSizes[] = {{16, 12, 8}, {12, 12, 6}, {8, 8, 4}, {4, 4, 2}, {1, 4, 2}};

std::uint32_t roundUp(std::uint64_t value, std::uint32_t step) {
    return static_cast<std::uint32_t>((value + step - 1) / step * step);
}

OcclusionLayout layoutFor(const PatchSize& size, std::size_t spheres, std::size_t cylinders, std::uint32_t maxSize) {
    OcclusionLayout layout;
    layout.sphereEdge = size.edge;
    layout.around = size.around;
    layout.along = size.along;
    layout.sphereCount = static_cast<std::uint32_t>(spheres);
    layout.cylinderCount = static_cast<std::uint32_t>(cylinders);
    // Nearly square, and a multiple of both patch widths (48 is one of 4, 8, 12 and 16).
    const double side = std::sqrt(static_cast<double>(std::max<std::uint64_t>(layout.texelCount(), 1)));
    layout.width = std::min(roundUp(static_cast<std::uint64_t>(side), 48), maxSize / 48 * 48);
    const auto rows = [&](std::uint64_t count, std::uint32_t w, std::uint32_t h) {
        const std::uint64_t perRow = layout.width / w;
        return (count + perRow - 1) / perRow * h;
    };
    const std::uint64_t sphereRows = rows(spheres, size.edge, size.edge);
    const std::uint64_t height = sphereRows + rows(cylinders, size.around, size.along);
    layout.sphereRows = static_cast<std::uint32_t>(std::min<std::uint64_t>(sphereRows, UINT32_MAX));
    layout.height = static_cast<std::uint32_t>(std::min<std::uint64_t>(height, UINT32_MAX));
    return layout;
}

}  // namespace

OcclusionLayout occlusionLayout(std::size_t spheres, std::size_t cylinders, std::uint64_t budgetBytes,
                                std::uint32_t maxSize) {
    for (const PatchSize& size : kSizes) {
        const OcclusionLayout layout = layoutFor(size, spheres, cylinders, maxSize);
        if (layout.height <= maxSize && layout.texelCount() * kBytesPerTexel <= budgetBytes) return layout;
    }
    throw Error("not enough memory for ambient occlusion", "",
                std::to_string(spheres + cylinders) + " primitives need " +
                    std::to_string((spheres + cylinders * 8) * kBytesPerTexel >> 20) + " MB, the budget is " +
                    std::to_string(budgetBytes >> 20) + " MB (render with --occlusion off)");
}

void assignPatches(const OcclusionLayout& layout, Representation& r) {
    const auto address = [&](std::size_t i, std::uint32_t w, std::uint32_t h, std::uint32_t top) {
        const auto perRow = static_cast<std::size_t>(layout.width / w);
        const auto x = static_cast<std::uint32_t>(i % perRow) * w;
        const auto y = static_cast<std::uint32_t>(i / perRow) * h + top;
        return x | y << 16;
    };
    for (std::size_t i = 0; i < r.sphereLooks.size(); ++i)
        r.sphereLooks[i].patch = address(i, layout.sphereEdge, layout.sphereEdge, 0);
    for (std::size_t i = 0; i < r.cylinderLooks.size(); ++i)
        r.cylinderLooks[i].patch = address(i, layout.around, layout.along, layout.sphereRows);
}

std::vector<glm::dmat3> occlusionDirections(int count) {
    constexpr double kGolden = std::numbers::phi;
    std::vector<glm::dmat3> frames;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = 2.0 * std::numbers::pi * std::fmod(i / kGolden, 1.0);
        const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
        const glm::dvec3 w(flat * std::cos(angle), flat * std::sin(angle), z);
        const glm::dvec3 helper = std::abs(w.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
        const glm::dvec3 x = glm::normalize(glm::cross(helper, w)), y = glm::cross(w, x);
        const double roll = 2.0 * std::numbers::pi * std::fmod(i * kGolden * kGolden * kGolden, 1.0);
        const glm::dvec3 u = x * std::cos(roll) + y * std::sin(roll);
        frames.push_back(glm::transpose(glm::dmat3(u, glm::cross(w, u), w)));
    }
    return frames;
}

}  // namespace nacre
