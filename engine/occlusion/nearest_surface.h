#pragma once
// Finds the first surface that a ray from a primitive meets, on the host.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "engine/occlusion/primitive_tree.h"
#include "engine/scene/build/representation.h"

namespace nacre {

/// A point of an opaque primitive.
struct SurfaceHit {
    std::uint32_t item = 0;  ///< as PrimitiveTree counts, with triangles
    float distance = 0;      ///< from the ray's start, Å
    glm::vec3 normal{};      ///< of spheres and cylinders, unit length
    float share = 0;         ///< of cylinders: position along the axis, 0 to 1
    glm::vec3 shares{};      ///< of triangles: barycentric coordinates
    bool inner = false;      ///< of triangles: seen from behind
};

/// Opaque spheres around another one, in lanes: most rays from it end there.
struct NearSpheres {
    static constexpr float kReach = 4;  ///< Å between the surfaces

    std::vector<std::uint32_t> items;
    // Padded to whole lanes:
    std::vector<float> x, y, z;       ///< centres
    std::vector<float> square;        ///< of the radius
    std::vector<float> squareWithin;  ///< of the radius less a margin: surfaces that coincide do not bury each other

    bool hasEllipsoids = false;

    /// As NearestSurface::buries, but of an ellipsoid only the ball inside it counts.
    bool bury(const glm::vec3& point) const;
};

class NearestSurface {
public:
    /// The representation outlives this.
    explicit NearestSurface(const Representation& r);

    NearSpheres findNear(std::uint32_t sphere) const;
    /// Whether an opaque sphere other than `self` contains this point.
    bool buries(std::uint32_t self, const glm::vec3& point) const;
    /// Translucent primitives, primitives with other copies and models that do not occlude are not met.
    /// @param self  the primitive that the ray leaves @param direction  unit length
    std::optional<SurfaceHit> from(std::uint32_t self, const glm::vec3& start, const glm::vec3& direction) const;
    /// The same in a scene of spheres alone. @param near  findNear(self)
    std::optional<SurfaceHit> from(std::uint32_t self, const glm::vec3& start, const glm::vec3& direction,
                                   const NearSpheres& near) const;

private:
    bool isOpaque(std::uint32_t item) const { return translucent_.empty() || !translucent_[item]; }
    std::optional<SurfaceHit> nearest(std::uint32_t self, const glm::vec3& start, const glm::vec3& direction,
                                      std::optional<SurfaceHit> found) const;
    std::optional<SurfaceHit> meet(std::uint32_t item, const glm::vec3& start, const glm::vec3& direction) const;

    const Representation& r_;
    PrimitiveTree tree_;
    std::vector<bool> translucent_;  // empty: none is
};

}  // namespace nacre
