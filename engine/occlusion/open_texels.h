#pragma once
// Which texels of the occlusion atlas light can reach, and what the others take.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/occlusion/atlas_layout.h"
#include "engine/occlusion/primitive_tree.h"

namespace nacre {

/// Four texels of the atlas that lie side by side. 24 bytes; the layout is that of shaders/occlusion_finish.comp.
struct AtlasWord {
    static constexpr std::uint16_t kNone = 0xffff;
    struct Source {
        /// Entry of OpenTexels::texels whose value the texel takes, less `base`: its own; for a texel inside a
        /// neighbour, that of the nearest open one in its patch, at most two texels away; kNone if there is none.
        std::uint16_t entry = kNone;
        /// For a texel inside a neighbour, the open one behind that, as far again; else the same as `entry`.
        std::uint16_t beyond = kNone;
    };
    std::uint32_t address = 0;  ///< texel of the atlas, in rows, / 4
    std::uint32_t base = 0;     ///< first entry of the patch
    Source sources[4];
};

struct OpenTexels {
    /// Texels of spheres and cylinders outside every other of these, in linear order (all sphere patches, then all
    /// cylinder patches): the only ones that any direction can light. Then all of vertices.
    std::vector<std::uint32_t> texels;
    std::size_t sphereTexels = 0;  ///< how many of them belong to spheres
    std::vector<AtlasWord> words;  ///< those with at least one source
    /// First entry of each sphere, and the end of the last.
    std::vector<std::uint32_t> firstOfSphere;
};

/// Linear in the number of primitives, however they crowd; uses every core.
/// @param stop  what is found is of no use once it is asked for: returns early, with less
OpenTexels openTexels(const OcclusionLayout& layout, const Representation& representation, const PrimitiveTree& tree,
                      const std::stop_token& stop = {});

/// Share of the patches' texels that are open, from a sample of the primitives.
double openShare(const OcclusionLayout& layout, const Representation& representation, const PrimitiveTree& tree);

}  // namespace nacre
