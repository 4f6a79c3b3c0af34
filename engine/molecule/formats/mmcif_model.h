#pragma once
// Shared by mmCIF, mmJSON and BinaryCIF: turns rows of categories into a Molecule. Independent of syntax. Keeps only
// needed data, so that a million atoms take no more memory than the molecule. Must also compile as C++17.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/read.h"

namespace nacre {

/// One value: text, or a number where the format has numbers (BinaryCIF), or missing ('?' and '.' in text).
class MmcifCell {
public:
    MmcifCell() = default;
    MmcifCell(std::string_view text) : text_(text), kind_(Kind::text) {}
    explicit MmcifCell(double number) : number_(number), kind_(Kind::number) {}

    bool missing() const { return kind_ == Kind::missing; }
    std::size_t textSize() const { return text_.size(); }  ///< 0 for numbers
    std::optional<double> number() const;  ///< without the standard uncertainty at the end of a text: "1.234(5)"
    std::optional<std::int64_t> integer() const;
    /// The value as text, "" if missing. @param buffer for numbers; the result may point into it
    std::string_view text(std::array<char, 32>& buffer) const;

private:
    enum class Kind : std::uint8_t { missing, text, number };
    std::string_view text_;
    double number_ = 0;
    Kind kind_ = Kind::missing;
};

/// A small category, kept whole.
class MmcifTable {
public:
    std::vector<std::string> columns;     ///< lower case, without the category
    std::vector<std::string_view> cells;  ///< data() is null where a value is missing
    std::vector<std::uint64_t> lines;     ///< of the rows

    /// 0 if not known.
    std::uint64_t lineNumber(std::size_t row) const { return row < lines.size() ? lines[row] : 0; }
    std::size_t rows() const { return columns.empty() ? 0 : cells.size() / columns.size(); }
    /// The first of these columns that has a value.
    std::optional<std::string_view> get(std::size_t row, std::initializer_list<const char*> names) const;
};

/// Collects rows of _atom_site into the wanted models.
class MmcifAtoms {
public:
    enum class Models : std::uint8_t { apart, packed };  ///< packed: all are one scene, with copies of their own

    /// @param builders  one; more are added as models begin, if several are wanted
    MmcifAtoms(std::deque<MoleculeBuilder>& builders, const ReadOptions& options, int lastModel, Models models);
    /// Begins rows with such columns: of _atom_site, or of IHM's spheres and Gaussian objects, which become grains.
    /// @throws Error naming the missing coordinate column
    void begin(const std::string& category, std::vector<std::string> columns);
    /// Whether a column (lower case) is needed.
    static bool isKept(std::string_view column);
    /// @param line 0 if unknown
    void addRow(const MmcifCell* cells, std::uint64_t line);
    /// @throws Error if the wanted model does not exist
    void summarise(FileSummary& file) const;
    const std::vector<std::string>& entities() const { return entityNames_; }

private:
    void beginResidue(const MmcifCell* cells, std::string_view modelNumber, Residue& residue);
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
        serial,
        ihmModel,
        sphereRadius,
        varianceX,
        varianceY,
        varianceZ,
        columnCount
    };
    static const std::array<const char*, columnCount> kNames;

    const MmcifCell& cell(const MmcifCell* cells, Column which) const {
        static const MmcifCell kMissing;
        return column_[which] < 0 ? kMissing : cells[column_[which]];
    }
    std::string_view text(const MmcifCell* cells, Column which) { return cell(cells, which).text(buffers_[which]); }
    std::string_view text(const MmcifCell* cells, Column first, Column second) {
        return text(cells, cell(cells, first).missing() ? second : first);
    }

    const std::string& name() const { return builders_.front().name(); }
    MoleculeBuilder& findBuilder(int index);
    int modelIndex(std::string_view number);
    std::optional<float> coordinate(const MmcifCell* cells, int axis, std::uint64_t line,
                                    MoleculeBuilder& builder) const;
    static float property(const MmcifCell& cell, float otherwise, MoleculeBuilder& builder, std::uint64_t line);
    float readRadius(const MmcifCell* cells) const;
    static void noteSerial(const MmcifCell& given, Molecule& molecule);
    void countChains(const MmcifCell* cells);
    std::uint32_t entityIndex(std::string_view identifier);
    void refuseLongCells(const MmcifCell* cells, std::uint64_t line) const;

    int column_[columnCount];
    std::array<char, 32> buffers_[columnCount]{};
    std::deque<MoleculeBuilder>& builders_;
    int wantedFrom_, wantedTo_;  ///< models
    Models together_;
    std::size_t maxAtoms_;  ///< of all models kept
    std::size_t atoms_ = 0;
    std::map<std::string, int, std::less<>> models_;  ///< pdbx_PDB_model_num -> 1-based position
    std::string lastModel_;
    int lastIndex_ = 0;
    std::int64_t rows_ = 0;
    std::map<std::string, bool, std::less<>> authChains_, labelChains_;
    std::string lastAuth_, lastLabel_;
    std::map<std::string, std::uint32_t, std::less<>> entities_;  ///< label_entity_id -> 1-based position
    std::vector<std::string> entityNames_;
};

