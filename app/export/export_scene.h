#pragma once
// A scene as other programs take it: triangles by chain, and, if wanted, balls and sticks as instances of one another.

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "engine/baked_occlusion.h"
#include "engine/mesh/mesh.h"
#include "engine/molecule/molecule.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// Triangles of one chain. Mesh::atoms holds the colours of the vertices, packed as in engine/scene/colors.h.
struct ExportMesh {
    std::string name;
    Mesh mesh;                             ///< Å, relative to ExportScene::center
    std::vector<glm::dmat4x3> transforms;  ///< of its copies; at least one
    std::vector<float> occlusion;          ///< of the vertices, 0 closed to 1 open; empty: none was asked for
};

/// Balls of radius 1 about the origin, or sticks of radius 1 along z from 0 to 1, each turned, scaled and shifted.
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
    std::vector<Place> places;  ///< in the order of the scene
    std::vector<glm::dmat4x3> transforms;
};

struct ExportScene {
    glm::dvec3 center{};  ///< Å, in the file's frame
    std::vector<ExportMesh> meshes;
    std::vector<ExportInstances> instances;
    int sides = 0;  ///< vertices around a ball or stick
};

struct ExportOptions {
    bool instances = false;  ///< balls and sticks as such, else as triangles
    int sides = 0;           ///< vertices around a ball or stick, even; 0: 24, fewer where they would be too many
    /// Of the scene, whose spheres and cylinders are in the order of space; null: none. Outlives the call. Not with
    /// instances: a ball that is drawn many times lies in many shades.
    const BakedOcclusion* occlusion = nullptr;
};

constexpr std::size_t kMostExportTriangles = 50'000'000;

/// @throws Error if it would have over kMostExportTriangles, all copies counted
ExportScene exportScene(const Molecule& molecule, const Representation& scene, const ExportOptions& options);

/// Triangles, copies counted.
std::size_t triangleCount(const ExportScene& scene);

/// The ball or stick that instances are of, with no colour.
Mesh unitShape(ExportInstances::Shape shape, int sides);

}  // namespace nacre::app
