#include "engine/occlusion/atlas_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nacre {
namespace {

struct PatchSize {
    std::uint32_t edge, around, along;
};
// Finest to coarsest, in steps of at most 1.5. A bond is a fifth as wide as an atom, so it has half the texels around
// it and few along it. The step after 3 x 3 is one value: all four texels of a 2 x 2 octahedral map are the same
// direction.
constexpr PatchSize kSizes[] = {{32, 24, 24}, {28, 24, 17}, {24, 20, 14}, {20, 16, 12}, {17, 12, 11}, {14, 12, 9},
                                {12, 12, 7},  {10, 12, 6},  {9, 12, 5},   {8, 8, 6},    {7, 8, 5},    {6, 8, 4},
                                {5, 8, 3},    {4, 8, 2},    {3, 4, 3},    {1, 4, 2}};

std::uint32_t roundUp(std::uint64_t value, std::uint32_t step) {
    return static_cast<std::uint32_t>((value + step - 1) / step * step);
}

OcclusionLayout layoutFor(const PatchSize& size, std::size_t spheres, std::size_t cylinders, std::size_t vertices,
                          std::uint32_t maxSize) {
    OcclusionLayout layout;
    layout.sphereEdge = size.edge;
    layout.around = size.around;
    layout.along = size.along;
    layout.sphereCount = static_cast<std::uint32_t>(spheres);
    layout.cylinderCount = static_cast<std::uint32_t>(cylinders);
    layout.vertexCount = static_cast<std::uint32_t>(vertices);
    // Nearly square, and a multiple of both patch widths: rows begin with a whole word of four texels.
    const std::uint32_t step = std::lcm(size.edge, size.around);
    const double side = std::sqrt(static_cast<double>(std::max<std::uint64_t>(layout.texelCount(), 1)));
    layout.width = std::max(std::min(roundUp(static_cast<std::uint64_t>(side), step), maxSize / step * step), step);
    const auto rows = [&](std::uint64_t count, std::uint32_t w, std::uint32_t h) {
        const std::uint64_t perRow = layout.width / w;
        return (count + perRow - 1) / perRow * h;
    };
    const std::uint64_t sphereRows = rows(spheres, size.edge, size.edge);
    const std::uint64_t cylinderRows = rows(cylinders, size.around, size.along);
    const std::uint64_t height = sphereRows + cylinderRows + rows(2 * vertices, 1, 1);
    layout.sphereRows = static_cast<std::uint32_t>(std::min<std::uint64_t>(sphereRows, UINT32_MAX));
    layout.cylinderRows = static_cast<std::uint32_t>(std::min<std::uint64_t>(cylinderRows, UINT32_MAX));
    layout.height = static_cast<std::uint32_t>(std::min<std::uint64_t>(height, UINT32_MAX));
    return layout;
}

}  // namespace

std::vector<OcclusionLayout> occlusionLayouts(std::size_t spheres, std::size_t cylinders, std::size_t vertices,
                                              std::uint32_t maxWidth, std::uint32_t maxHeight) {
    std::vector<OcclusionLayout> layouts;
    for (const PatchSize& size : kSizes) {
        const OcclusionLayout layout = layoutFor(size, spheres, cylinders, vertices, maxWidth);
        if (layout.width <= maxWidth && layout.height <= maxHeight) layouts.push_back(layout);
    }
    return layouts;
}

bool holdsItsPatches(const OcclusionLayout& l, std::uint32_t mostSide) {
    const std::uint32_t most = std::min(mostSide, 1u << 16);  // limit of the address bits
    if (l.width == 0 || l.width > most || l.height > most || l.sphereRows > l.height ||
        l.cylinderRows > l.height - l.sphereRows)
        return false;
    const auto fit = [&](std::uint64_t count, std::uint32_t w, std::uint32_t h, std::uint32_t rows) {
        return w > 0 && h > 0 && w <= l.width && (count + l.width / w - 1) / (l.width / w) * h <= rows;
    };
    return fit(l.sphereCount, l.sphereEdge, l.sphereEdge, l.sphereRows) &&
           fit(l.cylinderCount, l.around, l.along, l.cylinderRows) &&
           fit(2 * std::uint64_t{l.vertexCount}, 1, 1, l.height - l.sphereRows - l.cylinderRows);
}

}  // namespace nacre
