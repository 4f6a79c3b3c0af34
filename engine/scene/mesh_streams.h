#pragma once
// Meshes as streams: quantised vertices, triangles that name them, and the looks that vertices share.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/scene/appearance.h"

namespace nacre {

struct Representation;
struct SphereLook;

/// A vertex as shaders read it (shaders/common/mesh.glsl). 16 bytes.
struct MeshVertex {
    /// Position in steps of its triangles, plus 2^20, 21 bits each: x, then the lower 11 bits of z, in `xz`; y, then
    /// the upper 10 bits of z, in `yz`.
    std::uint32_t xz = 0, yz = 0;
    std::uint32_t normal = 0;  ///< octahedral map (shaders/common/patch.glsl), x and y as 16-bit fractions of [0, 1]
    std::uint32_t look = 0;    ///< index into Representation::meshLooks
};

/// Three vertices, counter-clockwise seen from outside. 16 bytes.
struct Triangle {
    std::uint32_t a = 0, b = 0, c = 0;  ///< indices into Representation::meshVertices
    float step = 1;                     ///< Å: a power of two, so that a position is exactly what its bits say
};

/// A mesh of a representation: its triangles, and what may be drawn in their place.
struct MeshRun {
    struct Level {
        float error = 0;                     ///< Å, as MeshLevel has it
        std::uint32_t first = 0, count = 0;  ///< of Representation::coarseTriangles
        std::uint32_t endVertex = 0;         ///< it has vertices from the mesh's first to here
    };
    std::uint32_t first = 0, count = 0;  ///< of Representation::triangles
    std::vector<Level> levels;           ///< by growing error
    /// Of Representation::meshVertices: first those of the coarsest level, then what the next finer ones add.
    std::uint32_t firstVertex = 0, endVertex = 0;
    float error = 0;  ///< Å, of its own triangles: not 0 where all of them were too many for a device
};

/// By its number among those that are drawn: coarse ones are numbered on.
const Triangle& drawnTriangle(const Representation& representation, std::size_t number);

constexpr std::uint32_t kPositionBits = 21, kPositionMask = (1u << kPositionBits) - 1;
constexpr std::uint32_t kMiddlePosition = 1u << (kPositionBits - 1);  ///< of the range of a coordinate

/// Where a vertex stands, as shaders have it. Å
inline glm::vec3 positionOf(const MeshVertex& v, float step) {
    const std::uint32_t z = v.xz >> kPositionBits | v.yz >> kPositionBits << 11;
    const auto coordinate = [&](std::uint32_t bits) {
        return (static_cast<float>(static_cast<std::int32_t>(bits)) - static_cast<float>(kMiddlePosition)) * step;
    };
    return {coordinate(v.xz & kPositionMask), coordinate(v.yz & kPositionMask), coordinate(z)};
}
glm::vec3 normalOf(const MeshVertex& vertex);

/// Adds a mesh to the streams. What is not finite or has no area is left out; the others' neighbours stay joined.
/// Opaque triangles come first (translucency.h), in each of its levels.
/// @param shift   Å, added to every position: from the mesh's origin to that of the representation
/// @param lookOf  colour and number of an atom, asked once for each atom of the mesh
/// @throws std::invalid_argument if the mesh's lists do not fit each other
void appendMesh(const Mesh& mesh, const glm::dvec3& shift, const std::function<SphereLook(std::uint32_t)>& lookOf,
                Representation& representation);

}  // namespace nacre
