#pragma once
// Chooses the level of detail of meshes for a view.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/results.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"

namespace nacre {

/// World-space error (Å) that corresponds to a screen-space error in pixels, anywhere in the view's bounding sphere.
double errorInSpace(const View& view, double pixels);

/// Runs of triangles to draw with an allowed error, Å: for each mesh the coarsest level within it. Numbered as by
/// drawnTriangle(), by lists of copies as in Copies::triangles; without copies, list 0 and no bounds.
std::vector<PrimitiveRun> drawnRuns(const Representation& representation, double error);

/// Size of a device's shape buffer, bytes: spheres, sticks, triangles of all levels, and vertices.
std::uint64_t shapeBytes(const Representation& representation);

/// Drops levels, finest first, until all shapes fit a device's buffer. If the finest meshes alone do not fit, their
/// finest level that fits replaces them, if there is one.
void fitBuffer(Representation& representation, std::uint64_t bytes);

/// Triangles of a frame, numbered as by drawnTriangle().
struct TriangleCall {
    std::uint32_t first = 0, count = 0;
};

/// For each level of any mesh, finest first.
std::vector<MeshLevelCount> countLevels(const Representation& representation, std::span<const TriangleCall> calls);

}  // namespace nacre
