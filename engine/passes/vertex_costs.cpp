#include "engine/passes/vertex_costs.h"

#include "engine/passes/plates.h"

namespace nacre::passes {
namespace {

// Bytes of a vertex's outputs as shaders/*.vert write them.
constexpr std::uint32_t kPosition = 16, kFour = 16, kNumber = 4, kThree = 12, kTwo = 8;
constexpr std::uint32_t kSphere = kPosition + kFour, kCylinder = kPosition + 2 * kFour,
                        kTriangle = kPosition + 3 * kThree + kNumber, kFetched = kPosition + kNumber;
constexpr std::uint32_t kSphereLook = kThree + kTwo, kCylinderLook = 3 * kThree + kTwo, kTriangleLook = 3 * kThree;

/// A polygon of so many corners, or several polygons.
VertexCost polygon(std::uint32_t corners, std::uint32_t bytesOfCorner) {
    return {corners, corners - 2, corners * bytesOfCorner};
}

VertexCost plateCost(PlateShape shape) {
    VertexCost sum;
    for (const Plate& p : listPlates(shape)) {
        const VertexCost plate = polygon(p.corners, kPosition);
        sum = {sum.vertices + plate.vertices, sum.triangles + plate.triangles, sum.bytes + plate.bytes};
    }
    return sum;
}

VertexCost impostorCost(ImpostorShape shape, std::uint32_t bytesOfCorner) {
    switch (shape) {
        case ImpostorShape::square:
            return polygon(4, bytesOfCorner);
        case ImpostorShape::octagon:
            return polygon(8, bytesOfCorner);
        default:
            return {9, 8, 9 * bytesOfCorner};  // a pyramid, indexed: each corner once
    }
}

PassCost impostorCosts(const SphereShapes& shapes, std::uint32_t sphere, std::uint32_t cylinder,
                       std::uint32_t triangle) {
    const std::uint32_t rows = shapes.ellipsoids ? 2 * kFour : 0;
    return {impostorCost(shapes.impostor, sphere + rows), polygon(4, cylinder), polygon(3, triangle)};
}

}  // namespace

SphereShapes chooseShapes(PlateShape plates, ImpostorShape impostor, const graph::GeometryCaps& caps,
                          const PrimitiveCounts& counts) {
    return {choosePlates(plates, caps, counts.radiusPixels),
            chooseImpostor(impostor, caps, counts.radiusPixels, counts.flat), counts.hasEllipsoids};
}

PassCost computeCost(Handed handed, bool stores, const SphereShapes& shapes) {
    switch (handed) {
        case Handed::plates: {
            const bool none = shapes.plates == PlateShape::none;
            return {shapes.ellipsoids ? VertexCost() : plateCost(shapes.plates), VertexCost(),
                    none ? VertexCost() : polygon(3, kPosition)};
        }
        case Handed::depth:
            return impostorCosts(shapes, kSphere, kCylinder, stores ? kFetched : kTriangle);
        case Handed::number:
            return impostorCosts(shapes, kSphere + kNumber, kCylinder + kNumber, kTriangle + kNumber);
        case Handed::shading:
            return impostorCosts(shapes, kSphere + kSphereLook, kCylinder + kCylinderLook, kTriangle + kTriangleLook);
        case Handed::shadingFetched:
            break;
    }
    return impostorCosts(shapes, kPosition + kThree + kNumber, kCylinder + kCylinderLook, kFetched);
}

std::array<std::uint32_t, 3> countBytes(const PassCost& cost) { return {cost[0].bytes, cost[1].bytes, cost[2].bytes}; }

std::array<std::uint64_t, 3> countKinds(const PrimitiveCounts& counts) {
    return {counts.spheres, counts.cylinders, counts.triangles};
}

std::uint64_t countBytes(const PassCost& cost, const PrimitiveCounts& counts) {
    return cost[0].bytes * counts.spheres + cost[1].bytes * counts.cylinders + cost[2].bytes * counts.triangles;
}

}  // namespace nacre::passes
