#pragma once
// Occlusion of an assembly: all copies share one patch per primitive. Selects the copies whose surroundings a patch
// shows.

#include <cstddef>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "engine/occlusion/atlas_layout.h"
#include "engine/scene/build/representation.h"

namespace nacre {

struct OcclusionCopies {
    /// Consecutive list entries of texels that belong to the same copies.
    struct Run {
        enum class Of : std::uint8_t { spheres, cylinders, vertices };
        std::size_t first = 0, count = 0;
        Of of = Of::spheres;
        std::uint32_t group = 0;
        std::uint32_t model = 0;
        float step = 1;  ///< for vertices
    };
    /// Copies that successive directions use in turn, so that a patch shows their mean. If all primitives have the same
    /// copies, symmetry-equivalent ones are left out: one of a capsid's sixty remains.
    std::vector<std::vector<glm::dmat4x3>> groups;
    std::vector<Run> runs;  ///< by model within each list of copies
};

/// @param texels  in linear order, as in OpenTexels
OcclusionCopies occlusionCopies(const Representation& representation, const OcclusionLayout& layout,
                                std::span<const std::uint32_t> texels);

}  // namespace nacre
