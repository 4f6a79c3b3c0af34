#pragma once
// Primitives drawn as triangles. Used by primitives.cpp.

#include <array>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/scene/build/primitives.h"

namespace nacre {

/// Combines the triangles of many small solids into one mesh with levels. Meshes of the file stay separate.
class PrimitiveMeshes {
public:
    /// @param all  all primitives: their number decides the detail
    PrimitiveMeshes(Representation& scene, const Primitives& all);

    // Positions in the file's frame; see Primitives.
    void cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& look);
    /// A cylinder whose halves have the looks of its ends.
    void cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius, const PrimitiveLook& lookA,
                  const PrimitiveLook& lookB);
    void cone(const glm::dvec3& base, const glm::dvec3& tip, double radius, const PrimitiveLook& look);
    void ellipsoid(const glm::dvec3& center, const std::array<glm::dvec3, 3>& axes, const PrimitiveLook& look);
    void sector(const Primitives::Ellipse& ellipse);
    /// @param corner  by bits: bit i is 1 at the far end of axis i
    void boxFaces(const std::function<glm::dvec3(unsigned)>& corner, const PrimitiveLook& look);
    void mesh(const Primitives::Mesh& mesh);

    /// Moves the meshes to the scene.
    void finish();

private:
    std::uint32_t numberLook(const PrimitiveLook& look);
    void toAllLevels(std::size_t first);
    void append(const Mesh& mesh);

    Representation& scene_;
    int detail_;  ///< for ellipsoids
    Mesh solids_;
    std::vector<PrimitiveLook> looks_;  ///< by Mesh::atoms
};

}  // namespace nacre
