#pragma once
// Occlusion of an assembly. All copies share one patch a primitive; whose surroundings it shows is settled here.

#include <cstddef>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>
#include <vector>

#include "engine/occlusion/atlas_layout.h"
#include "engine/scene/representation.h"

namespace nacre {

struct OcclusionCopies {
    /// Entries of a list of texels that stand at the places of the same copies.
    struct Run {
        enum class Of : std::uint8_t { spheres, cylinders, vertices };
        std::size_t first = 0, count = 0;
        Of of = Of::spheres;
        std::uint32_t group = 0;
        std::uint32_t model = 0;
        float step = 1;  ///< of vertices
    };
    /// Places that direction after direction takes in turn, so that a patch shows their mean. Copies that see the same
    /// as another one are left out, where all primitives have the same copies: of a capsid's sixty one is left.
    std::vector<std::vector<glm::dmat4x3>> groups;
    std::vector<Run> runs;  ///< one model after the other within each list of copies
};

/// @param texels  in linear order, as OpenTexels has them
/// @throws Error if more than 100 parts of the assembly have copies of their own
OcclusionCopies occlusionCopies(const Representation& representation, const OcclusionLayout& layout,
                                std::span<const std::uint32_t> texels);

}  // namespace nacre
