#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/molecule/element.h"
#include "engine/molecule/formats/mmcif_model.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxModels = 100'000;
constexpr std::size_t kLongestCell = 64;

char firstCharacter(std::string_view text) { return text.empty() || text.front() == ' ' ? '\0' : text.front(); }

std::optional<std::int32_t> wholeNumber(const MmcifCell& cell) {
    const auto number = cell.integer();
    if (!number || *number < INT32_MIN || *number > INT32_MAX) return std::nullopt;
    return static_cast<std::int32_t>(*number);
}

std::int8_t formalCharge(const MmcifCell& cell) {
    const auto value = cell.integer();
    return value && std::abs(*value) <= 20 ? static_cast<std::int8_t>(*value) : std::int8_t{0};
}

/// For files without type_symbol: "CA" of residue "CA" is calcium, otherwise the first one or two letters decide.
std::string_view elementOfName(std::string_view name, std::string_view residue) {
    while (!name.empty() && name.front() >= '0' && name.front() <= '9') name.remove_prefix(1);
    if (name == residue && elementFromSymbol(name) != 0) return name;
    return elementFromSymbol(name.substr(0, 1)) != 0 ? name.substr(0, 1) : name.substr(0, 2);
}

}  // namespace

const std::array<const char*, MmcifAtoms::columnCount> MmcifAtoms::kNames = {"cartn_x",
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
                                                                             "label_entity_id",
                                                                             "id",
                                                                             "ihm_model_id",
                                                                             "object_radius",
                                                                             "covariance_matrix[1][1]",
                                                                             "covariance_matrix[2][2]",
                                                                             "covariance_matrix[3][3]"};

bool MmcifAtoms::isKept(std::string_view column) {
    return std::any_of(kNames.begin(), kNames.end(), [&](const char* name) { return column == name; });
}

std::string packedChainName(std::string_view model, std::string_view chain) {
    return std::string(model) + ":" + std::string(chain);
}

MmcifAtoms::MmcifAtoms(std::deque<MoleculeBuilder>& builders, const ReadOptions& options, int lastModel, Models models)
    : builders_(builders),
      wantedFrom_(options.model),
      wantedTo_(std::max(options.model, lastModel)),
      together_(models),
      maxAtoms_(options.maxAtoms) {}

void MmcifAtoms::begin(const std::string& category, std::vector<std::string> columns) {
    // IHM's names of columns that _atom_site also has.
    static constexpr std::pair<std::string_view, const char*> kOfObjects[] = {
        {"mean_cartn_x", "cartn_x"},      {"mean_cartn_y", "cartn_y"},        {"mean_cartn_z", "cartn_z"},
        {"asym_id", "label_asym_id"},     {"seq_id_begin", "label_seq_id"},   {"seq_id", "label_seq_id"},
        {"entity_id", "label_entity_id"}, {"model_id", "pdbx_pdb_model_num"}, {"id", "object_id"}};
    if (category != "atom_site")
        for (std::string& column : columns)
            for (const auto& [theirs, ours] : kOfObjects)
                if (column == theirs) {
                    column = ours;
                    break;
                }
    for (int which = 0; which < columnCount; ++which) {
        column_[which] = -1;
        for (std::size_t i = columns.size(); i-- > 0;)
            if (columns[i] == kNames[static_cast<std::size_t>(which)]) column_[which] = static_cast<int>(i);
    }
    if (column_[model] < 0) column_[model] = column_[ihmModel];
    for (int axis = 0; axis < 3; ++axis)
        if (column_[axis] < 0) cannotRead(name(), "the column _" + category + ".Cartn_" + "xyz"[axis] + " is missing");
}

/// Radius of a sphere, or of the sphere with a Gaussian's variance; 0 for an atom.
float MmcifAtoms::readRadius(const MmcifCell* cells) const {
    constexpr double kLargest = 1e6;  // Å
    double radius = cell(cells, sphereRadius).number().value_or(0);
    if (column_[varianceX] >= 0) {
        double variance = 0;
        for (const Column axis : {varianceX, varianceY, varianceZ}) variance += cell(cells, axis).number().value_or(0);
        radius = std::sqrt(std::max(variance, 0.0) * 5 / 3);  // variance of a ball along each axis: r² / 5
    }
    return radius > 0 && radius <= kLargest ? static_cast<float>(radius) : 0.0f;
}

