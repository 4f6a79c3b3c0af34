#include "engine/molecule/mmcif_model.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre {

namespace {

constexpr std::size_t kMaxKeptCells = std::size_t{1} << 22;

bool isKept(const std::string& category) {
    return category == "struct" || category == "struct_conn" || category == "pdbx_struct_assembly" ||
           category == "pdbx_struct_oper_list" || category == "chem_comp" || category == "chem_comp_atom" ||
           category == "chem_comp_bond" || category == "struct_conf" || category == "struct_sheet_range" ||
           category == "refine" || category == "em_3d_reconstruction";
}

}  // namespace

std::optional<std::string_view> MmcifTable::get(std::size_t row, std::initializer_list<const char*> names) const {
    for (const char* name : names)
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i] == name) {
                if (const auto& value = cells[row * columns.size() + i]) return *value;
                break;
            }
    return std::nullopt;
}

void MmcifModel::beginBlock() {
    const auto component = tables_.find("chem_comp_atom");
    if (atoms_ || (component != tables_.end() && component->second.rows() > 0)) {
        done_ = true;
    } else {
        tables_.clear();
        cells_ = 0;
    }
    table_ = nullptr;
}

bool MmcifModel::beginCategory(const std::string& category, const std::vector<std::string>& columns,
                               std::uint64_t line) {
    if (done_) return false;
    // Small-molecule CIF has no categories: the whole tag, _atom_site_fract_x, comes as one.
    if (startsWith(category, "atom_site_fract_") || category == "cell_length_a") fractional_ = true;
    if (category == "atom_site") {
        if (atoms_) throw Error("cannot read molecule", builder_.name(), "_atom_site occurs twice", line);
        atoms_ = std::make_unique<MmcifAtoms>(builder_, columns, options_.model);
        table_ = nullptr;
        return true;
    }
    if (!isKept(category)) return false;
    table_ = &tables_[category];
    *table_ = MmcifTable();
    table_->columns = columns;
    return true;
}

void MmcifModel::addRow(const std::vector<MmcifCell>& cells, std::uint64_t line) {
    if (!table_) {
        atoms_->addRow(cells.data(), line);
        return;
    }
    cells_ += cells.size();
    if (cells_ > kMaxKeptCells) throw Error("cannot read molecule", builder_.name(), "a category is too long", line);
    for (const MmcifCell& cell : cells)
        table_->cells.push_back(cell.data() ? std::optional<std::string>(cell) : std::nullopt);
}

Molecule MmcifModel::finish(const std::string& format) {
    FileSummary& file = builder_.molecule().file;
    file.format = format;
    if (atoms_) {
        atoms_->summarise(file);
        addStructConnBonds(builder_, tables_["struct_conn"]);
        addSecondaryStructure(builder_, tables_["struct_conf"], tables_["struct_sheet_range"]);
    } else if (tables_["chem_comp_atom"].rows() > 0) {
        if (options_.model != 1)
            throw Error("cannot read molecule", builder_.name(), "a chemical component has only model 1");
        addComponent(builder_, tables_["chem_comp_atom"], tables_["chem_comp_bond"]);
        file.format = format + "-chem_comp";
    } else if (fractional_) {
        throw Error("cannot read molecule", builder_.name(),
                    "small-molecule CIF (fractional coordinates) is not supported; supported: " +
                        std::string("mmCIF with _atom_site.Cartn_x"));
    } else {
        throw Error("cannot read molecule", builder_.name(), "it has no _atom_site rows, so no atoms");
    }
    const MmcifTable& title = tables_[atoms_ ? "struct" : "chem_comp"];
    if (title.rows() > 0) file.title = std::string(title.get(0, {"title", "name"}).value_or(""));
    std::replace(file.title.begin(), file.title.end(), '\n', ' ');  // a long title is a text of several lines
    for (const auto& [category, column] :
         {std::pair("refine", "ls_d_res_high"), std::pair("em_3d_reconstruction", "resolution")}) {
        const MmcifTable& table = tables_[category];
        if (file.resolution || table.rows() == 0) continue;
        const auto value = parseNumber(table.get(0, {column}).value_or(""));
        if (value && *value > 0 && *value < 1e6) file.resolution = *value;
    }
    const auto rowsOf = [&](const char* category) -> std::optional<std::int64_t> {
        const auto found = tables_.find(category);
        if (found == tables_.end()) return std::nullopt;
        return static_cast<std::int64_t>(found->second.rows());
    };
    file.assemblies = rowsOf("pdbx_struct_assembly");
    file.operators = rowsOf("pdbx_struct_oper_list");
    return builder_.finish();
}

}  // namespace nacre
