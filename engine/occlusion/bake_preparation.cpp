#include "engine/occlusion/bake_preparation.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/occlusion/depth_maps.h"
#include "engine/occlusion/primitive_tree.h"
#include "engine/scene/build/translucency.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre::occlusion {
namespace {

constexpr std::uint64_t kBytesPerTexel = 2;     // of the atlas: the texel, and the byte that is copied into it
constexpr std::uint64_t kBytesPerOpen = 4 + 8;  // list entry, sums

/// Per vertex: its texel, and two list entries, whose words are a quarter as many.
constexpr std::uint64_t kBytesPerVertex = kBytesPerTexel + 2 * kBytesPerOpen + sizeof(AtlasWord) / 2 + 1;

/// Maximum of texels regardless of memory: time is proportional to them. With few directions noise outweighs the
/// benefit of finer patches.
std::uint64_t mostTexels(std::uint64_t primitives, int directions) {
    const double share = std::clamp(directions / 128.0, 0.5, 4.0);
    return static_cast<std::uint64_t>(share * (700'000.0 + 40.0 * static_cast<double>(primitives)));
}

/// Largest useful patch width for the resolution of the depth maps, texels.
double finestEdge(const Representation& r, double pixel) {
    // Patches 32 texels wide suit kPixelsPerSphere. Coarser maps (ligands among meshes) carry less than the area ratio
    // suggests: 12 texels suit 1.7 pixels.
    constexpr double kFullRadius = 2.7, kFullEdge = 32, kLeastEdge = 12;
    double sum = 0, weights = 0;
    for (const Sphere& s : r.spheres) {
        const double area = static_cast<double>(s.radius) * static_cast<double>(s.radius);
        sum += area * static_cast<double>(s.radius);
        weights += area;
    }
    const double share = sum / std::max(weights, 1e-9) / pixel / kFullRadius;
    return r.spheres.empty() ? kFullEdge : std::max(kFullEdge * share * share, kLeastEdge);
}

/// The finest patches for which everything fits the budget.
BakePreparation prepared(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                         std::uint64_t mapBytes, double pixel, const std::stop_token& stop) {
    const std::uint64_t budgetBytes = options.budgetBytes - std::min(mapBytes, options.budgetBytes);
    const std::size_t spheres = representation.spheres.size(), cylinders = representation.cylinders.size();
    const PrimitiveTree tree(representation);
    BakePreparation result;
    std::uint64_t least = 0;
    const double finest = finestEdge(representation, pixel);
    const std::size_t vertices = representation.meshVertices.size();
    for (const OcclusionLayout& layout : occlusionLayouts(spheres, cylinders, vertices, caps.maxImageSize)) {
        if (stop.stop_requested()) return result;
        if (layout.sphereEdge > options.detail || layout.sphereEdge > finest) continue;
        // Estimated from a sample first: visiting every texel takes longer.
        least = bakeBytes(layout, 0, 0);
        if (least > budgetBytes) continue;
        const bool few = samplesAll(representation);
        if (few) result.open = openTexels(layout, representation, tree, stop);
        const auto guess = few ? result.open.texels.size() - 2 * vertices
                               : static_cast<std::uint64_t>(openShare(layout, representation, tree) *
                                                            static_cast<double>(layout.patchTexels()));
        least = bakeBytes(layout, guess + 2 * vertices, (guess + 2 * vertices) / 4);
        if (least > budgetBytes ||
            (layout.sphereEdge > 1 && guess > mostTexels(spheres + cylinders, options.directions)))
            continue;
        if (!few) result.open = openTexels(layout, representation, tree, stop);
        least = bakeBytes(layout, result.open.texels.size(), result.open.words.size());
        if (least > budgetBytes) continue;
        result.layout = layout;
        return result;
    }
    throw Error("not enough memory for ambient occlusion", "",
                std::to_string(spheres + cylinders + vertices) + " primitives and vertices need " +
                    std::to_string((least >> 20) + 1) + " MB beside " + std::to_string(mapBytes >> 20) +
                    " MB of depth maps, and " + std::to_string(budgetBytes >> 20) +
                    " MB are left of the budget (raise --occlusion-memory, or " + "render with --occlusion off)");
}

}  // namespace

std::uint64_t bakeBytes(const OcclusionLayout& layout, std::uint64_t openTexels, std::uint64_t words) {
    return std::uint64_t{layout.width} * layout.height * kBytesPerTexel + openTexels * kBytesPerOpen +
           words * sizeof(AtlasWord);
}

std::uint64_t mapBudget(std::uint64_t bytes, const Representation& representation) {
    const std::uint64_t vertices = std::min(representation.meshVertices.size() * kBytesPerVertex, bytes);
    return std::min(bytes / 2, bytes - vertices);
}

BakePreparation prepareBake(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                            const std::stop_token& stop) {
    if (!hasNumbers(representation))
        throw Error("cannot bake ambient occlusion", "",
                    "the assembly has " + std::to_string(spheresInCopies(representation)) +
                        " spheres in its copies, more than a bake can tell apart (render with --occlusion off)");
    const std::uint64_t room = mapBudget(options.budgetBytes, representation);
    const DepthMapSizes maps(caps, representation, options.path, room, options.detail);
    const double pixel = maps.pixel(representation);
    BakePreparation result = prepared(caps, representation, options, maps.bytes, pixel, stop);
    if (stop.stop_requested()) return result;
    if (options.path == OcclusionMaps::tiles)
        result.occluders = OccluderMeshes(representation, DepthMapSizes::kMeshError * pixel, static_cast<float>(pixel));
    if (options.viewDirection && representation.copies.transforms.empty()) {
        HiddenTriangles hidden;
        if (options.path == OcclusionMaps::tiles && !representation.triangles.empty() &&
            translucentParts(representation).empty())
            hidden = {result.occluders, options.viewDirection->towards, representation.radius, maps.pixels};
        keepSeen(result.open, result.layout, representation, *options.viewDirection, hidden);
    }
    result.copies = occlusionCopies(representation, result.layout, result.open.texels);
    return result;
}

}  // namespace nacre::occlusion
