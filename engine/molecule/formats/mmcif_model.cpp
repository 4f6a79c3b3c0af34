#include "engine/molecule/formats/mmcif_model.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "engine/molecule/floating_point.h"
#include "engine/molecule/formats/plain_names.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

// Limit for cells of the small categories: a constant, plus a share of the atoms (connections, helices).
constexpr std::size_t kFewCells = 100'000, kCellsPerAtom = 4, kMostCells = std::size_t{1} << 24;
constexpr std::size_t kMostCellsOfModels = std::size_t{1} << 28;  // read for all models together
// Limit for text that a file repeats by reference: it costs work.
constexpr std::size_t kMostRepeatedBytes = std::size_t{64} << 20;

/// A value may end in its standard uncertainty: "1.234(5)".
std::string_view withoutUncertainty(std::string_view text) {
    return !text.empty() && text.back() == ')' ? text.substr(0, text.find('(')) : text;
}

bool hasColumn(const std::vector<std::string>& columns, std::string_view start) {
    return std::any_of(columns.begin(), columns.end(), [&](const std::string& c) { return startsWith(c, start); });
}

void setTitle(FileSummary& file, const MmcifTable& table) {
    if (table.rows() == 0) return;
    // A long title may be a text of several lines; small-molecule files even put '?' into one.
    std::string title(table.get(0, {"title", "name", "name_common", "name_systematic"}).value_or(""));
    std::replace(title.begin(), title.end(), '\n', ' ');
    if (trim(title) != "?") file.title = trim(title);
}

/// Where the next category begins in BinaryCIF (MessagePack): its name begins with '_', those of columns do not.
std::size_t nextCategory(std::string_view document) {
    constexpr std::string_view kName = "\xA4name";
    constexpr char kLongText = '\xD9';  // followed by its length
    for (std::size_t at = document.find(kName); at != std::string_view::npos; at = document.find(kName, at + 1)) {
        const std::string_view value = document.substr(at + kName.size());
        const std::size_t text = !value.empty() && value[0] == kLongText ? 2 : 1;
        if (value.substr(std::min(text, value.size()), 1) == "_") return at;
    }
    return document.size();
}

/// Whether the table of copies names a model in each row, as in PetWorld's files: then all models form one scene. Other
/// tables also have a column of this name, and do not count.
bool modelsStandTogether(std::string_view document) {
    constexpr std::string_view kPacked = "\xB9_pdbx_struct_assembly_gen", kPackedColumn = "\xADPDB_model_num";
    constexpr std::string_view kJson = "\"pdbx_struct_assembly_gen\"", kJsonColumn = "\"PDB_model_num\"";
    const auto has = [](std::string_view part, std::string_view column) {
        return part.find(column) != std::string_view::npos;
    };
    if (has(document, kModelOfCopies)) return true;
    if (const std::size_t at = document.find(kPacked); at != std::string_view::npos) {
        const std::string_view own = document.substr(at);
        return has(own.substr(0, nextCategory(own)), kPackedColumn);
    }
    const std::size_t at = document.find(kJson);
    if (at == std::string_view::npos) return false;
    const std::string_view own = document.substr(at);
    return has(own.substr(0, own.find('}')), kJsonColumn);
}

}  // namespace

std::optional<double> MmcifCell::number() const {
    if (kind_ == Kind::number) return number_;
    return kind_ == Kind::text ? parseNumber(withoutUncertainty(text_)) : std::nullopt;
}

std::optional<std::int64_t> MmcifCell::integer() const {
    if (kind_ == Kind::text) return parseInteger(text_);
    const bool whole = kind_ == Kind::number && std::abs(number_) < 1e15 && std::trunc(number_) == number_;
    return whole ? std::optional<std::int64_t>(static_cast<std::int64_t>(number_)) : std::nullopt;
}

std::string_view MmcifCell::text(std::array<char, 32>& buffer) const {
    if (kind_ != Kind::number) return text_;
    const auto whole = integer();
    char* const end = buffer.data() + buffer.size();
    const auto written = whole ? std::to_chars(buffer.data(), end, *whole) : toChars(buffer.data(), end, number_);
    return {buffer.data(), static_cast<std::size_t>(written.ptr - buffer.data())};
}

