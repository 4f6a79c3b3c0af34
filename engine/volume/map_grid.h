#pragma once
// Shared by the readers of maps: values as stored in a file, and their conversion. Used by read_*.cpp.

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
    glm::ivec3 intervals{};  ///< grid intervals along the cell's edges
    glm::ivec3 start{};      ///< index of the first node
    glm::ivec3 size{};       ///< nodes
    std::array<int, 3> axes{1, 2, 3};
    std::vector<float> values;  ///< a fastest
};

/// Number of nodes of a grid, checked before allocation. @param beside  bytes held at the same time
/// @throws Error if it is zero or too large
std::size_t checkedNodes(const std::string& name, const glm::ivec3& size, const MapLimits& limits,
                         std::uint64_t beside = 0);
/// As above for values in a file. @param held  room for values in the file @throws Error if it is too small
std::size_t heldNodes(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::uint64_t held);
/// Checks a crystal's whole cell before its box is read. @throws Error if both together are too large, or the cell is
/// far too large for the box
void checkCell(const std::string& name, const MapBox& box, const MapLimits& limits);

/// The box itself or, for a crystal, the whole cell, completed by symmetry as far as possible. Values that are not
/// finite become unknown. @param shift  of a box: position of its first node, Å @throws Error if no value is known
DensityMap completed(const std::string& name, const char* format, MapBox box, const MapLimits& limits,
                     const glm::dvec3* shift = nullptr);
/// As above for a grid without a cell, with the edges `step`.
DensityMap completed(const std::string& name, const char* format, const glm::ivec3& size, const glm::dvec3& origin,
                     const glm::dmat3& step, std::vector<float> values);

/// Readers of complete, inflated texts.
DensityMap readDx(const std::string& name, std::string_view text, const MapLimits& limits);
DensityMap readCube(const std::string& name, std::string_view text, const MapLimits& limits);
DensityMap readDsn6(const std::string& name, std::string_view bytes, const MapLimits& limits);
DensityMap readDensityServer(const std::string& name, std::string_view bytes, const MapLimits& limits);

/// Grid values in text: numbers between blanks, the last axis fastest.
class GridValues {
public:
    /// @param text  of the values @param perNode  numbers per node: only the first is used
    /// @throws Error if the text has no room for them
    GridValues(const std::string& name, const glm::ivec3& size, const MapLimits& limits, std::string_view text,
               std::size_t perNode = 1);
    /// Reads the expected number of values. @param line  of the text's first @throws Error if some are missing
    void read(std::uint64_t line);
    /// The values, with the first axis fastest.
    std::vector<float> done() { return std::move(values_); }

private:
    const std::string& name_;
    glm::ivec3 size_;
    std::string_view text_;
    std::size_t perNode_;
    std::vector<float> values_;
};

}  // namespace nacre
