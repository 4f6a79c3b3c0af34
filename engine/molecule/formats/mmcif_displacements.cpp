#include <algorithm>
#include <cmath>

#include "engine/molecule/displacement.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {
namespace {

constexpr std::array<std::string_view, 7> kOfU = {"id",      "u[1][1]", "u[2][2]", "u[3][3]",
                                                  "u[1][2]", "u[1][3]", "u[2][3]"};
constexpr std::array<std::string_view, 7> kOfB = {"id",      "b[1][1]", "b[2][2]", "b[3][3]",
                                                  "b[1][2]", "b[1][3]", "b[2][3]"};

/// A column's name in _atom_site_anisotrop; in _atom_site it has "aniso_" in front.
std::string_view ownName(MmcifDisplacements::Table table, std::string_view column) {
    constexpr std::string_view kPrefix = "aniso_";
    if (table == MmcifDisplacements::Table::own || column == "id") return column;
    return startsWith(column, kPrefix) ? column.substr(kPrefix.size()) : std::string_view();
}

}  // namespace

bool MmcifDisplacements::isKept(Table table, std::string_view column) {
    const auto is = [name = ownName(table, column)](std::string_view other) { return name == other; };
    return std::any_of(kOfU.begin(), kOfU.end(), is) || std::any_of(kOfB.begin(), kOfB.end(), is);
}

void MmcifDisplacements::begin(Table table, const std::vector<std::string>& columns) {
    table_ = table;
    const auto find = [&](const std::array<std::string_view, 7>& names, std::array<int, 7>& places) {
        places.fill(-1);
        for (std::size_t column = 0; column < columns.size(); ++column)
            for (std::size_t i = 0; i < names.size(); ++i)
                if (places[i] < 0 && ownName(table, columns[column]) == names[i]) places[i] = static_cast<int>(column);
    };
    find(kOfU, ofU_);
    find(kOfB, ofB_);
}

/// wwPDB's files state U in the Cartesian axes of the positions, like ANISOU.
void MmcifDisplacements::addRow(const MmcifCell* cells) {
    const auto isStated = [&](int place) { return place >= 0 && !cells[place].missing(); };
    if (table_ == Table::ofAtoms && std::none_of(ofU_.begin() + 1, ofU_.end(), isStated) &&
        std::none_of(ofB_.begin() + 1, ofB_.end(), isStated))
        return;
    const auto read = [&](const std::array<int, 7>& places, double unit) -> std::optional<Displacement> {
        std::array<float, 6> u{};
        for (std::size_t i = 0; i < u.size(); ++i) {
            const auto value = places[i + 1] < 0 ? std::nullopt : cells[places[i + 1]].number();
            if (!value || !(std::abs(*value * unit) <= kLargestDisplacement)) return std::nullopt;
            u[i] = static_cast<float>(*value * unit);
        }
        return Displacement{u[0], u[1], u[2], u[3], u[4], u[5]};
    };
    const std::int64_t id = ofU_[0] < 0 ? -1 : cells[ofU_[0]].integer().value_or(-1);
    auto u = read(ofU_, 1);
    if (!u) u = read(ofB_, 1 / kEightPiSquared);
    if (id < 0 || !u)
        ++unusable_;
    else
        rows_.emplace_back(id, *u);
}

void MmcifDisplacements::apply(MoleculeBuilder& builder) const {
    Molecule& molecule = builder.molecule();
    if (unusable_ > 0)
        addNote(molecule.notes, ReadAction::leftOut, "anisotropic displacements", "no atom, or not six usable numbers",
                unusable_);
    if (rows_.empty()) return;
    std::vector<std::int64_t> ids(molecule.serials.begin(), molecule.serials.end());
    for (std::size_t i = ids.size(); i < molecule.atoms.size(); ++i) ids.push_back(static_cast<std::int64_t>(i + 1));
    const IdIndex index(ids);
    for (const auto& [id, u] : rows_) {
        std::uint32_t atom = 0;
        if (index.find(id, atom) != IdIndex::Found::one) continue;  // belongs to another model
        molecule.displacements.resize(molecule.atoms.size());
        molecule.displacements[atom] = u;
    }
}

}  // namespace nacre