std::optional<std::string_view> MmcifTable::get(std::size_t row, std::initializer_list<const char*> names) const {
    for (const char* name : names)
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i] == name) {
                if (const auto& value = cells[row * columns.size() + i]; value.data()) return value;
                break;
            }
    return std::nullopt;
}

MmcifModel::MmcifModel(const std::string& name, std::string_view document, const ReadOptions& options, int lastModel)
    : document_(document),
      options_(options),
      lastModel_(lastModel),
      mostCells_(std::min(kMostCells, kFewCells + kCellsPerAtom * options.maxAtoms)) {
    builders_.emplace_back(name, options.maxAtoms);
    if (modelsStandTogether(document)) together_ = MmcifAtoms::Models::packed;
}

bool MmcifModel::isKept(std::string_view category) {
    static constexpr std::string_view kKept[] = {"atom_site",
                                                 "atom_site_aniso",
                                                 "atom_site_anisotrop",
                                                 "ihm_sphere_obj_site",
                                                 "ihm_gaussian_obj_site",
                                                 "struct",
                                                 "struct_conn",
                                                 "entity",
                                                 "entity_poly",
                                                 "pdbx_struct_assembly",
                                                 "pdbx_struct_assembly_gen",
                                                 "pdbx_struct_oper_list",
                                                 "pdbx_model",
                                                 "chem_comp",
                                                 "chem_comp_atom",
                                                 "chem_comp_bond",
                                                 "struct_conf",
                                                 "struct_sheet_range",
                                                 "refine",
                                                 "ma_qa_metric",
                                                 "em_3d_reconstruction",
                                                 "cell",
                                                 "symmetry",
                                                 "symmetry_equiv",
                                                 "space_group",
                                                 "space_group_symop",
                                                 "chemical",
                                                 "exptl",
                                                 "entity_src_gen",
                                                 "entity_src_nat",
                                                 "pdbx_entity_src_syn",
                                                 "ma_target_ref_db_details"};
    return std::find(std::begin(kKept), std::end(kKept), category) != std::end(kKept);
}

bool MmcifModel::isKept(std::string_view category, std::string_view column) {
    using Table = MmcifDisplacements::Table;
    if (category == "atom_site")
        return MmcifAtoms::isKept(column) || MmcifDisplacements::isKept(Table::ofAtoms, column);
    if (category == "atom_site_anisotrop") return MmcifDisplacements::isKept(Table::own, column);
    return isKept(category);
}

void MmcifModel::beginBlock() {
    const auto hasRows = [&](const char* category) {
        const auto table = tables_.find(category);
        return table != tables_.end() && table->second.rows() > 0;
    };
    if (atoms_ || hasRows("chem_comp_atom") || hasRows("atom_site")) {
        done_ = true;
    } else {
        tables_.clear();
        displacements_ = {};
        cells_ = 0;
    }
    table_ = nullptr;
}

bool MmcifModel::beginCategory(const std::string& category, const std::vector<std::string>& columns,
                               std::uint64_t line) {
    if (done_) {
        if (category == "atom_site")
            builders_.front().leaveOut("data blocks", "only the first with atoms is read", line);
        return false;
    }
    const bool fractional = hasColumn(columns, "fract_") && !hasColumn(columns, "cartn_");
    const bool grains = category == "ihm_sphere_obj_site" || category == "ihm_gaussian_obj_site";
    if (grains || (category == "atom_site" && !fractional)) {
        if (!grains && sawAtomSite_) cannotRead(builders_.front().name(), "_atom_site occurs twice", line);
        sawAtomSite_ = sawAtomSite_ || !grains;
        if (!atoms_) atoms_ = std::make_unique<MmcifAtoms>(builders_, options_, lastModel_, together_);
        atoms_->begin(category, columns);
        displacements_.begin(MmcifDisplacements::Table::ofAtoms, columns);
        rows_ = Rows::atoms;
        return true;
    }
    if (!isKept(category)) return false;
    if (category == "atom_site_anisotrop") {
        displacements_.begin(MmcifDisplacements::Table::own, columns);
        rows_ = Rows::displacements;
        return true;
    }
    rows_ = Rows::table;
    table_ = &tables_[category];
    // Single values of a category may be scattered; together they form its one row.
    if (table_->rows() != 1) *table_ = MmcifTable();
    table_->columns.insert(table_->columns.end(), columns.begin(), columns.end());
    return true;
}

