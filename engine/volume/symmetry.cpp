#include "engine/volume/symmetry.h"

#include <cmath>
#include <gemmi/symmetry.hpp>
#include <string>

#include "engine/molecule/space_group.h"

namespace nacre {
namespace {

SymmetryOperation from(const gemmi::Op& op) {
    static_assert(gemmi::Op::DEN == SymmetryOperation::kShift);
    SymmetryOperation result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result.rotation[i][j] = op.rot[i][j] / gemmi::Op::DEN;
        result.shift[i] = op.tran[i];
    }
    return result;
}

}  // namespace

bool SymmetryOperation::isIdentity() const {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (rotation[i][j] != (i == j)) return false;
    return shift[0] % kShift == 0 && shift[1] % kShift == 0 && shift[2] % kShift == 0;
}

std::vector<SymmetryOperation> findOperations(int spaceGroup, const UnitCell& cell) {
    const gemmi::SpaceGroup* group = gemmi::find_spacegroup_by_number(spaceGroup);
    if (group == nullptr) return {};
    // For rhombohedral groups the table lists the hexagonal axes first.
    if (group->ext == 'H' && std::abs(cell.angles.z - cell.angles.x) < 0.1) {
        std::string name = group->hm;
        const gemmi::SpaceGroup* other = gemmi::find_spacegroup_by_name(name + ":R");
        if (other != nullptr) group = other;
    }
    std::vector<SymmetryOperation> operations;
    for (const gemmi::Op& op : group->operations()) operations.push_back(from(op));
    return operations;
}

std::optional<SymmetryOperation> parseOperation(std::string_view text) {
    const std::optional<gemmi::Op> operation = parseTriplet(text);
    return operation ? std::optional(from(*operation)) : std::nullopt;
}

std::optional<NodeOperation> onNodes(const SymmetryOperation& operation, const glm::ivec3& intervals) {
    NodeOperation result;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        for (int j = 0; j < 3; ++j) {
            const long scaled = long{operation.rotation[at][static_cast<std::size_t>(j)]} * intervals[i];
            if (scaled % intervals[j] != 0) return {};
            result.rows[at][static_cast<std::size_t>(j)] = static_cast<int>(scaled / intervals[j]);
        }
        const long shift = long{operation.shift[at]} * intervals[i];
        if (shift % SymmetryOperation::kShift != 0) return {};
        result.shift[at] = static_cast<int>(shift / SymmetryOperation::kShift);
    }
    return result;
}

}  // namespace nacre
