#pragma once
// Triangle meshes of Wavefront OBJ, PLY and VTP files.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/build/primitives.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostMeshVertices = 5'000'000, kMostMeshTriangles = 10'000'000;  ///< 240 MB

/// Where the colours of a mesh come from.
struct MeshColoring {
    enum class Source { scene, vertices, materials, array };
    Source source = Source::scene;
    std::map<std::string, std::uint32_t, std::less<>> materials = {};  ///< of OBJ: packed, by name
    std::string array;                                                 ///< of VTP: its name
    bool arrayOfCells = false;                                         ///< else of points
    std::vector<std::uint32_t> scale;                                  ///< packed colours of its values
    std::optional<std::array<double, 2>> domain;                       ///< of the scale; empty: from the values
};

/// The vertices and faces of a file; faces of more than three corners become fans. Normals and textures are left out.
/// The mesh has no looks if the scene has the colours, or if the file has none.
/// @param name  for messages @throws Error with the line, or the element and its row
Primitives::Mesh readObj(const std::string& name, std::string_view text, const MeshColoring& coloring = {});
Primitives::Mesh readPly(const std::string& name, std::string_view bytes, const MeshColoring& coloring = {});
Primitives::Mesh readVtp(const std::string& name, std::string_view bytes, const MeshColoring& coloring = {});

}  // namespace nacre::app::mvs