void MmcifModel::expectRows(std::size_t rows, std::size_t columns) const {
    if (rows > 0 && columns > (mostCells_ - std::min(cells_, mostCells_)) / rows)
        cannotRead(builders_.front().name(), "a category is too long");
}

void MmcifModel::addRow(const std::vector<MmcifCell>& cells, std::uint64_t line) {
    if (rows_ == Rows::atoms) {
        displacements_.addRow(cells.data());
        return atoms_->addRow(cells.data(), line);
    }
    if (rows_ == Rows::displacements) return displacements_.addRow(cells.data());
    cells_ += cells.size();
    if (cells_ > mostCells_) cannotRead(builders_.front().name(), "a category is too long", line);
    if (table_->lines.size() == table_->rows()) table_->lines.push_back(line);
    for (const MmcifCell& cell : cells) {
        table_->cells.push_back(kept(cell));
        cellBytes_ += table_->cells.back().size();
    }
    if (cellBytes_ > document_.size() + kMostRepeatedBytes)
        cannotRead(builders_.front().name(), "the texts of a category are too long", line);
}

/// In a hostile document every cell may refer to one long text: it is kept once, in place.
std::string_view MmcifModel::kept(const MmcifCell& cell) {
    if (cell.missing()) return {};
    std::array<char, 32> buffer{};
    const std::string_view text = cell.text(buffer);
    const std::less_equal<const char*> notAfter;
    if (notAfter(document_.data(), text.data()) &&
        notAfter(text.data() + text.size(), document_.data() + document_.size()))
        return text;
    return copies_.emplace_back(text);
}

/// Kind of each entity that has atoms.
std::vector<EntityKind> MmcifModel::entityKinds() {
    std::map<std::string_view, EntityKind> kinds;
    const MmcifTable &entities = tables_["entity"], &polymers = tables_["entity_poly"];
    if (together_ == MmcifAtoms::Models::packed) return std::vector<EntityKind>(atoms_->entities().size());
    for (std::size_t row = 0; row < entities.rows(); ++row) {
        const std::string type = lowerCase(entities.get(row, {"type"}).value_or(""));
        const bool small = type == "non-polymer" || type == "macrolide";
        kinds[entities.get(row, {"id"}).value_or("")] = small                ? EntityKind::nonPolymer
                                                        : type == "branched" ? EntityKind::branched
                                                        : type == "water"    ? EntityKind::water
                                                                             : EntityKind::unknown;
    }
    for (std::size_t row = 0; row < polymers.rows(); ++row) {
        const std::string type = lowerCase(polymers.get(row, {"type"}).value_or(""));
        EntityKind& kind = kinds[polymers.get(row, {"entity_id"}).value_or("")];
        if (startsWith(type, "polypeptide")) kind = EntityKind::protein;
        if (type.find("ribonucleotide") != std::string::npos) kind = EntityKind::nucleic;
    }
    std::vector<EntityKind> ofAtoms;
    for (const std::string& name : atoms_->entities()) ofAtoms.push_back(kinds[name]);
    return ofAtoms;
}

/// Processes the small categories for each model.
void MmcifModel::finishModels(FileSummary& file) {
    atoms_->summarise(file);
    // Each model reads all of these.
    if (builders_.size() > kMostCellsOfModels / std::max<std::size_t>(cells_, 1))
        cannotRead(builders_.front().name(), "it has too many models for its connections and helices");
    const std::vector<EntityKind> kinds = entityKinds();
    for (MoleculeBuilder& builder : builders_) {
        displacements_.apply(builder);
        builder.molecule().entities = atoms_->entities();
        for (Residue& residue : builder.molecule().residues)
            if (residue.entity > 0) residue.entityKind = kinds[residue.entity - 1];
        addStructConnBonds(builder, tables_["struct_conn"]);
        addComponentBonds(builder, tables_["chem_comp_bond"]);
        addSecondaryStructure(builder, tables_["struct_conf"], tables_["struct_sheet_range"]);
    }
    addMmcifAssemblies(builders_.front(), tables_["pdbx_struct_assembly"], tables_["pdbx_struct_assembly_gen"],
                       tables_["pdbx_struct_oper_list"], together_);
    namePackedScene(builders_.front().molecule());
}

