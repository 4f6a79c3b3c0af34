#pragma once
// What the readers of maps share: values as a file holds them, and what becomes of these. Used by read_*.cpp.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/error.h"
#include "engine/molecule/text.h"
#include "engine/volume/density_map.h"
#include "engine/volume/read_map.h"
#include "engine/volume/symmetry.h"

namespace nacre {

[[noreturn]] inline void cannotReadMap(const std::string& name, const std::string& why, std::uint64_t line = 0) {
    if (line > 0) throw Error("cannot read map", name, why, line);
    throw Error("cannot read map", name, why);
}

/// A part of a cell, or a box.
struct MapBox {
    UnitCell cell;
    int spaceGroup = 0;
    std::vector<SymmetryOperation> operations;  ///< of a crystal; empty: those of the space group
    bool crystal = false;
    glm::ivec3 intervals{};  ///< that the cell's edges are divided into
    glm::ivec3 start{};      ///< of the first node
    glm::ivec3 size{};       ///< nodes
    std::array<int, 3> axes{1, 2, 3};
    std::vector<float> values;  ///< a fastest
};

/// Nodes of a grid, before there is room for them. @throws Error if one is none, or they are too many
std::size_t checkedNodes(const std::string& name, const glm::ivec3& size, const MapLimits& limits);

/// The box as it is, or of a crystal the whole cell: by its operations, as far as that tells. What is no finite number
/// becomes unknown. @param shift  of a box: place of its first node, Å @throws Error if nothing is known
DensityMap completed(const std::string& name, const char* format, MapBox box, const MapLimits& limits,
                     const glm::dvec3* shift = nullptr);
/// The same of a grid without a cell: `step` are its edges.
DensityMap completed(const std::string& name, const char* format, const glm::ivec3& size, const glm::dvec3& origin,
                     const glm::dmat3& step, std::vector<float> values);

/// Readers: of whole texts, inflated.
DensityMap readDx(const std::string& name, std::string_view text, const MapLimits& limits);
DensityMap readCube(const std::string& name, std::string_view text, const MapLimits& limits);
DensityMap readDsn6(const std::string& name, std::string_view bytes, const MapLimits& limits);
DensityMap readDensityServer(const std::string& name, std::string_view bytes, const MapLimits& limits);

}  // namespace nacre
