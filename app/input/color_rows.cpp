#include "app/input/color_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/picture/color_values.h"
#include "app/picture/option_values.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

using Column = TableColumn;

constexpr std::size_t kMostTableRows = 2'000'000;

struct ColumnName {
    std::string_view name;  ///< lower case
    Column column;
};
// Common names, then those of mmCIF and of Mol*'s annotations.
constexpr ColumnName kColumns[] = {{"chain", Column::chain},
                                   {"resi", Column::number},
                                   {"resn", Column::residue},
                                   {"atom", Column::atom},
                                   {"element", Column::element},
                                   {"id", Column::id},
                                   {"model", Column::model},
                                   {"icode", Column::insertion},
                                   {"value", Column::value},
                                   {"color", Column::color},
                                   {"colour", Column::color},
                                   {"label", Column::label},
                                   {"auth_asym_id", Column::chain},
                                   {"chain_id", Column::chain},
                                   {"label_asym_id", Column::labelChain},
                                   {"auth_seq_id", Column::number},
                                   {"residue_number", Column::number},
                                   {"resnum", Column::number},
                                   {"beg_auth_seq_id", Column::numberFirst},
                                   {"end_auth_seq_id", Column::numberLast},
                                   {"label_seq_id", Column::labelNumber},
                                   {"beg_label_seq_id", Column::labelFirst},
                                   {"end_label_seq_id", Column::labelLast},
                                   {"pdbx_pdb_ins_code", Column::insertion},
                                   {"auth_comp_id", Column::residue},
                                   {"label_comp_id", Column::residue},
                                   {"auth_atom_id", Column::atom},
                                   {"label_atom_id", Column::atom},
                                   {"type_symbol", Column::element},
                                   {"label_entity_id", Column::entity},
                                   {"atom_id", Column::id},
                                   {"atom_index", Column::index},
                                   {"tooltip", Column::ignored},
                                   {"group_id", Column::ignored}};
void range(const std::optional<std::int32_t>& first, const std::optional<std::int32_t>& last,
           std::optional<ColorTable::Numbers>& numbers) {
    if (first || last) numbers = {first.value_or(INT32_MIN + 1), last.value_or(INT32_MAX)};
}

}  // namespace

void ColorRows::header(const Cells& names, const std::string& chosen, std::uint64_t number) {
    std::vector<std::string> unknown;
    for (const std::string& name : names) {
        const std::string lower = lowerCase(name);
        const auto* known = std::find_if(std::begin(kColumns), std::end(kColumns),
                                         [&](const ColumnName& entry) { return entry.name == lower; });
        Column column = known == std::end(kColumns) ? Column::unknown : known->column;
        if (!chosen.empty()) {
            if (column == Column::value || column == Column::color) column = Column::ignored;
            if (name == chosen) column = Column::value;
        }
        if (column == Column::unknown) unknown.push_back(name);
        if (column == Column::value) table_.title = name;
        columns_.push_back(column);
    }
    if (!chosen.empty() && !has(Column::value))
        fail(number, "there is no column '" + chosen + "'" + suggestion(chosen, names));
    if (!has(Column::value) && !has(Column::color)) chooseUnknown(names, unknown, number);
    const bool names_ = std::any_of(columns_.begin(), columns_.end(), [](Column c) { return c < Column::color; });
    if (!names_)
        fail(number, "no column names residues or atoms: chain, resi, resn, atom, id, label_seq_id and the like");
}

void ColorRows::row(const Cells& cells, std::uint64_t number) {
    if (cells.size() != columns_.size())
        fail(number, "it has " + std::to_string(cells.size()) + " values, where the header names " +
                         std::to_string(columns_.size()));
    if (table_.rows.size() >= kMostTableRows)
        fail(number, "there are more than " + std::to_string(kMostTableRows) + " rows");
    ColorTable::Row row;
    row.number = number;
    first_ = last_ = labelFirst_ = labelLast_ = std::nullopt;
    bool any = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].empty()) continue;
        any = any || columns_[i] == Column::value || columns_[i] == Column::color;
        take(columns_[i], cells[i], row);
    }
    if (!any) return;  // the row has no data
    range(first_, last_, row.numbers);
    range(labelFirst_, labelLast_, row.labelNumbers);
    table_.rows.push_back(std::move(row));
}

