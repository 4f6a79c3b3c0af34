#pragma once
// Meshes as streams: quantised vertices, triangles that index them, and looks that vertices share.

#include <bit>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/scene/build/appearance.h"

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
    static constexpr std::uint32_t kWeightBits = 7, kWeightMask = (1u << kWeightBits) - 1;
    /// 1 minus each corner's weight in the division of the triangle among its looks (Mesh::margins), in 128ths:
    /// kWeightBits for a, then b, then c.
    using Weights = std::uint32_t;

    std::uint32_t a = 0, b = 0, c = 0;  ///< indices into Representation::meshVertices
    std::uint32_t stepAndWeights = std::bit_cast<std::uint32_t>(1.0f);

    Triangle() = default;
    /// @param step  Å: a power of two, so that positions are exact. Its bits below the exponent are 0.
    Triangle(std::uint32_t a_, std::uint32_t b_, std::uint32_t c_, float step, Weights weights = 0)
        : a(a_), b(b_), c(c_), stepAndWeights(std::bit_cast<std::uint32_t>(step) | weights) {}
    float step() const { return std::bit_cast<float>(stepAndWeights & ~weightsMask()); }
    /// @param corner  0 a, 1 b, 2 c
    float weight(int corner) const {
        return 1 - static_cast<float>(stepAndWeights >> corner * kWeightBits & kWeightMask) / (kWeightMask + 1);
    }

private:
    static constexpr std::uint32_t weightsMask() { return (1u << 3 * kWeightBits) - 1; }
};

/// A mesh of a representation: its triangles and coarser levels.
struct MeshRun {
    struct Level {
        float error = 0;                     ///< Å, as in MeshLevel
        std::uint32_t first = 0, count = 0;  ///< range in Representation::coarseTriangles
        std::uint32_t endVertex = 0;         ///< its vertices range from the mesh's first to here
    };
    std::uint32_t first = 0, count = 0;  ///< range in Representation::triangles
    std::vector<Level> levels;           ///< by increasing error
    /// Range in Representation::meshVertices: first those of the coarsest level, then the additions of each finer one.
    std::uint32_t firstVertex = 0, endVertex = 0;
    float error = 0;       ///< Å, of its own triangles: not 0 if the finest ones were too many for a device
    bool surface = false;  ///< of a molecule
    /// Each level is a closed surface with its front outside: unless it is cut, every back is behind some front.
    bool closed = false;
};

/// Whether each edge of some triangles belongs to another one that runs the other way. Vertices at one position count
/// as one: at creases a mesh has one for each side.
bool isClosed(const Representation& representation, std::span<const Triangle> triangles);
/// Whether all triangles belong to closed meshes, and no copy is a mirror image.
bool isSolid(const Representation& representation);

/// A drawn triangle by number; numbering continues with the coarse ones.
const Triangle& drawnTriangle(const Representation& representation, std::size_t number);

constexpr std::uint32_t kPositionBits = 21, kPositionMask = (1u << kPositionBits) - 1;
constexpr std::uint32_t kMiddlePosition = 1u << (kPositionBits - 1);  ///< of the range of a coordinate

/// Position of a vertex, as shaders compute it. Å
inline glm::vec3 decodePosition(const MeshVertex& v, float step) {
    const std::uint32_t z = v.xz >> kPositionBits | v.yz >> kPositionBits << 11;
    const auto coordinate = [&](std::uint32_t bits) {
        return (static_cast<float>(static_cast<std::int32_t>(bits)) - static_cast<float>(kMiddlePosition)) * step;
    };
    return {coordinate(v.xz & kPositionMask), coordinate(v.yz & kPositionMask), coordinate(z)};
}
glm::vec3 decodeNormal(const MeshVertex& vertex);

/// Adds a mesh to the streams. Skips triangles that are not finite or have no area; the others stay connected. Opaque
/// triangles come first (translucency.h), in each level.
/// @param shift   Å, added to every position: from the mesh's origin to that of the representation
/// @param readLook  colour and number of an atom, called once per atom of the mesh
/// @throws Error if the mesh's lists do not fit each other
void appendMesh(const Mesh& mesh, const glm::dvec3& shift, const std::function<SphereLook(std::uint32_t)>& readLook,
                Representation& representation);

}  // namespace nacre
