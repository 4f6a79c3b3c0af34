// Small-molecule CIF, as the Cambridge and the Crystallography Open Database have it (dictionary cif_core).
#include <algorithm>
#include <cmath>
#include <gemmi/symmetry.hpp>
#include <gemmi/unitcell.hpp>

#include "engine/molecule/assemblies.h"
#include "engine/molecule/element.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

/// A number without its standard uncertainty; empty if missing.
std::optional<double> number(const MmcifTable& table, std::size_t row, std::initializer_list<const char*> columns) {
    const auto text = table.get(row, columns);
    return text ? MmcifCell(*text).number() : std::nullopt;
}

gemmi::UnitCell readCell(const std::string& name, const MmcifTable& table) {
    static constexpr const char* kColumns[6] = {"length_a",    "length_b",   "length_c",
                                                "angle_alpha", "angle_beta", "angle_gamma"};
    std::array<double, 6> value{};
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto given = table.rows() > 0 ? number(table, 0, {kColumns[i]}) : std::nullopt;
        const double high = i < 3 ? 1e6 : 180;
        if (!given || !(*given > 0 && *given < high))
            cannotRead(name, std::string("_cell_") + kColumns[i] +
                                 " is missing or impossible, without which fractional coordinates mean nothing");
        value[i] = *given;
    }
    gemmi::UnitCell cell;
    cell.set(value[0], value[1], value[2], value[3], value[4], value[5]);
    if (!(cell.volume > 1e-6 && std::isfinite(cell.volume))) cannotRead(name, "the unit cell has no volume");
    return cell;
}

/// "C27" is carbon, "Cu1" and "CL2" are copper and chlorine; the symbol precedes the label's digits.
std::string_view elementOfLabel(std::string_view label) {
    std::size_t letters = 0;
    while (letters < label.size() && std::isalpha(static_cast<unsigned char>(label[letters]))) ++letters;
    for (std::size_t length = std::min<std::size_t>(letters, 2); length > 0; --length)
        if (elementFromSymbol(label.substr(0, length)) != 0) return label.substr(0, length);
    return label;
}

/// Disorder groups 1, 2, ... become alternate locations A, B, ...; -1 marks disorder about a special position.
char alternateOf(const MmcifTable& atoms, std::size_t row) {
    const auto group = number(atoms, row, {"disorder_group"});
    if (!group || *group == 0 || !(std::abs(*group) <= 26)) return '\0';
    return static_cast<char>('A' + static_cast<int>(std::abs(*group)) - 1);
}

Atom readAtom(MoleculeBuilder& builder, const MmcifTable& atoms, std::size_t row) {
    Atom atom;
    const auto label = atoms.get(row, {"label"}).value_or("");
    const auto type = atoms.get(row, {"type_symbol"});
    atom.name = Name(label);
    atom.element = builder.element(type ? *type : elementOfLabel(label), 0);
    atom.alternate = alternateOf(atoms, row);
    atom.hetero = true;
    const auto inRange = [](std::optional<double> value) { return value && std::abs(*value) <= 1e9; };
    if (const auto share = number(atoms, row, {"occupancy"}); inRange(share))
        atom.occupancy = static_cast<float>(*share);
    constexpr double kEightPiSquared = 78.95683520871486;
    if (const auto b = number(atoms, row, {"b_iso_or_equiv"}); inRange(b))
        atom.temperatureFactor = static_cast<float>(*b);
    else if (const auto u = number(atoms, row, {"u_iso_or_equiv"}); inRange(u))
        atom.temperatureFactor = static_cast<float>(*u * kEightPiSquared);
    return atom;
}

/// Fractional coordinates; empty if one of them is '?' or '.', as of hydrogens that were not located.
std::optional<gemmi::Fractional> readPosition(const std::string& name, const MmcifTable& atoms, std::size_t row) {
    static constexpr const char* kColumns[3] = {"fract_x", "fract_y", "fract_z"};
    std::array<double, 3> value{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto text = atoms.get(row, {kColumns[axis]});
        if (!text) return std::nullopt;
        const auto given = MmcifCell(*text).number();
        if (!given || !(std::abs(*given) <= 1e6))
            cannotRead(name, std::string(kColumns[axis]) + " of row " + std::to_string(row + 1) +
                                 " of _atom_site is not a finite number: '" + printable(*text) + "'");
        value[axis] = *given;
    }
    return gemmi::Fractional(value[0], value[1], value[2]);
}

/// A symmetry operation as a transform of Å, shifted by whole cells so that the copy's centre lies in the cell at 0.
TransformRows transformOf(const gemmi::Op& operation, const gemmi::UnitCell& cell, const gemmi::Fractional& centre) {
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

Assembly unitCell(const MoleculeBuilder& builder, const MmcifTable& symmetry, const gemmi::UnitCell& cell,
                  const gemmi::Fractional& centre) {
    AssemblyLimits limits(builder.maxAtoms());
    std::vector<glm::mat4x3> transforms;
    for (std::size_t row = 0; row < symmetry.rows(); ++row) {
        const auto text = symmetry.get(row, {"pos_as_xyz", "operation_xyz"});
        if (!text) throw AssemblyFault("a symmetry operation is missing");
        limits.spend(1, 1);
        try {
            transforms.push_back(toMatrix(transformOf(gemmi::parse_triplet(std::string(*text)), cell, centre)));
        } catch (const AssemblyFault&) {
            throw;
        } catch (const std::exception&) {  // thrown by gemmi's parser
            throw AssemblyFault("'" + printable(*text) + "' is not a symmetry operation");
        }
    }
    Assembly assembly{"unit-cell", "content of the unit cell", {}};
    addPart(assembly, transforms, {*builder.subchain("")});
    return assembly;
}

}  // namespace

void addSmallMolecule(MoleculeBuilder& builder, const SmallMoleculeTables& tables) {
    const gemmi::UnitCell cell = readCell(builder.name(), tables.cell);
    gemmi::Vec3 sum(0, 0, 0);
    std::size_t unplaced = 0, placed = 0;
    for (std::size_t row = 0; row < tables.atoms.rows(); ++row) {
        const auto fractional = readPosition(builder.name(), tables.atoms, row);
        if (!fractional) {
            ++unplaced;
            continue;
        }
        Atom atom = readAtom(builder, tables.atoms, row);
        const gemmi::Position position = cell.orthogonalize(*fractional);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(position.at(axis)) <= kFarthestCoordinate))
                cannotRead(builder.name(),
                           "the position in row " + std::to_string(row + 1) + " of _atom_site is too far away");
            atom.position[axis] = static_cast<float>(position.at(axis));
        }
        builder.addAtom(atom, "", 1, '\0', "");
        sum += *fractional;
        ++placed;
    }
    if (unplaced > 0) builder.warn("atoms without coordinates, left out: " + std::to_string(unplaced));
    builder.molecule().file.models = 1;
    builder.molecule().file.totalAtomsAllModels = static_cast<std::int64_t>(placed);
    if (placed == 0 || tables.symmetry.rows() == 0) return;
    try {
        const gemmi::Fractional centre(sum / static_cast<double>(placed));
        builder.molecule().assemblies.push_back(unitCell(builder, tables.symmetry, cell, centre));
    } catch (const AssemblyFault& fault) {
        builder.warn(std::string("the unit cell is left out: ") + fault.what());
    }
}

}  // namespace nacre