void MmcifAtoms::addRow(const MmcifCell* cells, std::uint64_t line) {
    ++rows_;
    refuseLongCells(cells, line);
    const std::string_view modelNumber = text(cells, model);
    const int index = together_ == Models::packed ? 1 : modelIndex(modelNumber);
    if (index < wantedFrom_ || index > wantedTo_) return;
    if (atoms_++ == maxAtoms_)
        throw tooManyAtoms(name() + (wantedFrom_ < wantedTo_ ? ", several models" : ""), maxAtoms_);
    MoleculeBuilder& builder = findBuilder(index);
    Atom atom;
    for (int axis = 0; axis < 3; ++axis) {
        const auto value = coordinate(cells, axis, line, builder);
        if (!value) return;
        atom.position[axis] = *value;
    }
    const std::string_view name = text(cells, authAtom, labelAtom), residue = text(cells, authComp, labelComp);
    const std::string_view type = text(cells, symbol);
    atom.name = Name(name);
    atom.radius = readRadius(cells);
    const bool stated = !cell(cells, symbol).missing() || atom.radius > 0;
    if (atom.radius > 0) {
        atom.name = Name("BEAD");
        builder.state("radii");
    } else {
        atom.element = builder.element(stated ? type : elementOfName(name, residue), line);
    }
    if (!stated) builder.guess("elements", "from atom names");
    atom.alternate = firstCharacter(text(cells, alternate));
    atom.hetero = text(cells, group) == "HETATM";
    atom.charge = formalCharge(cell(cells, charge));
    if (atom.charge == 0 && !cell(cells, charge).missing() && cell(cells, charge).number() != 0.0)
        builder.leaveOut("formal charges", "not usable, read as 0", line);
    atom.occupancy = property(cell(cells, occupancy), 1.0f, builder, line);
    atom.temperatureFactor = property(cell(cells, temperature), 0.0f, builder, line);
    const auto number = wholeNumber(cell(cells, cell(cells, authSeq).missing() ? labelSeq : authSeq));
    const std::string_view chain = text(cells, authAsym, labelAsym), part = text(cells, labelAsym, authAsym);
    if (together_ == Models::packed)
        builder.addAtom(atom, packedChainName(modelNumber, chain), number.value_or(0),
                        firstCharacter(text(cells, insertion)), residue, packedChainName(modelNumber, part));
    else
        builder.addAtom(atom, chain, number.value_or(0), firstCharacter(text(cells, insertion)), residue, part);
    Residue& last = builder.molecule().residues.back();
    if (last.atomCount == 1) beginResidue(cells, modelNumber, last);
    noteSerial(cell(cells, serial), builder.molecule());
    countChains(cells);
}

/// In a packed scene, each model is an entity.
void MmcifAtoms::beginResidue(const MmcifCell* cells, std::string_view modelNumber, Residue& residue) {
    const MmcifCell& stated = cell(cells, entity);
    if (together_ == Models::packed)
        residue.entity = entityIndex(modelNumber);
    else if (!stated.missing())
        residue.entity = entityIndex(stated.text(buffers_[entity]));
    if (column_[labelSeq] >= 0) residue.labelNumber = wholeNumber(cell(cells, labelSeq)).value_or(kNoLabelNumber);
}

/// Most files number their atoms 1, 2, 3, ...: then no serials are kept.
void MmcifAtoms::noteSerial(const MmcifCell& given, Molecule& molecule) {
    const std::size_t count = molecule.atoms.size();
    const auto number = given.integer();
    const bool fits = number && *number >= INT32_MIN && *number <= INT32_MAX;
    const auto value = static_cast<std::int32_t>(fits ? *number : static_cast<std::int64_t>(count));
    if (molecule.serials.empty()) {
        if (value == static_cast<std::int32_t>(count)) return;
        for (std::size_t i = 1; i < count; ++i) molecule.serials.push_back(static_cast<std::int32_t>(i));
    }
    molecule.serials.push_back(value);
}

