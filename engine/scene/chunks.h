#pragma once
// Parts of the streams that lie together in space: what a view draws or leaves out at a time.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/representation.h"
#include "engine/scene/sphere_boxes.h"

namespace nacre {

/// Primitives 32 i to 32 i + 31 of a stream, in a ball about them as they are stored, Å.
struct Chunk {
    static constexpr std::uint32_t kPrimitives = 32;
    glm::vec3 center{};
    float radius = 0;  ///< the largest float, if a coordinate is no number
};

struct Chunks {
    std::vector<Chunk> spheres, cylinders;  ///< wires behind the cylinders
    std::vector<Chunk> triangles;           ///< coarse ones numbered on
    SphereBoxes sphereBoxes;
};

Chunks chunksOf(const Representation& representation);

/// For each primitive of a stream the number that it had.
struct StreamOrder {
    std::vector<std::uint32_t> spheres, cylinders;
};

/// Puts spheres, and cylinders, in Morton order of where they stand (G. M. Morton, 1966: the bits of the coordinates
/// alternate), so that neighbours in a stream are neighbours in space. Those of other runs of copies or models stay
/// apart, and what stands at one place keeps its order.
StreamOrder orderInSpace(Representation& representation);

/// Puts them in an order that was found before. @param order  of as many spheres and cylinders
void putInOrder(Representation& representation, const StreamOrder& order);

}  // namespace nacre
