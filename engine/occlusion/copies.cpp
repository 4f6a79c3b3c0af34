#include "engine/occlusion/copies.h"

#include <algorithm>
#include <set>

#include "engine/error.h"

namespace nacre {
namespace {

constexpr std::size_t kMostGroups = 100;

std::vector<glm::dmat4x3> picked(const Copies& copies, const std::vector<std::uint32_t>& which) {
    std::vector<glm::dmat4x3> transforms;
    transforms.reserve(which.size());
    for (const std::uint32_t i : which) transforms.push_back(copies.transforms[i]);
    return transforms;
}

/// The entries whose texels lie from one linear index up to another.
OcclusionCopies::Run entries(std::span<const std::uint32_t> texels, std::uint64_t from, std::uint64_t to,
                             bool cylinders, std::uint32_t group) {
    const auto at = [&](std::uint64_t texel) {
        return static_cast<std::size_t>(std::lower_bound(texels.begin(), texels.end(), texel) - texels.begin());
    };
    return {at(from), at(to) - at(from), cylinders, group};
}

}  // namespace

OcclusionCopies occlusionCopies(const Representation& r, const OcclusionLayout& layout,
                                std::span<const std::uint32_t> texels, std::size_t sphereTexels) {
    OcclusionCopies result;
    const Copies& copies = r.copies;
    std::set<std::uint32_t> lists;
    for (const auto* runs : {&copies.spheres, &copies.cylinders})
        for (const PrimitiveRun& run : *runs) lists.insert(run.list);
    if (lists.size() <= 1) {
        if (lists.empty()) result.groups = {{glm::dmat4x3(1.0)}};
        for (const std::uint32_t list : lists)
            result.groups = {picked(copies, representativeCopies(copies.transforms, copies.lists[list], r.radius))};
        result.runs = {{0, sphereTexels, false, 0}, {sphereTexels, texels.size() - sphereTexels, true, 0}};
        return result;
    }
    if (copies.lists.size() > kMostGroups)
        throw Error("cannot bake ambient occlusion", "",
                    "the assembly has more than " + std::to_string(kMostGroups) +
                        " parts with copies of their own (render with --occlusion off)");
    for (const std::vector<std::uint32_t>& list : copies.lists) result.groups.push_back(picked(copies, list));
    const auto add = [&](const std::vector<PrimitiveRun>& runs, std::uint64_t base, std::uint64_t each,
                         bool cylinders) {
        for (const PrimitiveRun& run : runs)
            result.runs.push_back(
                entries(texels, base + run.first * each, base + (run.first + run.count) * each, cylinders, run.list));
    };
    add(copies.spheres, 0, std::uint64_t{layout.sphereEdge} * layout.sphereEdge, false);
    add(copies.cylinders, layout.sphereTexels(), std::uint64_t{layout.around} * layout.along, true);
    return result;
}

}  // namespace nacre
