#pragma once
// Vertices, triangles and bytes of a primitive in a vertex stage. Makes no Vulkan calls.

#include <array>
#include <cstdint>

#include "engine/device_options.h"
#include "engine/graph/plan.h"

namespace nacre::passes {

/// Primitives that a view submits, in all copies, and their size in the picture.
struct PrimitiveCounts {
    std::uint64_t spheres = 0, cylinders = 0, triangles = 0;
    double radiusPixels = 0;     ///< mean radius of the spheres
    bool flat = false;           ///< no tilted facets (SceneView::flat())
    bool hasEllipsoids = false;  ///< the scene has some: vertices of all spheres pass their rows, and none has a plate
};

/// Outputs of the vertex stage of a pass.
enum class Handed : std::uint8_t {
    plates,          ///< positions
    depth,           ///< inputs of the fragments' depth
    number,          ///< inputs of depth, and the primitive's number
    shading,         ///< inputs of shading
    shadingFetched,  ///< a number by which fragments fetch the inputs of shading
};

/// Shapes of spheres, resolved.
struct SphereShapes {
    PlateShape plates{};
    ImpostorShape impostor{};
    bool ellipsoids = false;  ///< PrimitiveCounts::hasEllipsoids
};
/// Shapes of spheres of a view. @param plates, impostor  as requested
SphereShapes chooseShapes(PlateShape plates, ImpostorShape impostor, const graph::GeometryCaps& caps,
                          const PrimitiveCounts& counts);

struct VertexCost {
    std::uint32_t vertices = 0, triangles = 0, bytes = 0;
};
/// Of a sphere, a cylinder and a triangle.
using PassCost = std::array<VertexCost, 3>;

/// Cost of a primitive of each kind. @param stores  GeometryCaps::storesVaryings
PassCost computeCost(Handed handed, bool stores, const SphereShapes& shapes);

/// Bytes of a primitive of each kind.
std::array<std::uint32_t, 3> countBytes(const PassCost& cost);
/// The primitives of a view's passes, by kind.
std::array<std::uint64_t, 3> countKinds(const PrimitiveCounts& counts);
/// Bytes of all primitives.
std::uint64_t countBytes(const PassCost& cost, const PrimitiveCounts& counts);

}  // namespace nacre::passes