/// Scenes of cells: cellPACK lists entities as paths of compartments, PetWorld names its models.
void MmcifModel::namePackedScene(Molecule& molecule) {
    if (molecule.assemblies.empty()) return;
    constexpr std::size_t kMany = 1000;  // copies: capsids and crystals have fewer
    const MmcifTable &assemblies = tables_["pdbx_struct_assembly"], &entities = tables_["entity"],
                     &models = tables_["pdbx_model"];
    std::size_t copies = 0;
    for (const AssemblyPart& part : molecule.assemblies.front().parts) copies += part.transforms.size();
    bool packed = together_ == MmcifAtoms::Models::packed || copies >= kMany;
    for (std::size_t row = 0; row < assemblies.rows(); ++row)
        packed = packed || lowerCase(assemblies.get(row, {"method_details"}).value_or("")) == "cellpack";
    if (!packed) return;
    FileSummary& file = molecule.file;
    file.packed = molecule.assemblies.front().id;
    const bool named = together_ == MmcifAtoms::Models::packed;
    for (std::size_t i = 0; named && i < std::min(models.rows(), molecule.entities.size()); ++i)
        file.entityNames[molecule.entities[i]] = printable(models.get(i, {"name"}).value_or(""), kLongestName);
    for (std::size_t row = 0; !named && row < entities.rows(); ++row)
        file.entityNames[std::string(entities.get(row, {"id"}).value_or(""))] =
            printable(entities.get(row, {"pdbx_description"}).value_or(""), kLongestName);
    std::erase_if(file.entityNames, [](const auto& entity) { return entity.second.empty(); });
}

std::vector<Molecule> MmcifModel::finish(const std::string& format) {
    MoleculeBuilder& builder = builders_.front();
    FileSummary& file = builder.molecule().file;
    file.format = format;
    const char* titleCategory = "chem_comp";
    if (atoms_) {
        titleCategory = "struct";
        finishModels(file);
    } else if (tables_["chem_comp_atom"].rows() > 0) {
        if (options_.model > 1) cannotRead(builder.name(), "a chemical component has only model 1");
        addComponent(builder, tables_["chem_comp_atom"], tables_["chem_comp_bond"]);
        file.format = format + "-chem_comp";
    } else if (tables_["atom_site"].rows() > 0) {
        if (options_.model > 1) cannotRead(builder.name(), "a small-molecule CIF has only model 1");
        titleCategory = "chemical";
        const bool old = tables_["symmetry_equiv"].rows() > 0;
        addSmallMolecule(builder,
                         {tables_["atom_site"], tables_["cell"], tables_[old ? "symmetry_equiv" : "space_group_symop"],
                          tables_["chemical"], tables_["atom_site_aniso"], spaceGroupName()});
        file.format = "cif-core";
    } else {
        cannotRead(builder.name(), "it has no _atom_site rows, so no atoms");
    }
    summarise(file, titleCategory);
    std::vector<Molecule> models;
    for (MoleculeBuilder& each : builders_) {
        if (&each != &builder) each.molecule().file = models.front().file;
        models.push_back(each.finish());
    }
    return models;
}

