#include <cmath>

#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxModels = 1'000'000;

MmcifCell either(MmcifCell first, MmcifCell second) { return first.data() ? first : second; }

char firstCharacter(MmcifCell cell) { return cell.empty() || cell.front() == ' ' ? '\0' : cell.front(); }

/// A value may end in its standard uncertainty: "1.234(5)".
MmcifCell withoutUncertainty(MmcifCell cell) {
    return !cell.empty() && cell.back() == ')' ? cell.substr(0, cell.find('(')) : cell;
}

std::int8_t formalCharge(MmcifCell cell) {
    const auto value = parseInteger(cell);
    return value && std::abs(*value) <= 20 ? static_cast<std::int8_t>(*value) : std::int8_t{0};
}

/// For files without type_symbol: "CA" of residue "CA" is calcium, else the first letter tells, or the first two.
std::string_view elementOfName(std::string_view name, std::string_view residue) {
    while (!name.empty() && name.front() >= '0' && name.front() <= '9') name.remove_prefix(1);
    if (name == residue && elementFromSymbol(name) != 0) return name;
    return elementFromSymbol(name.substr(0, 1)) != 0 ? name.substr(0, 1) : name.substr(0, 2);
}

}  // namespace

MmcifAtoms::MmcifAtoms(MoleculeBuilder& builder, const std::vector<std::string>& columns, int wantedModel)
    : builder_(builder), wantedModel_(wantedModel) {
    static const char* const kNames[columnCount] = {"cartn_x",
                                                    "cartn_y",
                                                    "cartn_z",
                                                    "group_pdb",
                                                    "type_symbol",
                                                    "auth_atom_id",
                                                    "label_atom_id",
                                                    "auth_comp_id",
                                                    "label_comp_id",
                                                    "auth_asym_id",
                                                    "label_asym_id",
                                                    "auth_seq_id",
                                                    "label_seq_id",
                                                    "pdbx_pdb_ins_code",
                                                    "label_alt_id",
                                                    "occupancy",
                                                    "b_iso_or_equiv",
                                                    "pdbx_formal_charge",
                                                    "pdbx_pdb_model_num",
                                                    "label_entity_id"};
    for (int which = 0; which < columnCount; ++which) {
        column_[which] = -1;
        for (std::size_t i = columns.size(); i-- > 0;)
            if (columns[i] == kNames[which]) column_[which] = static_cast<int>(i);
    }
    for (int axis = 0; axis < 3; ++axis)
        if (column_[axis] < 0)
            throw Error("cannot read molecule", builder_.name(),
                        std::string("the column _atom_site.Cartn_") + "xyz"[axis] + " is missing");
}

void MmcifAtoms::addRow(const MmcifCell* cells, std::uint64_t line) {
    ++rows_;
    if (modelIndex(cell(cells, model)) != wantedModel_) return;
    Atom atom;
    atom.position = {coordinate(cells, 0, line), coordinate(cells, 1, line), coordinate(cells, 2, line)};
    const MmcifCell name = either(cell(cells, authAtom), cell(cells, labelAtom));
    const MmcifCell residue = either(cell(cells, authComp), cell(cells, labelComp));
    const MmcifCell type = cell(cells, symbol);
    atom.name = Name(name);
    atom.element = builder_.element(type.data() ? type : elementOfName(name, residue), line);
    atom.alternate = firstCharacter(cell(cells, alternate));
    atom.hetero = cell(cells, group) == "HETATM";
    atom.charge = formalCharge(cell(cells, charge));
    atom.occupancy = property(cell(cells, occupancy), 1.0f);
    atom.temperatureFactor = property(cell(cells, temperature), 0.0f);
    const auto number = parseInteger(either(cell(cells, authSeq), cell(cells, labelSeq)));
    const bool fits = number && *number >= INT32_MIN && *number <= INT32_MAX;
    const MmcifCell auth = cell(cells, authAsym), label = cell(cells, labelAsym);
    builder_.addAtom(atom, either(auth, label), fits ? static_cast<std::int32_t>(*number) : 0,
                     firstCharacter(cell(cells, insertion)), residue);
    if (column_[entity] >= 0) {
        Residue& last = builder_.molecule().residues.back();
        if (last.atomCount == 1) last.entity = entityIndex(cell(cells, entity));
    }
    countChains(auth, label);
}

int MmcifAtoms::modelIndex(std::string_view number) {
    if (lastIndex_ > 0 && number == lastModel_) return lastIndex_;
    lastModel_ = std::string(number);
    lastIndex_ = models_.emplace(lastModel_, static_cast<int>(models_.size()) + 1).first->second;
    if (models_.size() > kMaxModels) throw Error("cannot read molecule", builder_.name(), "it has too many models");
    return lastIndex_;
}

float MmcifAtoms::coordinate(const MmcifCell* cells, int axis, std::uint64_t line) const {
    const MmcifCell text = cells[column_[axis]];
    if (const auto value = parseNumber(withoutUncertainty(text)); value && std::abs(*value) <= 1e9)
        return static_cast<float>(*value);
    const std::string why = std::string("Cartn_") + "xyz"[axis] + " of row " + std::to_string(rows_) +
                            " of _atom_site is not a finite number: '" + (text.data() ? printable(text) : "?") + "'";
    throw Error("cannot read molecule", builder_.name(), why,
                line > 0 ? std::optional<std::uint64_t>(line) : std::nullopt);
}

float MmcifAtoms::property(MmcifCell text, float otherwise) {
    if (!text.data()) return otherwise;
    const auto value = parseNumber(withoutUncertainty(text));
    if (value && std::abs(*value) <= 1e9) return static_cast<float>(*value);
    if (badProperties_++ == 0) builder_.warn("occupancy or B factor is not a number: '" + printable(text) + "'");
    return otherwise;
}

void MmcifAtoms::countChains(MmcifCell auth, MmcifCell label) {
    const auto count = [](MmcifCell chain, std::string& last, std::map<std::string, bool, std::less<>>& all) {
        if (!all.empty() && last == chain) return;
        last = std::string(chain);
        all.emplace(last, true);
    };
    if (auth.data()) count(auth, lastAuth_, authChains_);
    if (label.data()) count(label, lastLabel_, labelChains_);
}

std::uint32_t MmcifAtoms::entityIndex(MmcifCell identifier) {
    if (!identifier.data()) return 0;
    if (const auto known = entities_.find(identifier); known != entities_.end()) return known->second;
    std::vector<std::string>& names = builder_.molecule().entities;
    names.emplace_back(identifier);
    return entities_.emplace(identifier, static_cast<std::uint32_t>(names.size())).first->second;
}

void MmcifAtoms::summarise(FileSummary& file) const {
    const auto models = static_cast<std::int64_t>(models_.size());
    if (rows_ > 0 && wantedModel_ > models)
        throw Error("cannot read molecule", builder_.name(),
                    "there is no model " + std::to_string(wantedModel_) + "; the file has " + std::to_string(models));
    file.models = models;
    file.totalAtomsAllModels = rows_;
    if (column_[authAsym] >= 0) file.chainsAuth = static_cast<std::int64_t>(authChains_.size());
    if (column_[labelAsym] >= 0) file.chainsLabel = static_cast<std::int64_t>(labelChains_.size());
}

}  // namespace nacre
