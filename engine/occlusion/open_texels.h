#pragma once
// The texels of the occlusion atlas that light can reach, and the sources of the other texels.

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "engine/occlusion/atlas_layout.h"
#include "engine/occlusion/primitive_tree.h"

namespace nacre {

/// Four adjacent texels of the atlas. 24 bytes; the layout is that of shaders/occlusion_finish.comp.
struct AtlasWord {
    static constexpr std::uint16_t kNone = 0xffff;
    struct Source {
        /// Entry of OpenTexels::texels that gives the value, minus `base`. An open texel is its own source. A buried
        /// one uses the nearest open texel of its patch, at most two texels away; kNone if there is none.
        std::uint16_t entry = kNone;
        /// For a buried texel: the open texel twice as far in the same direction; else the same as `entry`.
        std::uint16_t beyond = kNone;
    };
    std::uint32_t address = 0;  ///< atlas texel, row-major, / 4
    std::uint32_t base = 0;     ///< first entry of the patch; of the left patch, if two share the word
    Source sources[4];
};

struct OpenTexels {
    /// Texels of spheres and cylinders outside all other opaque primitives, in linear order (all sphere patches, then
    /// all cylinder patches): only these can be lit. All texels of vertices follow.
    std::vector<std::uint32_t> texels;
    std::size_t sphereTexels = 0;  ///< number of sphere texels
    std::vector<AtlasWord> words;  ///< those with at least one source
    /// First entry of each sphere, and the end of the last.
    std::vector<std::uint32_t> firstOfSphere;
};

/// Linear in the number of primitives at any density; uses every core.
/// @param stop  when requested, returns early with an incomplete result
/// @param hidden  spheres that the picture does not show: their texels are left out. Empty: none
OpenTexels openTexels(const OcclusionLayout& layout, const Representation& representation, const PrimitiveTree& tree,
                      const std::stop_token& stop = {}, const std::vector<bool>& hidden = {});

/// Updates the words after entries were dropped.
/// @param keptBefore  for each entry, the number of kept entries before it; last: their total
void followKept(std::span<AtlasWord> words, std::span<const std::uint32_t> keptBefore);

/// Whether openShare() would visit every texel, as openTexels() does.
bool samplesAll(const Representation& representation);

/// Fraction of the patches' texels that are open, from a sample of the primitives.
double openShare(const OcclusionLayout& layout, const Representation& representation, const PrimitiveTree& tree);

}  // namespace nacre
