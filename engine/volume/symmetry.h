#pragma once
// Symmetry operations of space groups, by gemmi's tables.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/volume/unit_cell.h"

namespace nacre {

/// x' = rotation x + shift / 24, of fractions of a cell.
struct SymmetryOperation {
    static constexpr int kShift = 24;
    std::array<std::array<int, 3>, 3> rotation{};
    std::array<int, 3> shift{};
    bool isIdentity() const;
};

/// Of a space group's number, in the setting that fits the cell; empty if there is no such group.
std::vector<SymmetryOperation> operationsOf(int spaceGroup, const UnitCell& cell);
/// "-X,Y+1/2,-Z"; empty if it is none.
std::optional<SymmetryOperation> parseOperation(std::string_view text);

/// Where an operation takes the nodes of a cell's grid: node' = rows node + shift, before it is wrapped.
struct NodeOperation {
    std::array<std::array<int, 3>, 3> rows{};
    std::array<int, 3> shift{};
};
/// Empty if it takes nodes beside nodes.
std::optional<NodeOperation> onNodes(const SymmetryOperation& operation, const glm::ivec3& intervals);

}  // namespace nacre
