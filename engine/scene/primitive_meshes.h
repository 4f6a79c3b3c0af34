#pragma once
// The primitives that are drawn as triangles. Used by primitives.cpp.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/scene/primitives.h"

namespace nacre {

/// Gathers the triangles of many small solids as one mesh with levels; meshes that are given are their own.
class PrimitiveMeshes {
public:
    /// @param all  that will be drawn: how finely goes by how many there are
    PrimitiveMeshes(Representation& scene, const Primitives& all);

    // Places in the file's frame; see Primitives.
    void cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& look);
    void cone(const glm::dvec3& base, const glm::dvec3& tip, double radius, const PrimitiveLook& look);
    void ellipsoid(const glm::dvec3& center, const std::array<glm::dvec3, 3>& axes, const PrimitiveLook& look);
    void sector(const Primitives::Ellipse& ellipse);
    /// @param corner  by its bits: 1 for the far end of an axis
    void boxFaces(const std::function<glm::dvec3(unsigned)>& corner, const PrimitiveLook& look);
    void mesh(const Primitives::Mesh& mesh);

    /// Hands over to the scene what was gathered.
    void finish();

private:
    std::uint32_t numberOf(const PrimitiveLook& look);
    void toAllLevels(std::size_t first);
    void append(const Mesh& mesh);

    Representation& scene_;
    int detail_;  ///< of ellipsoids
    Mesh solids_;
    std::vector<PrimitiveLook> looks_;  ///< by Mesh::atoms
};

}  // namespace nacre