ColorTable ColorRows::finish() {
    if (table_.rows.empty()) throw Error("cannot read colours", name_, "no row has a colour or a value");
    return std::move(table_);
}

void ColorRows::fail(std::uint64_t number, const std::string& why) const {
    const std::string place = "(" + table_.rowWord + " " + std::to_string(number) + "): ";
    throw Error("cannot read colours", name_, (number > 0 ? place : "") + why);  // columns of JSON have no row
}

bool ColorRows::has(Column column) const { return std::ranges::find(columns_, column) != columns_.end(); }

void ColorRows::chooseUnknown(const Cells& names, const std::vector<std::string>& unknown, std::uint64_t number) {
    if (unknown.size() != 1)
        fail(number, unknown.empty()
                         ? "no column has colours or values"
                         : "which column has the values: " + joinAlternatives(unknown) + "? (FILE:value=COLUMN)");
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == unknown[0] && columns_[i] == Column::unknown) columns_[i] = Column::value;
    table_.title = unknown[0];
}

template <typename Number>
Number ColorRows::whole(const std::string& text, std::uint64_t number, const char* what) const {
    Number value{};
    if (!readWhole(text, value)) fail(number, "'" + text + "' is not a " + what);
    return value;
}

/// "12", "12A", "12-20"; numbers may be negative.
void ColorRows::parseNumbers(const std::string& text, ColorTable::Row& row) const {
    const std::size_t dash = text.find('-', 1);
    if (dash != std::string::npos) {
        row.numbers = {whole<std::int32_t>(text.substr(0, dash), row.number, "residue number"),
                       whole<std::int32_t>(text.substr(dash + 1), row.number, "residue number")};
        return;
    }
    std::string digits = text;
    if (isLetter(digits.back()) && digits.size() > 1) {
        row.insertionCode = digits.back();
        digits.pop_back();
    }
    const auto value = whole<std::int32_t>(digits, row.number, "residue number");
    row.numbers = {value, value};
}

void ColorRows::take(Column column, const std::string& text, ColorTable::Row& row) {
    const auto number = [&] { return whole<std::int32_t>(text, row.number, "whole number"); };
    switch (column) {
        case Column::chain:
            row.chain = text;
            return;
        case Column::labelChain:
            row.labelChain = text;
            return;
        case Column::number:
            return parseNumbers(text, row);
        case Column::numberFirst:
            first_ = number();
            return;
        case Column::numberLast:
            last_ = number();
            return;
        case Column::labelNumber:
            row.labelNumbers = {number(), number()};
            return;
        case Column::labelFirst:
            labelFirst_ = number();
            return;
        case Column::labelLast:
            labelLast_ = number();
            return;
        case Column::insertion:
            if (text != "." && text != "?") row.insertionCode = text[0];
            return;
        case Column::residue:
            row.residue = text;
            return;
        case Column::atom:
            row.atom = text;
            return;
        case Column::element:
            row.element = elementFromSymbol(text);
            if (*row.element == 0) fail(row.number, "'" + text + "' is not an element");
            return;
        case Column::entity:
            row.entity = text;
            return;
        case Column::model:
            row.model = number();
            return;
        case Column::id:
            row.id = whole<std::uint32_t>(text, row.number, "valid atom number");
            return;
        case Column::index:
            row.id = whole<std::uint32_t>(text, row.number, "valid atom number") + 1;
            return;
        case Column::color:
            row.color = readColor(text, row.number);
            return;
        case Column::value:
            row.value = parseValue(text, row.number);
            return;
        case Column::label:
            row.label = text;
            return;
        case Column::ignored:
        case Column::unknown:
            return;
    }
}

std::uint32_t ColorRows::readColor(const std::string& text, std::uint64_t number) const {
    try {
        const std::array<float, 4> color = parseColor(text);
        if (color[3] < 1) fail(number, "a colour must be opaque: '" + text + "'");
        return opaqueColor(color);
    } catch (const std::invalid_argument& error) {
        fail(number, error.what());
    }
}
double ColorRows::parseValue(const std::string& text, std::uint64_t number) const {
    double value = 0;
    if (!readWhole(text, value) || !std::isfinite(value)) fail(number, "'" + text + "' is not a number");
    return value;
}

}  // namespace nacre::app
