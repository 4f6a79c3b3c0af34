#include "engine/molecule/formats/cell_sites.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/molecule/assemblies.h"

namespace nacre {
namespace {

/// A symmetry operation as a transform of Å, shifted by whole cells so that the copy's centre lies in the cell at 0.
TransformRows makeTransform(const gemmi::Op& operation, const gemmi::UnitCell& cell, const gemmi::Fractional& centre) {
    gemmi::Transform fractional;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) fractional.mat[i][j] = double(operation.rot[i][j]) / gemmi::Op::DEN;
        fractional.vec.at(i) = double(operation.tran[i]) / gemmi::Op::DEN;
    }
    const gemmi::Vec3 moved = fractional.apply(centre);
    for (int i = 0; i < 3; ++i) fractional.vec.at(i) -= std::floor(moved.at(i));
    const gemmi::Transform whole = cell.orth.combine(fractional).combine(cell.frac);
    TransformRows rows{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) rows[4 * i + j] = whole.mat.a[i][j];
        rows[4 * i + 3] = whole.vec.at(static_cast<int>(i));
    }
    return rows;
}

/// Indices of the operations that give an atom different positions. On a special position (an axis, a mirror plane, a
/// centre of symmetry) the other operations repeat these.
std::vector<std::uint32_t> distinctPlaces(const gemmi::Fractional& at, const std::vector<gemmi::Op>& operations,
                                          const gemmi::UnitCell& cell) {
    constexpr double kSamePlace = 0.3;            // Å: nearer images are one atom, written with few digits
    constexpr std::size_t kMostOperations = 192;  // of any space group
    const auto same = [&](const gemmi::Fractional& a, const gemmi::Fractional& b) {
        const gemmi::Fractional between(a - b);
        return cell.orthogonalize_difference(gemmi::Fractional(between).wrap_to_zero()).length() < kSamePlace;
    };
    std::vector<std::uint32_t> kept(operations.size());
    std::iota(kept.begin(), kept.end(), 0u);
    if (operations.size() > kMostOperations) return kept;
    std::vector<gemmi::Fractional> images;
    for (const gemmi::Op& operation : operations) {
        const std::array<double, 3> image = operation.apply_to_xyz({at.x, at.y, at.z});
        images.emplace_back(image[0], image[1], image[2]);
    }
    // In a group, either some operation repeats the position of the first, or none repeats any.
    const auto repeats = [&](std::uint32_t i) { return i > 0 && same(images[i], images[0]); };
    if (std::none_of(kept.begin(), kept.end(), repeats)) return kept;
    kept.clear();
    for (std::uint32_t i = 0; i < operations.size(); ++i)
        if (std::none_of(kept.begin(), kept.end(), [&](std::uint32_t known) { return same(images[i], images[known]); }))
            kept.push_back(i);
    return kept;
}

}  // namespace

std::string CellSites::add(const gemmi::Fractional& at) {
    sum_ += at;
    ++atoms_;
    const std::vector<std::uint32_t> kept = distinctPlaces(at, operations_, cell_);
    if (kept.size() >= operations_.size()) return prefix_;  // every operation gives a distinct position
    return groups_.try_emplace(kept, prefix_ + "site " + std::to_string(groups_.size() + 1)).first->second;
}

void CellSites::addUnitCell(MoleculeBuilder& builder) const {
    if (atoms_ == 0 || operations_.empty()) return;
    const gemmi::Fractional centre(sum_ / static_cast<double>(atoms_));
    std::vector<Assembly>& assemblies = builder.molecule().assemblies;
    Assembly assembly{"unit-cell", "content of the unit cell", {}};
    if (!assemblies.empty() && assemblies.back().id == assembly.id) assembly = assemblies.back();
    try {
        AssemblyLimits limits(builder.maxAtoms());
        std::vector<glm::mat4x3> transforms;
        for (const gemmi::Op& operation : operations_) {
            limits.spend(1, 1);
            transforms.push_back(toMatrix(makeTransform(operation, cell_, centre)));
        }
        if (const auto general = builder.subchain(prefix_)) addPart(assembly, {transforms, {*general}});
        for (const auto& [kept, name] : groups_) {
            std::vector<glm::mat4x3> some;
            for (const std::uint32_t i : kept) some.push_back(transforms[i]);
            if (const auto site = builder.subchain(name)) addPart(assembly, {some, {*site}});
        }
    } catch (const AssemblyFault& without) {
        return builder.warn(std::string("the unit cell is left out: ") + without.what());
    }
    if (!assemblies.empty() && assemblies.back().id == assembly.id)
        assemblies.back() = std::move(assembly);
    else
        assemblies.push_back(std::move(assembly));
}

}  // namespace nacre
