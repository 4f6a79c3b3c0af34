#pragma once
// Which of its meshes' levels a view draws.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/results.h"
#include "engine/scene/camera.h"
#include "engine/scene/representation.h"

namespace nacre {

/// Å that a level may be off by for its picture to be off by so many pixels, wherever it stands in the view's ball.
double errorInSpace(const View& view, double pixels);

/// What is drawn of the meshes where they may be off by an error, Å: of each its coarsest level within it. Runs of
/// triangles as drawnTriangle() numbers them, by lists of copies as Copies::triangles; without copies of list 0, and
/// their bounds are not filled in.
std::vector<PrimitiveRun> drawnRuns(const Representation& representation, double error);

/// Bytes of the shapes that a device reads: spheres, sticks, triangles of all levels, and vertices.
std::uint64_t shapeBytes(const Representation& representation);

/// Leaves levels out, the finest first, as long as all shapes together are more than a device's buffer holds. Where
/// meshes are more than that by themselves, they become their finest level that is not, if they have one.
void fitBuffer(Representation& representation, std::uint64_t bytes);

/// Triangles of a frame, as drawnTriangle() numbers them.
struct TriangleCall {
    std::uint32_t first = 0, count = 0;
};

/// Of each level that some mesh has, the finest first.
std::vector<MeshLevelCount> levelsOf(const Representation& representation, std::span<const TriangleCall> calls);

}  // namespace nacre