/// A BinaryCIF file stores a text once, however long, and a million rows may refer to it.
void MmcifAtoms::refuseLongCells(const MmcifCell* cells, std::uint64_t line) const {
    for (const int place : column_)
        if (place >= 0 && cells[place].textSize() > kLongestCell)
            cannotRead(name(),
                       "a value in row " + std::to_string(rows_) + " of _atom_site is longer than " +
                           std::to_string(kLongestCell) + " bytes",
                       line);
}

MoleculeBuilder& MmcifAtoms::findBuilder(int index) {
    const auto place = static_cast<std::size_t>(index - wantedFrom_);
    while (builders_.size() <= place) builders_.emplace_back(name(), maxAtoms_);
    return builders_[place];
}

int MmcifAtoms::modelIndex(std::string_view number) {
    if (lastIndex_ > 0 && number == lastModel_) return lastIndex_;
    lastModel_ = std::string(number);
    lastIndex_ = models_.emplace(lastModel_, static_cast<int>(models_.size()) + 1).first->second;
    if (models_.size() > kMaxModels) cannotRead(name(), "it has more than " + std::to_string(kMaxModels) + " models");
    return lastIndex_;
}

std::optional<float> MmcifAtoms::coordinate(const MmcifCell* cells, int axis, std::uint64_t line,
                                            MoleculeBuilder& builder) const {
    const MmcifCell& given = cells[column_[axis]];
    if (const auto value = given.number(); value && std::abs(*value) <= kFarthestCoordinate)
        return static_cast<float>(*value);
    std::array<char, 32> buffer{};
    const std::string why = std::string("Cartn_") + "xyz"[axis] + " of row " + std::to_string(rows_) +
                            " of _atom_site is not a finite number within 1e9: '" +
                            (given.missing() ? "?" : printable(given.text(buffer))) + "'";
    builder.leaveOutAtom(why, line);
    return std::nullopt;
}

float MmcifAtoms::property(const MmcifCell& given, float otherwise, MoleculeBuilder& builder, std::uint64_t line) {
    if (given.missing()) return otherwise;
    const auto value = given.number();
    if (value && std::abs(*value) <= 1e9) return static_cast<float>(*value);
    builder.leaveOut("numbers", "occupancies or B factors that are not numbers", line);
    return otherwise;
}

void MmcifAtoms::countChains(const MmcifCell* cells) {
    const auto count = [](std::string_view chain, std::string& last, std::map<std::string, bool, std::less<>>& all) {
        if (!all.empty() && last == chain) return;
        last = std::string(chain);
        all.emplace(last, true);
    };
    // A chain whose name is '.' has no name, but counts.
    if (column_[authAsym] >= 0) count(text(cells, authAsym, labelAsym), lastAuth_, authChains_);
    if (column_[labelAsym] >= 0) count(text(cells, labelAsym), lastLabel_, labelChains_);
}

std::uint32_t MmcifAtoms::entityIndex(std::string_view identifier) {
    if (const auto known = entities_.find(identifier); known != entities_.end()) return known->second;
    entityNames_.emplace_back(identifier);
    return entities_.emplace(identifier, static_cast<std::uint32_t>(entityNames_.size())).first->second;
}

void MmcifAtoms::summarise(FileSummary& file) const {
    const auto models = together_ == Models::packed ? 1 : static_cast<std::int64_t>(models_.size());
    if (rows_ > 0) requireModel(name(), wantedFrom_, models);
    file.models = models;
    file.totalAtomsAllModels = rows_;
    if (column_[authAsym] >= 0) file.chainsAuth = static_cast<std::int64_t>(authChains_.size());
    if (column_[labelAsym] >= 0) file.chainsLabel = static_cast<std::int64_t>(labelChains_.size());
}

}  // namespace nacre
