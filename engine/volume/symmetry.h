#pragma once
// Symmetry operations of space groups, by gemmi's tables.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/volume/unit_cell.h"

namespace nacre {

/// x' = rotation x + shift / 24, in fractional coordinates.
struct SymmetryOperation {
    static constexpr int kShift = 24;
    std::array<std::array<int, 3>, 3> rotation{};
    std::array<int, 3> shift{};
    bool isIdentity() const;
};

/// Operations of a space group by its number, in the setting that fits the cell; empty if the group is unknown.
std::vector<SymmetryOperation> findOperations(int spaceGroup, const UnitCell& cell);
/// Parses "-X,Y+1/2,-Z"; empty if malformed.
std::optional<SymmetryOperation> parseOperation(std::string_view text);

/// Maps the nodes of a cell's grid: node' = rows node + shift, before wrapping.
struct NodeOperation {
    std::array<std::array<int, 3>, 3> rows{};
    std::array<int, 3> shift{};
};
/// The operation on nodes; empty if it does not map nodes to nodes.
std::optional<NodeOperation> onNodes(const SymmetryOperation& operation, const glm::ivec3& intervals);

}  // namespace nacre
