#pragma once
// Files of triangles.

#include <string>

#include "app/export/export_scene.h"

namespace nacre::app {

/// How coordinates are written: (p + center) * scale, and with what title.
struct SceneFileOptions {
    std::string title;
    double scale = 1;  ///< units of the file to the Å
};

/// Whether a file's name ends in one of those below.
bool isSceneName(const std::string& path);
std::vector<std::string> sceneEndings();

/// The file of the format that an ending names: ".glb", ".ply", ".stl" or ".obj".
std::string sceneFile(const ExportScene& scene, const std::string& ending, const SceneFileOptions& options);

/// glTF 2.0, binary. Meshes are nodes by chain, with colours of vertices in linear light; instances are nodes with
/// EXT_mesh_gpu_instancing, one to each chain and colour; copies of an assembly are nodes of the same mesh.
std::string glbFile(const ExportScene& scene, const SceneFileOptions& options);

/// PLY, binary: vertices are one where they stand at one place, so that bodies are closed; colours are the faces'.
std::string plyFile(const ExportScene& scene, const SceneFileOptions& options);

/// STL, binary: triangles alone.
std::string stlFile(const ExportScene& scene, const SceneFileOptions& options);

/// Wavefront OBJ: vertices as in PLY, with colours behind the coordinates; normals; a group to each chain.
std::string objFile(const ExportScene& scene, const SceneFileOptions& options);

}  // namespace nacre::app