/// Collects rows of _atom_site_anisotrop, which may come before those of the atoms, and tensors of _atom_site.
class MmcifDisplacements {
public:
    enum class Table : std::uint8_t { own, ofAtoms };
    static bool isKept(Table table, std::string_view column);
    void begin(Table table, const std::vector<std::string>& columns);
    /// @param cells  as in columns; of atoms, may be without a tensor
    void addRow(const MmcifCell* cells);
    /// Stores them in the atoms with their numbers.
    void apply(MoleculeBuilder& builder) const;

private:
    Table table_ = Table::own;
    std::array<int, 7> ofU_{}, ofB_{};  ///< columns: the atom's number, then the tensor; -1: missing
    std::vector<std::pair<std::int64_t, Displacement>> rows_;
    std::int64_t unusable_ = 0;
};

class MmcifModel {
public:
    /// @param document  the file's content, which outlives this; cells inside it are not copied
    /// @param lastModel  last model to read; options name the first
    MmcifModel(const std::string& name, std::string_view document, const ReadOptions& options, int lastModel);

    /// Whether a category or column is needed; names as below. Readers may skip the others.
    static bool isKept(std::string_view category);
    static bool isKept(std::string_view category, std::string_view column);

    /// Begins a data block. Only the first block with atoms is read; a note counts later ones.
    void beginBlock();
    /// Begins the rows of a category. False if it is not needed: skip its rows.
    /// @param category lower case, without '_' and '.'; columns likewise
    bool beginCategory(const std::string& category, const std::vector<std::string>& columns, std::uint64_t line);
    void addRow(const std::vector<MmcifCell>& cells, std::uint64_t line);
    /// Refuses sizes that addRow() would refuse, before a reader unpacks them. @throws Error
    void expectRows(std::size_t rows, std::size_t columns) const;

    /// The wanted models. @param format "mmcif", "mmjson" or "bcif"
    /// @throws Error if there are no atoms
    std::vector<Molecule> finish(const std::string& format);

private:
    std::string_view kept(const MmcifCell& cell);
    std::vector<EntityKind> entityKinds();
    void finishModels(FileSummary& file);
    void summarise(FileSummary& file, const char* titleCategory);
    void summariseCrystal(FileSummary& file);
    std::string spaceGroupName();
    void nameParts(Molecule& molecule);
    void namePackedScene(Molecule& molecule);

    std::deque<MoleculeBuilder> builders_;  ///< of the wanted models
    std::string_view document_;
    ReadOptions options_;
    int lastModel_;
    std::size_t mostCells_;  ///< of all tables
    std::deque<std::string> copies_;
    MmcifAtoms::Models together_ = MmcifAtoms::Models::apart;
    std::unique_ptr<MmcifAtoms> atoms_;
    MmcifDisplacements displacements_;
    std::map<std::string, MmcifTable> tables_;  ///< the small categories kept
    enum class Rows : std::uint8_t { atoms, displacements, table };
    Rows rows_ = Rows::atoms;      ///< kind of rows being read
    MmcifTable* table_ = nullptr;  ///< receives the rows of a table
    std::size_t cells_ = 0, cellBytes_ = 0;
    bool done_ = false, sawAtomSite_ = false;
};

/// Bonds of _struct_conn between atoms that exist: covalent bonds and disulphides; no metal coordination, hydrogen
/// bonds or symmetry mates.
void addStructConnBonds(MoleculeBuilder& builder, const MmcifTable& connections);

/// Bond order of the dictionary's words ("SING", "doub", "arom", "delo"); 1 for any other.
int mmcifBondOrder(std::optional<std::string_view> text);

/// Bonds of _chem_comp_bond inside residues, except those with our templates.
void addComponentBonds(MoleculeBuilder& builder, const MmcifTable& bonds);

/// Helices of _struct_conf and strands of _struct_sheet_range.
void addSecondaryStructure(MoleculeBuilder& builder, const MmcifTable& conformations, const MmcifTable& strands);
/// The column that names the model of each copy in a packed scene, such as PetWorld's: all its models form one scene.
constexpr std::string_view kModelOfCopies = "_pdbx_struct_assembly_gen.PDB_model_num";
/// Name of a model's chain in a packed scene: "7:A".
std::string packedChainName(std::string_view model, std::string_view chain);

/// Assemblies of _pdbx_struct_assembly, _pdbx_struct_assembly_gen and _pdbx_struct_oper_list. Unreadable ones are
/// skipped with a warning.
void addMmcifAssemblies(MoleculeBuilder& builder, const MmcifTable& assemblies, const MmcifTable& generators,
                        const MmcifTable& operators, MmcifAtoms::Models models);

/// The tables of a small-molecule CIF, whose coordinates are fractional.
struct SmallMoleculeTables {
    const MmcifTable &atoms, &cell, &symmetry, &chemical, &displacements;
    std::string spaceGroup = {};  ///< Hermann-Mauguin, for files that list no operations; empty: not stated
};
/// Adds the file's atoms, the asymmetric unit. The content of the unit cell becomes the assembly "unit-cell", in which
/// an atom on a special position occurs once per site. Elements that share a site become alternate locations.
/// @throws Error if the cell is missing or impossible, or a coordinate is not a number
void addSmallMolecule(MoleculeBuilder& builder, const SmallMoleculeTables& tables);

/// The molecule of a chemical component file: ideal coordinates if complete, else the model's.
void addComponent(MoleculeBuilder& builder, const MmcifTable& atoms, const MmcifTable& bonds);

}  // namespace nacre
