#pragma once
// Triangle meshes of Wavefront OBJ and of PLY files.

#include <string>
#include <string_view>

#include "engine/scene/build/primitives.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostMeshVertices = 5'000'000, kMostMeshTriangles = 10'000'000;  ///< 240 MB

/// The vertices and faces of a file; faces of more than three corners become fans. Colours, normals and textures are
/// left out. @param name  for messages @throws Error with the line, or the element and its row
Primitives::Mesh readObj(const std::string& name, std::string_view text);
Primitives::Mesh readPly(const std::string& name, std::string_view bytes);

}  // namespace nacre::app::mvs
