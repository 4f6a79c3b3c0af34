#include "engine/occlusion/bake_preparation.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/error.h"
#include "engine/occlusion/bounced_light.h"
#include "engine/occlusion/hidden_spheres.h"
#include "engine/occlusion/primitive_tree.h"
#include "engine/scene/build/translucency.h"
#include "engine/scene/instances/sphere_levels.h"

namespace nacre::occlusion {
namespace {

constexpr std::uint64_t kBytesPerTexel = 2;     // of the atlas: the texel, and the byte copied into it
constexpr std::uint64_t kBytesPerOpen = 4 + 8;  // list entry, sums

/// Per vertex: its texel, two list entries, and their words (four entries each).
constexpr std::uint64_t kBytesPerVertex = kBytesPerTexel + 2 * kBytesPerOpen + sizeof(AtlasWord) / 2 + 1;

/// Of an atlas with bounced light: its texel, the bytes that are copied into it, and the texel that it replaces.
constexpr std::uint64_t kPeakBytesPerBounced = 3 * kBytesPerBounced;

/// Width of an atlas for the usual memory: on every device.
constexpr std::uint32_t kUsualSide = 4096;

/// Maximum number of texels regardless of memory: time is proportional to it. With few directions, noise outweighs the
/// benefit of finer patches.
std::uint64_t mostTexels(std::uint64_t primitives, int directions) {
    const double share = std::clamp(directions / 128.0, 0.5, 4.0);
    return static_cast<std::uint64_t>(share * (700'000.0 + 40.0 * static_cast<double>(primitives)));
}

/// Largest useful patch width for the resolution of the depth maps, texels.
double finestEdge(const Representation& r, double pixel) {
    // Patches 32 texels wide suit kPixelsPerSphere. Coarser maps (ligands among meshes) suit coarser patches than the
    // area ratio suggests: 12 texels for 1.7 pixels.
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

Error tooLittleMemory(const Representation& r, std::uint64_t patches, std::uint32_t pixels, std::uint64_t budget) {
    const auto megabytes = [](std::uint64_t bytes) { return std::to_string((bytes >> 20) + 1) + " MB"; };
    return Error("not enough memory for ambient occlusion", "",
                 std::to_string(r.spheres.size() + r.cylinders.size() + r.meshVertices.size()) +
                     " primitives and vertices need " + megabytes(patches) + " beside a depth map of " +
                     megabytes(DepthMapSizes::mostBytes(pixels)) + ", and the limit is " +
                     std::to_string(budget >> 20) + " MB (raise --occlusion-memory, or render with --occlusion off)");
}

Error tooSmallImages(const Representation& r, std::uint32_t side) {
    return Error("cannot bake ambient occlusion", "",
                 std::to_string(r.spheres.size() + r.cylinders.size() + r.meshVertices.size()) +
                     " primitives and vertices do not fit an image of " + std::to_string(side) + " x " +
                     std::to_string(side) + " texels, the device's largest (render with --occlusion off)");
}

/// The finest patches that fit into the given device memory.
struct Patches {
    OcclusionLayout layout;
    OpenTexels open;
    std::uint64_t bytes = 0;  ///< of this layout; if none fits, of the coarsest layout
    bool fit = false;
};

/// Whether a bake is better off with the next coarser patches: if these leave memory for a whole batch of maps, and the
/// finer ones do not. The first picture of 1AON takes 3.9 s of CPU time with 9 texels and 4 maps, 2.5 with 8 and 16.
/// @param patchTexels  open texels of patches
bool givesWay(const OcclusionLayout& layout, const OcclusionLayout& coarser, std::uint64_t patchTexels,
              std::uint64_t roomBesideBatch) {
    constexpr double kLargestStep = 1.5;  // of texels
    if (coarser.patchTexels() == 0) return false;
    const auto bytes = [&](const OcclusionLayout& l, double texels) {
        return bakeBytes(l, static_cast<std::uint64_t>(texels) + 2 * std::uint64_t{l.vertexCount}, l.texelCount() / 4);
    };
    const double texels = static_cast<double>(patchTexels),
                 step = static_cast<double>(layout.patchTexels()) / static_cast<double>(coarser.patchTexels());
    return step <= kLargestStep && bytes(layout, texels) > roomBesideBatch &&
           bytes(coarser, texels / step) <= roomBesideBatch;
}

/// The spheres that the only view does not show, found when they are first asked for.
class SpheresNotShown {
public:
    /// All arguments outlive this.
    SpheresNotShown(const Representation& r, const BakeOptions& options, const std::stop_token& stop)
        : r_(r), options_(options), stop_(stop) {}
    /// Empty: any may be seen, or a single value per sphere stands for all its texels.
    const std::vector<bool>& operator()(const OcclusionLayout& layout) {
        if (layout.sphereEdge == 1) return none_;
        if (!found_)
            found_ =
                mayHide() ? hiddenSpheres(r_.spheres, options_.viewDirection->towards, stop_) : std::vector<bool>();
        return *found_;
    }

private:
    bool mayHide() const {
        const bool sticks = 2 * r_.cylinders.size() > r_.spheres.size();  // they and small balls hide few entirely
        return options_.viewDirection && !sticks && r_.ellipsoids.empty() && r_.copies.transforms.empty() &&
               translucentParts(r_).empty();
    }

    const Representation& r_;
    const BakeOptions& options_;
    const std::stop_token& stop_;
    std::optional<std::vector<bool>> found_;
    const std::vector<bool> none_;
};

/// Device memory for patches: beside one depth map, and beside a whole batch; 0 if no batch fits.
struct PatchRoom {
    std::uint64_t besideMap = 0, besideBatch = 0;
};

/// @param pixel  of the depth maps, Å @param least  patches narrower than this are only estimated: they do not fit
Patches finestPatches(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                      const PrimitiveTree& tree, SpheresNotShown& notShown, const PatchRoom& rooms, double pixel,
                      double least, const std::stop_token& stop) {
    const std::uint64_t room = rooms.besideMap;
    const std::size_t spheres = representation.spheres.size(), cylinders = representation.cylinders.size();
    Patches result;
    const double finest = finestEdge(representation, pixel);
    const std::size_t vertices = representation.meshVertices.size();
    const std::uint32_t side = options.budgetBytes <= OcclusionSettings::kUsualBytes
                                   ? std::min(kUsualSide, caps.maxImageSize)
                                   : caps.maxImageSize;
    const std::uint32_t height = options.bounce ? side / 2 : side;  // bounced light fills a second half
    const std::vector<OcclusionLayout> layouts = occlusionLayouts(spheres, cylinders, vertices, side, height);
    if (layouts.empty()) {
        if (side == caps.maxImageSize) throw tooSmallImages(representation, side);
        result.bytes = options.budgetBytes;  // more memory allows larger images
    }
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const OcclusionLayout& layout = layouts[i];
        if (stop.stop_requested()) return result;
        if (layout.sphereEdge > options.detail || layout.sphereEdge > finest) continue;
        // Estimated from a sample first: visiting every texel takes longer.
        result.bytes = bakeBytes(layout, 0, 0);
        if (result.bytes > room) continue;
        if (options.bounce && bouncedBytes(layout) > options.budgetBytes) {
            result.bytes = bouncedBytes(layout);
            continue;
        }
        const bool few = samplesAll(representation);
        if (few) result.open = openTexels(layout, representation, tree, stop);
        const auto guess = few ? result.open.texels.size() - 2 * vertices
                               : static_cast<std::uint64_t>(openShare(layout, representation, tree) *
                                                            static_cast<double>(layout.patchTexels()));
        result.bytes = bakeBytes(layout, guess + 2 * vertices, (guess + 2 * vertices) / 4);
        if (result.bytes > room ||
            (layout.sphereEdge > 1 && guess > mostTexels(spheres + cylinders, options.directions)))
            continue;
        if (i + 1 < layouts.size() && givesWay(layout, layouts[i + 1], guess, rooms.besideBatch)) continue;
        result.layout = layout;
        if (layout.sphereEdge < least) return result;
        if (!few) result.open = openTexels(layout, representation, tree, stop, notShown(layout));
        result.bytes = bakeBytes(layout, result.open.texels.size(), result.open.words.size());
        if (result.bytes > room) continue;
        result.fit = true;
        return result;
    }
    return result;
}

}  // namespace

std::uint64_t bakeBytes(const OcclusionLayout& layout, std::uint64_t openTexels, std::uint64_t words) {
    return std::uint64_t{layout.width} * layout.height * kBytesPerTexel + openTexels * kBytesPerOpen +
           words * sizeof(AtlasWord);
}

std::uint64_t bouncedBytes(const OcclusionLayout& layout) {
    return std::uint64_t{layout.width} * layout.height * kPeakBytesPerBounced;
}

BakePreparation prepareBake(const gpu::Caps& caps, const Representation& representation, const BakeOptions& options,
                            const std::stop_token& stop) {
    if (!hasNumbers(representation))
        throw Error("cannot bake ambient occlusion", "",
                    "the assembly has " + std::to_string(spheresInCopies(representation)) +
                        " spheres in its copies, more than a bake can tell apart (render with --occlusion off)");
    const std::uint64_t budget = options.budgetBytes;
    const std::uint64_t ofVertices = representation.meshVertices.size() * kBytesPerVertex;
    // One map may take half of the memory that vertices leave. Patches are the finest that fit beside it, or one step
    // coarser for a larger batch (givesWay()); more maps per batch use the rest. The map shrinks if not even the
    // coarsest patches fit.
    const std::uint64_t half = (budget - std::min(ofVertices, budget)) / 2;
    const PrimitiveTree tree(representation);
    SpheresNotShown notShown(representation, options, stop);
    BakePreparation result;
    Patches patches;
    std::uint32_t pixels = 0;
    double pixel = 0;
    const auto choose = [&](std::uint64_t room, std::uint32_t detail, double least = 0) {
        pixels = DepthMapSizes::pixelsFor(representation, room, detail, options.moving);
        pixel = 2 * representation.radius / pixels;
        const std::uint64_t ofMap = DepthMapSizes::mostBytes(pixels),
                            ofBatch = DepthMapSizes::batchBytes(representation, pixels, half);
        const PatchRoom rooms{budget - std::min(ofMap, budget), ofBatch > 0 ? budget - ofBatch : 0};
        patches = finestPatches(caps, representation, options, tree, notShown, rooms, pixel, least, stop);
    };
    // Narrow patches do with coarser maps, which leave memory for more of them at once, or for finer patches. Vertices
    // of meshes do not.
    const bool mayShrink = representation.meshVertices.empty();
    const double narrow = mayShrink ? std::min<double>(DepthMapSizes::kFullDetail, options.detail) : 0;
    choose(half, options.detail, narrow);
    if (const std::uint32_t edge = patches.layout.sphereEdge; !patches.fit && edge > 0 && edge < narrow)
        choose(half, edge);
    for (std::uint32_t before = 0; !patches.fit && pixels != before && !stop.stop_requested();) {
        before = pixels;
        choose(budget - std::min(patches.bytes, budget), options.detail);
    }
    if (stop.stop_requested()) return result;
    if (!patches.fit) throw tooLittleMemory(representation, patches.bytes, pixels, budget);
    result.layout = patches.layout;
    result.open = std::move(patches.open);
    result.maps = {caps, representation, options.path, pixels, std::min(half, budget - patches.bytes)};
    if (options.path == OcclusionMaps::tiles)
        result.occluders = OccluderMeshes(representation, DepthMapSizes::kMeshError * pixel, static_cast<float>(pixel));
    if (options.viewDirection && representation.copies.transforms.empty()) {
        HiddenTriangles hidden;
        if (options.path == OcclusionMaps::tiles && !representation.triangles.empty() &&
            translucentParts(representation).empty())
            hidden = {result.occluders, options.viewDirection->towards, representation.radius, pixels};
        keepSeen(result.open, result.layout, representation, *options.viewDirection, hidden);
    }
    result.copies = occlusionCopies(representation, result.layout, result.open.texels);
    return result;
}

}  // namespace nacre::occlusion
