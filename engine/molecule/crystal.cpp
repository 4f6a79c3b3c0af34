#include "engine/molecule/crystal.h"

#include <algorithm>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <tuple>

#include "engine/error.h"
#include "engine/molecule/space_group.h"
#include "engine/molecule/text.h"
#include "engine/molecule/trajectory/trajectory.h"

namespace nacre {
namespace {

struct Crystal {
    gemmi::UnitCell cell;
    gemmi::GroupOps group;
    std::vector<gemmi::Op> operations;
    glm::dvec3 middle{};   ///< of the atoms, Å
    gemmi::Fractional at;  ///< the same in fractional coordinates
};

glm::dvec3 findMiddle(const Molecule& molecule) {
    glm::dvec3 middle(0);
    for (const Atom& atom : molecule.atoms)
        middle += glm::dvec3(atom.position) / static_cast<double>(molecule.atoms.size());
    return middle;
}

Crystal makeCrystal(const Molecule& molecule) {
    const auto fail = [](const std::string& why) -> void { throw Error("cannot build symmetry", "", why); };
    const FileSummary& file = molecule.file;
    if (!file.cell && !file.box) fail("the file states no unit cell");
    const bool boxed = file.box && !file.cell;  // a periodic box has only translations
    const auto& repeats = file.boxRepeats;
    if (boxed && std::find(repeats.begin(), repeats.end(), true) == repeats.end()) fail("its box does not repeat");
    const gemmi::SpaceGroup* group = findSpaceGroup(boxed ? "P 1" : file.spaceGroup);
    if (!group)
        fail(file.spaceGroup.empty() ? "the file states no space group"
                                     : "there is no space group '" + printable(file.spaceGroup) + "'");
    Crystal crystal;
    if (boxed) {
        gemmi::Transform edges;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                edges.mat[j][i] = static_cast<double>((*file.box)[static_cast<std::size_t>(i)][j]);
        crystal.cell.orth = edges;
        crystal.cell.frac = edges.inverse();
        crystal.cell.volume = std::abs(edges.mat.determinant());
    } else {
        const std::array<double, 6>& c = *file.cell;
        crystal.cell.set(c[0], c[1], c[2], c[3], c[4], c[5]);
    }
    if (!(crystal.cell.volume > 1e-6 && std::isfinite(crystal.cell.volume))) fail("the unit cell has no volume");
    crystal.group = group->operations();
    for (const gemmi::Op operation : crystal.group) crystal.operations.push_back(operation);
    crystal.middle = findMiddle(molecule);
    crystal.at = crystal.cell.fractionalize({crystal.middle.x, crystal.middle.y, crystal.middle.z});
    return crystal;
}

/// An operation on fractional coordinates, shifted by some cells.
gemmi::Transform shifted(const gemmi::Op& operation, const std::array<int, 3>& cells) {
    gemmi::Transform fractional;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) fractional.mat[i][j] = double(operation.rot[i][j]) / gemmi::Op::DEN;
        fractional.vec.at(i) = double(operation.tran[i]) / gemmi::Op::DEN + cells[static_cast<std::size_t>(i)];
    }
    return fractional;
}

glm::dmat4x3 inSpace(const Crystal& crystal, const gemmi::Transform& fractional) {
    const gemmi::Transform whole = crystal.cell.orth.combine(fractional).combine(crystal.cell.frac);
    glm::dmat4x3 motion(1.0);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) motion[j][i] = whole.mat[i][j];
        motion[3][i] = whole.vec.at(i);
    }
    return motion;
}

/// An operation as a motion in space, into the cell of the middle, shifted by some cells.
glm::dmat4x3 makeMotion(const Crystal& crystal, const gemmi::Op& operation, const std::array<int, 3>& cells) {
    gemmi::Transform fractional = shifted(operation, cells);
    const gemmi::Vec3 moved = shifted(operation, {}).apply(crystal.at);
    for (int i = 0; i < 3; ++i) fractional.vec.at(i) += std::floor(crystal.at.at(i)) - std::floor(moved.at(i));
    return inSpace(crystal, fractional);
}

