#pragma once
// Parts of the streams that lie together in space: what a view draws or leaves out at a time.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/representation.h"

namespace nacre {

/// Primitives 32 i to 32 i + 31 of a stream, in a ball about them as they are stored, Å.
struct Chunk {
    static constexpr std::uint32_t kPrimitives = 32;
    glm::vec3 center{};
    float radius = 0;  ///< the largest float, if a coordinate is no number
};

struct Chunks {
    std::vector<Chunk> spheres, cylinders, triangles;
};

Chunks chunksOf(const Representation& representation);

/// Puts spheres, and cylinders, in Morton order of where they stand (G. M. Morton, 1966: the bits of the coordinates
/// alternate), so that neighbours in a stream are neighbours in space. Those of other runs of copies or models stay
/// apart, and what stands at one place keeps its order.
/// @returns for each sphere the number that it had
std::vector<std::uint32_t> orderInSpace(Representation& representation);

}  // namespace nacre