/// The file's names of chains and components, and their source organisms.
void MmcifModel::nameParts(Molecule& molecule) {
    FileSummary& file = molecule.file;
    const auto addTo = [&](std::string& list, const char* category, const char* column) {
        const MmcifTable& table = tables_[category];
        for (std::size_t row = 0; row < table.rows(); ++row)
            addToList(list, plainCase(table.get(row, {column}).value_or(""), true));
    };
    addTo(file.method, "exptl", "method");
    addTo(file.organism, "entity_src_gen", "pdbx_gene_src_scientific_name");
    addTo(file.organism, "entity_src_nat", "pdbx_organism_scientific");
    addTo(file.organism, "pdbx_entity_src_syn", "organism_scientific");
    addTo(file.organism, "ma_target_ref_db_details", "organism_scientific");
    const MmcifTable &components = tables_["chem_comp"], &entities = tables_["entity"];
    for (std::size_t row = 0; row < components.rows(); ++row)
        if (lowerCase(components.get(row, {"mon_nstd_flag"}).value_or("")) != "y")
            noteName(file.componentNames, components.get(row, {"id"}).value_or(""),
                     plainComponentName(components.get(row, {"name"}).value_or(""),
                                        components.get(row, {"pdbx_synonyms"}).value_or("")));
    std::map<std::string_view, std::string_view> described;
    for (std::size_t row = 0; row < entities.rows(); ++row)
        described[entities.get(row, {"id"}).value_or("")] = entities.get(row, {"pdbx_description"}).value_or("");
    for (const Residue& residue : molecule.residues) {
        if (residue.entityKind != EntityKind::protein && residue.entityKind != EntityKind::nucleic) continue;
        const std::string& chain = molecule.chains[residue.chain].name;
        if (file.chainNames.contains(chain)) continue;
        noteName(file.chainNames, chain, plainCase(described[molecule.entities[residue.entity - 1]], true));
    }
}

void MmcifModel::summariseCrystal(FileSummary& file) {
    static constexpr const char* kColumns[6] = {"length_a",    "length_b",   "length_c",
                                                "angle_alpha", "angle_beta", "angle_gamma"};
    const MmcifTable& cell = tables_["cell"];
    if (cell.rows() == 0) return;
    std::array<double, 6> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto value = parseNumber(withoutUncertainty(cell.get(0, {kColumns[i]}).value_or("")));
        if (!value || !(*value > 0 && *value < (i < 3 ? 1e6 : 180))) {
            const bool stated = cell.get(0, {kColumns[i]}).has_value();
            if (stated) builders_.front().leaveOut("unit cells", "no usable lengths and angles", cell.lineNumber(0));
            return;
        }
        values[i] = *value;
    }
    file.cell = values;
    file.spaceGroup = spaceGroupName();
}

std::string MmcifModel::spaceGroupName() {
    for (const char* category : {"symmetry", "space_group"}) {
        const MmcifTable& table = tables_[category];
        for (std::size_t row = 0; row < table.rows(); ++row)
            if (const auto name = table.get(row, {"space_group_name_h-m", "name_h-m_alt", "name_h-m_full", "name_h-m"}))
                return std::string(*name);
    }
    return "";
}

void MmcifModel::summarise(FileSummary& file, const char* titleCategory) {
    summariseCrystal(file);
    setTitle(file, tables_[titleCategory]);
    for (const auto& [category, column] :
         {std::pair("refine", "ls_d_res_high"), std::pair("em_3d_reconstruction", "resolution")}) {
        const MmcifTable& table = tables_[category];
        if (file.resolution || table.rows() == 0) continue;
        const auto value = parseNumber(table.get(0, {column}).value_or(""));
        if (value && *value > 0 && *value < 1e6) file.resolution = *value;
    }
    nameParts(builders_.front().molecule());
    const MmcifTable& metrics = tables_["ma_qa_metric"];
    for (std::size_t row = 0; row < metrics.rows(); ++row)
        file.confidence = file.confidence || lowerCase(metrics.get(row, {"type"}).value_or("")) == "plddt" ||
                          lowerCase(metrics.get(row, {"name"}).value_or("")) == "plddt";
    const auto countRows = [&](const char* category) -> std::optional<std::int64_t> {
        const MmcifTable& table = tables_[category];
        if (table.columns.empty()) return std::nullopt;
        return static_cast<std::int64_t>(table.rows());
    };
    file.assemblies = countRows("pdbx_struct_assembly");
    file.operators = countRows("pdbx_struct_oper_list");
}

}  // namespace nacre