/// The operations in the order of the International Tables: powers of each generator times those before it.
std::vector<gemmi::Op> orderedOperations(const gemmi::GroupOps& group) {
    constexpr const char* kGenerators[] = {"-y,x-y,z", "-x,-y,z", "-y,x,z",   "-x,y,-z", "x,-y,-z",
                                           "z,x,y",    "y,x,-z",  "-y,-x,-z", "-x,-y,-z"};
    const auto find = [](const std::vector<gemmi::Op>& list, const gemmi::Op::Rot& rotation) {
        return std::ranges::find_if(list, [&](const gemmi::Op& one) { return one.rot == rotation; });
    };
    const bool centric = group.is_centrosymmetric();
    const bool cubic = find(group.sym_ops, gemmi::parse_triplet("z,x,y").rot) != group.sym_ops.end();
    std::vector<gemmi::Op> all{gemmi::Op::identity()};
    for (const char* text : kGenerators) {
        const gemmi::Op generator = gemmi::parse_triplet(text);
        if (cubic && text == kGenerators[2]) continue;  // the fourfold axis follows from the diagonal ones
        for (const bool negated : {false, true}) {
            if (negated && centric) continue;
            const gemmi::Op::Rot rotation = negated ? generator.negated_rot() : generator.rot;
            const auto own = find(group.sym_ops, rotation);
            if (own == group.sym_ops.end() || find(all, rotation) != all.end()) continue;
            const std::size_t before = all.size();
            for (gemmi::Op power = *own; find(all, power.rot) == all.end(); power = power * *own)
                for (std::size_t i = 0; i < before; ++i) all.push_back(power * all[i]);
            break;
        }
    }
    std::vector<gemmi::Op> centred;
    for (const gemmi::Op::Tran& shift : group.cen_ops)
        for (const gemmi::Op& one : all) centred.push_back(one.add_centering(shift));
    return centred;
}

bool isIdentity(const glm::dmat4x3& motion) {
    const glm::dmat4x3 still(1.0);
    for (int column = 0; column < 4; ++column)
        if (glm::length(motion[column] - still[column]) > 1e-6) return false;
    return true;
}

/// Atoms in a grid, to find those near a point.
class AtomGrid {
public:
    AtomGrid(const Molecule& molecule, double distance) : molecule_(molecule), distance_(distance), edge_(distance) {
        for (std::uint32_t i = 0; i < molecule.atoms.size(); ++i)
            cells_[findCell(glm::dvec3(molecule.atoms[i].position))].push_back(i);
    }
    bool isNear(const glm::dvec3& p) const {
        const auto [x, y, z] = findCell(p);
        for (long i = x - 1; i <= x + 1; ++i)
            for (long j = y - 1; j <= y + 1; ++j)
                for (long k = z - 1; k <= z + 1; ++k) {
                    const auto found = cells_.find({i, j, k});
                    if (found == cells_.end()) continue;
                    looked_ += found->second.size();
                    for (const std::uint32_t atom : found->second)
                        if (glm::distance(glm::dvec3(molecule_.atoms[atom].position), p) <= distance_) return true;
                }
        if (looked_ > 500'000'000 + 20'000 * molecule_.atoms.size())
            throw Error("cannot build symmetry", "", "too many atoms lie at one place");
        return false;
    }

private:
    using Cell = std::tuple<long, long, long>;
    Cell findCell(const glm::dvec3& p) const {
        const auto at = [&](double v) { return static_cast<long>(std::floor(v / edge_)); };
        return {at(p.x), at(p.y), at(p.z)};
    }
    const Molecule& molecule_;
    double distance_, edge_;
    mutable std::size_t looked_ = 0;  ///< atoms, in all calls
    std::map<Cell, std::vector<std::uint32_t>> cells_;
};

}  // namespace

