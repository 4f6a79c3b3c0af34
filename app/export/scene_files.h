#pragma once
// Files of triangles.

#include <string>

#include "app/export/export_scene.h"

namespace nacre::app {

/// Coordinates are written as (p + center) * scale. Also holds the title.
struct SceneFileOptions {
    std::string title;
    double scale = 1;  ///< file units per Å
};

/// Whether a file name has one of the extensions below.
bool isSceneName(const std::string& path);
std::vector<std::string> sceneEndings();

/// Writes the format of the extension: ".glb", ".usdz", ".ply", ".stl" or ".obj".
std::string sceneFile(const ExportScene& scene, const std::string& ending, const SceneFileOptions& options);

/// glTF 2.0, binary. Meshes are nodes by chain, with vertex colours in linear light; instances are nodes with
/// EXT_mesh_gpu_instancing, one per chain and colour; copies of an assembly are nodes with the same mesh.
std::string glbFile(const ExportScene& scene, const SceneFileOptions& options);

constexpr std::size_t kMostUsdzTriangles = 5'000'000;  ///< without copies
constexpr std::size_t kMostUsdzColors = 512 * 512;     ///< a sheet of 2048 x 2048 pixels

/// USDZ: a package with a text layer, a mesh and its copies per chain, whose faces take their colour from a PNG. 1 unit
/// is 1 cm; y is up, and the scene stands on the origin, for augmented reality.
/// @throws Error if it would have over kMostUsdzTriangles or kMostUsdzColors, or over 4 GiB
std::string usdzFile(const ExportScene& scene, const SceneFileOptions& options);

/// PLY, binary: vertices at one position are merged, so that bodies are closed; faces have colours.
std::string plyFile(const ExportScene& scene, const SceneFileOptions& options);

/// STL, binary: triangles only.
std::string stlFile(const ExportScene& scene, const SceneFileOptions& options);

/// Wavefront OBJ: vertices as in PLY, with colours after the coordinates; normals; one group per chain.
std::string objFile(const ExportScene& scene, const SceneFileOptions& options);

}  // namespace nacre::app
