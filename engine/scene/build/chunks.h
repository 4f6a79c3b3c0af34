#pragma once
// Spatially compact parts of the streams: units of culling.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/scene/build/representation.h"

namespace nacre {

/// Primitives 32 i to 32 i + 31 of a stream, with their bounding sphere as stored, Å.
struct Chunk {
    static constexpr std::uint32_t kPrimitives = 32;
    glm::vec3 center{};
    float radius = 0;  ///< the largest float, if a coordinate is NaN
};

struct Chunks {
    std::vector<Chunk> spheres, cylinders;  ///< wires after the cylinders
    std::vector<Chunk> triangles;           ///< numbering continues with the coarse ones
    /// Whether all positions and radii of spheres are finite.
    bool finiteSpheres() const;
};

Chunks makeChunks(const Representation& representation);

/// Indices at which runs of copies or models begin in a stream, and the end of the last.
std::vector<std::uint32_t> runStarts(const std::vector<PrimitiveRun>& copies, const std::vector<ModelRun>& models,
                                     std::size_t count);

/// For each primitive of a stream, its previous index.
struct StreamOrder {
    std::vector<std::uint32_t> spheres, cylinders;
};

/// Sorts spheres and cylinders in Morton order (G. M. Morton, 1966: interleaves the bits of the coordinates), so that
/// neighbours in a stream are neighbours in space. Runs of copies or models stay separate, and so do opaque and
/// translucent primitives within them. Primitives at one position keep their order.
StreamOrder orderInSpace(Representation& representation);

/// Applies an order from orderInSpace(). @param order  for as many spheres and cylinders
void putInOrder(Representation& representation, const StreamOrder& order);

}  // namespace nacre