std::optional<std::array<glm::dvec3, 3>> cellEdges(const FileSummary& file) {
    if (file.box) return std::array{glm::dvec3((*file.box)[0]), glm::dvec3((*file.box)[1]), glm::dvec3((*file.box)[2])};
    if (!file.cell) return std::nullopt;
    const std::array<double, 6>& c = *file.cell;
    const auto box = makeBox({c[0], c[1], c[2]}, {c[3], c[4], c[5]});
    if (!box) return std::nullopt;
    return std::array{glm::dvec3((*box)[0]), glm::dvec3((*box)[1]), glm::dvec3((*box)[2])};
}

glm::dvec3 cellCorner(const Molecule& molecule) {
    const auto edges = cellEdges(molecule.file);
    if (!edges || molecule.file.box) return molecule.file.boxOrigin;
    const glm::dmat3 cell((*edges)[0], (*edges)[1], (*edges)[2]);
    return cell * glm::floor(glm::inverse(cell) * findMiddle(molecule));
}

std::vector<glm::dmat4x3> crystalCopies(const Molecule& molecule, const std::array<int, 3>& low,
                                        const std::array<int, 3>& high) {
    const Crystal crystal = makeCrystal(molecule);
    double count = static_cast<double>(crystal.operations.size());
    const bool boxed = molecule.file.box && !molecule.file.cell;
    const auto repeats = [&](std::size_t axis, int cell) {
        return cell == 0 || !boxed || molecule.file.boxRepeats[axis];
    };
    for (std::size_t i = 0; i < 3; ++i) count *= std::max(0.0, static_cast<double>(high[i]) - low[i] + 1);
    if (count > static_cast<double>(kMostSymmetryCopies))
        throw Error("cannot build symmetry", "",
                    "its cells hold more than " + std::to_string(kMostSymmetryCopies) + " copies");
    std::vector<glm::dmat4x3> copies{glm::dmat4x3(1.0)};
    for (const gemmi::Op& operation : crystal.operations)
        for (int i = low[0]; i <= high[0]; ++i)
            for (int j = low[1]; j <= high[1]; ++j)
                for (int k = low[2]; k <= high[2]; ++k) {
                    if (!repeats(0, i) || !repeats(1, j) || !repeats(2, k)) continue;
                    const glm::dmat4x3 motion = makeMotion(crystal, operation, {i, j, k});
                    if (!isIdentity(motion)) copies.push_back(motion);
                }
    return copies;
}

std::optional<glm::dmat4x3> crystalMotion(const Molecule& molecule, std::size_t number,
                                          const std::array<int, 3>& cells) {
    const Crystal crystal = makeCrystal(molecule);
    const std::vector<gemmi::Op> operations = orderedOperations(crystal.group);
    if (number == 0 || number > operations.size()) return std::nullopt;
    return inSpace(crystal, shifted(operations[number - 1], cells));
}

std::vector<glm::dmat4x3> crystalMates(const Molecule& molecule, double distance) {
    const Crystal crystal = makeCrystal(molecule);
    double reach = 0;
    for (const Atom& atom : molecule.atoms)
        reach = std::max(reach, glm::distance(glm::dvec3(atom.position), crystal.middle));
    const AtomGrid atomGrid(molecule, std::clamp(distance, 0.1, 1000.0));
    std::vector<glm::dmat4x3> mates;
    for (const glm::dmat4x3& motion : crystalCopies(molecule, {-3, -3, -3}, {3, 3, 3})) {
        const glm::dvec3 middle = motion * glm::dvec4(crystal.middle, 1.0);
        if (glm::distance(middle, crystal.middle) > 2 * reach + distance) continue;
        const bool near = mates.empty() || std::ranges::any_of(molecule.atoms, [&](const Atom& atom) {
                              return atomGrid.isNear(motion * glm::dvec4(glm::dvec3(atom.position), 1.0));
                          });
        if (near) mates.push_back(motion);
    }
    return mates;
}

}  // namespace nacre
