#pragma once
// What mmCIF and mmJSON have in common: categories of rows go in, a Molecule comes out. Knows no syntax and keeps
// only what it needs, so that a million atoms take no more memory than the molecule. Must also compile as C++17.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_builder.h"
#include "engine/molecule/read.h"

namespace nacre {

/// One value; data() is null where the file says '?' or '.' unquoted.
using MmcifCell = std::string_view;

/// A small category, kept whole.
class MmcifTable {
public:
    std::vector<std::string> columns;  ///< lower case, without the category
    std::vector<std::optional<std::string>> cells;

    std::size_t rows() const { return columns.empty() ? 0 : cells.size() / columns.size(); }
    /// The value of the first of these columns that has one.
    std::optional<std::string_view> get(std::size_t row, std::initializer_list<const char*> names) const;
};

/// Rows of _atom_site.
class MmcifAtoms {
public:
    /// @throws Error naming the coordinate column that is missing
    MmcifAtoms(MoleculeBuilder& builder, const std::vector<std::string>& columns, int model);
    /// @param line 0 if unknown
    void addRow(const MmcifCell* cells, std::uint64_t line);
    /// @throws Error if the model that was asked for is not there
    void summarise(FileSummary& file) const;

private:
    int modelIndex(std::string_view number);
    float coordinate(const MmcifCell* cells, int axis, std::uint64_t line) const;
    float property(MmcifCell cell, float otherwise);
    void countChains(MmcifCell auth, MmcifCell label);
    std::uint32_t entityIndex(MmcifCell identifier);

    enum Column {
        x,
        y,
        z,
        group,
        symbol,
        authAtom,
        labelAtom,
        authComp,
        labelComp,
        authAsym,
        labelAsym,
        authSeq,
        labelSeq,
        insertion,
        alternate,
        occupancy,
        temperature,
        charge,
        model,
        entity,
        columnCount
    };
    int column_[columnCount];
    MmcifCell cell(const MmcifCell* cells, Column which) const {
        return column_[which] < 0 ? MmcifCell() : cells[column_[which]];
    }

    MoleculeBuilder& builder_;
    int wantedModel_;
    std::map<std::string, int, std::less<>> models_;  ///< pdbx_PDB_model_num -> 1-based position
    std::string lastModel_;
    int lastIndex_ = 0;
    std::int64_t rows_ = 0;
    std::int64_t badProperties_ = 0;
    std::map<std::string, bool, std::less<>> authChains_, labelChains_;
    std::string lastAuth_, lastLabel_;
    std::map<std::string, std::uint32_t, std::less<>> entities_;  ///< label_entity_id -> 1-based position
};

class MmcifModel {
public:
    MmcifModel(const std::string& name, const ReadOptions& options) : builder_(name), options_(options) {}

    /// A data block begins. The first block with atoms is the one that is read.
    void beginBlock();
    /// Rows of a category follow. False if they are of no use and need not be given.
    /// @param category lower case, without '_' and '.'; columns likewise
    bool beginCategory(const std::string& category, const std::vector<std::string>& columns, std::uint64_t line);
    void addRow(const std::vector<MmcifCell>& cells, std::uint64_t line);

    /// @param format "mmcif" or "mmjson"
    /// @throws Error if there are no atoms
    Molecule finish(const std::string& format);

private:
    MoleculeBuilder builder_;
    ReadOptions options_;
    std::unique_ptr<MmcifAtoms> atoms_;
    std::map<std::string, MmcifTable> tables_;  ///< the small categories that are kept
    MmcifTable* table_ = nullptr;               ///< the one that rows go to; null: the atoms
    std::size_t cells_ = 0;
    bool done_ = false;
    bool fractional_ = false;
};

/// Bonds of _struct_conn between atoms that are there: covalent ones and disulphides, not metal coordination or
/// hydrogen bonds, and none to symmetry mates.
void addStructConnBonds(MoleculeBuilder& builder, const MmcifTable& connections);

/// Helices of _struct_conf and strands of _struct_sheet_range.
void addSecondaryStructure(MoleculeBuilder& builder, const MmcifTable& conformations, const MmcifTable& strands);

/// The molecule of a chemical component file: ideal coordinates if complete, else the model's.
void addComponent(MoleculeBuilder& builder, const MmcifTable& atoms, const MmcifTable& bonds);

}  // namespace nacre
