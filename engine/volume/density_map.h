#pragma once
// A density map: values on the nodes of a grid. Plain data.

#include <array>
#include <cstddef>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/read_notes.h"
#include "engine/volume/map_values.h"
#include "engine/volume/unit_cell.h"

namespace nacre {

/// Statistics of the known values.
struct MapStatistics {
    double min = 0, max = 0, mean = 0;
    double rms = 0;  ///< root mean square deviation from the mean: 1 sigma
    std::size_t known = 0;
};

struct DensityMap {
    std::string name;                  ///< for messages
    std::string format;                ///< "ccp4", "dx", "cube", "dsn6" or "density-server"
    UnitCell cell;                     ///< of a crystal; otherwise of the box
    int spaceGroup = 0;                ///< number in the International Tables; 0: none
    bool periodic = false;             ///< a crystal: the nodes are those of one cell, which repeats
    glm::ivec3 size{};                 ///< nodes along a, b and c
    glm::dvec3 origin{};               ///< place of node (0, 0, 0), Å
    glm::dmat3 step{1};                ///< columns: from a node to the next along a, b and c, Å
    MapValues values;                  ///< a fastest, c slowest; NaN where unknown
    MapStatistics statistics;          ///< over a crystal's cell, or the box
    std::array<int, 3> axes{1, 2, 3};  ///< the axes (1 to 3: a to c) of the file's columns, rows and sections
    glm::ivec3 boxSize{},
        boxStart{};           ///< nodes in the file along a, b, c, and the position of the first one in the cell
    bool difference = false;  ///< show positive and negative density; for names like "diff" or "fo-fc"
    std::optional<double> depositedLevel;  ///< recommended by the depositors, in the unit of the values
    std::vector<std::string> warnings;     ///< one sentence each
    ReadNotes notes;                       ///< parts of the file that were not read

    std::size_t index(const glm::ivec3& node) const {
        return (static_cast<std::size_t>(node.z) * size.y + node.y) * size.x + node.x;
    }
    glm::dvec3 place(const glm::dvec3& node) const { return origin + step * node; }
    /// Position of the first of the boxSize nodes in the file.
    glm::ivec3 firstNode() const { return periodic ? boxStart : glm::ivec3(0); }
    /// Grid coordinates of a position in Å.
    glm::dvec3 nodeAt(const glm::dvec3& position) const { return glm::inverse(step) * (position - origin); }
};

constexpr float kUnknownDensity = std::numeric_limits<float>::quiet_NaN();

/// Trilinear interpolation; NaN outside of a box, or next to unknown nodes.
double valueAt(const DensityMap& map, const glm::dvec3& position);

/// The level that a fraction of the known values exceeds. Uses a histogram of 2^20 bins.
/// @param share  0..1 @param ofBothSigns  of absolute values
double levelOfTopShare(const DensityMap& map, double share, bool ofBothSigns = false);

MapStatistics computeStatistics(const std::vector<float>& values);

}  // namespace nacre
