#pragma once
// A scene for other programs: triangles by chain and, optionally, balls and sticks as instances.

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/baked_occlusion.h"
#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/build/representation.h"

namespace nacre::app {

/// Triangles of one chain. Mesh::atoms holds the vertices' colours, packed as in engine/scene/color/colors.h.
struct ExportMesh {
    std::string name;
    Mesh mesh;                             ///< Å, relative to ExportScene::center
    std::vector<glm::dmat4x3> transforms;  ///< of its copies; at least one
    std::vector<float> occlusion;          ///< of the vertices, 0 closed to 1 open; empty: not requested
};

/// Balls of radius 1 about the origin, or sticks of radius 1 along z from 0 to 1, each rotated, scaled and shifted.
struct ExportInstances {
    enum class Shape { ball, stick };
    struct Place {
        glm::vec3 at{};
        glm::quat turn{1, 0, 0, 0};
        glm::vec3 scale{1};
    };
    std::string name;
    Shape shape = Shape::ball;
    std::uint32_t color = 0;
    std::vector<Place> places;  ///< in scene order
    std::vector<glm::dmat4x3> transforms;
};

struct ExportScene {
    glm::dvec3 center{};  ///< Å, in the file's frame
    std::vector<ExportMesh> meshes;
    std::vector<ExportInstances> instances;
    int sides = 0;  ///< vertices around a ball or stick
};

struct ExportOptions {
    bool instances = false;  ///< write balls and sticks as instances, not triangles
    int sides = 0;           ///< vertices around a ball or stick, even; 0: 24, fewer if there are too many
    /// Occlusion of the scene, with spheres and cylinders in spatial order; may be null. Outlives the call. Not with
    /// instances: each copy of a ball has its own occlusion.
    const BakedOcclusion* occlusion = nullptr;
};

constexpr std::size_t kMostExportTriangles = 50'000'000;
constexpr std::size_t kMostExportCopies = 1'000'000;  ///< of groups of instances, together

/// @throws Error if it would have over kMostExportTriangles in all copies, or over kMostExportCopies
ExportScene exportScene(const Molecule& molecule, const Representation& scene, const ExportOptions& options);

/// Triangles in all copies.
std::size_t triangleCount(const ExportScene& scene);

/// The uncoloured unit ball or stick for instances.
Mesh unitShape(ExportInstances::Shape shape, int sides);

}  // namespace nacre::app
