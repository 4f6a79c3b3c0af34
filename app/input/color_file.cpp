#include "app/input/color_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/files/json_text.h"
#include "app/picture/appearance_values.h"
#include "app/picture/geometry_options.h"
#include "app/picture/option_values.h"
#include "app/picture/srgb.h"
#include "engine/error.h"
#include "engine/molecule/element.h"
#include "engine/molecule/floating_point.h"
#include "engine/molecule/nearest_word.h"
#include "engine/molecule/text.h"

namespace nacre::app {
namespace {

using TableJson = nlohmann::ordered_json;

constexpr std::size_t kMostTableBytes = std::size_t{64} << 20, kMostTableRows = 2'000'000, kMostColumns = 1000;

enum class Column : std::uint8_t {
    chain,
    labelChain,
    number,
    numberFirst,
    numberLast,
    labelNumber,
    labelFirst,
    labelLast,
    insertion,
    residue,
    atom,
    element,
    entity,
    model,
    id,
    index,
    color,
    value,
    label,
    ignored,
    unknown
};

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

/// The content of a cell; empty: none.
using Cells = std::vector<std::string>;

class TableReader {
public:
    TableReader(std::string name, std::string word) : name_(std::move(name)) { table_.rowWord = std::move(word); }

    /// @param chosen  the column of the values; empty: the only unknown one, if none is named value
    void header(const Cells& names, const std::string& chosen, std::uint64_t number) {
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

    void row(const Cells& cells, std::uint64_t number) {
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
        if (!any) return;  // no data for it
        range(first_, last_, row.numbers);
        range(labelFirst_, labelLast_, row.labelNumbers);
        table_.rows.push_back(std::move(row));
    }

    ColorTable finish() {
        if (table_.rows.empty()) throw Error("cannot read colours", name_, "no row has a colour or a value");
        return std::move(table_);
    }

    [[noreturn]] void fail(std::uint64_t number, const std::string& why) const {
        const std::string place = "(" + table_.rowWord + " " + std::to_string(number) + "): ";
        throw Error("cannot read colours", name_, (number > 0 ? place : "") + why);  // columns of JSON have no row
    }

private:
    bool has(Column column) const { return std::find(columns_.begin(), columns_.end(), column) != columns_.end(); }

    void chooseUnknown(const Cells& names, const std::vector<std::string>& unknown, std::uint64_t number) {
        if (unknown.size() != 1)
            fail(number, unknown.empty() ? "no column has colours or values"
                                         : "which column has the values: " + anyOf(unknown) + "? (FILE:value=COLUMN)");
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == unknown[0] && columns_[i] == Column::unknown) columns_[i] = Column::value;
        table_.title = unknown[0];
    }

    template <typename Number>
    Number whole(const std::string& text, std::uint64_t number, const char* what) const {
        Number value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) fail(number, "'" + text + "' is not a " + what);
        return value;
    }

    /// "12", "12A", "12-20"; numbers may be negative.
    void numbersOf(const std::string& text, ColorTable::Row& row) const {
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

    void range(const std::optional<std::int32_t>& first, const std::optional<std::int32_t>& last,
               std::optional<ColorTable::Numbers>& numbers) const {
        if (first || last) numbers = {first.value_or(INT32_MIN + 1), last.value_or(INT32_MAX)};
    }

    void take(Column column, const std::string& text, ColorTable::Row& row) {
        const auto number = [&] { return whole<std::int32_t>(text, row.number, "whole number"); };
        switch (column) {
            case Column::chain:
                row.chain = text;
                return;
            case Column::labelChain:
                row.labelChain = text;
                return;
            case Column::number:
                return numbersOf(text, row);
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
                row.color = colorOf(text, row.number);
                return;
            case Column::value:
                row.value = valueOf(text, row.number);
                return;
            case Column::label:
                row.label = text;
                return;
            case Column::ignored:
            case Column::unknown:
                return;
        }
    }

    std::uint32_t colorOf(const std::string& text, std::uint64_t number) const {
        try {
            const std::array<float, 4> color = parseColor(text);
            if (color[3] < 1) fail(number, "a colour must be opaque: '" + text + "'");
            return packedColor(std::uint32_t{toByte(color[0])} << 16 | std::uint32_t{toByte(color[1])} << 8 |
                               std::uint32_t{toByte(color[2])});
        } catch (const std::invalid_argument& error) {
            fail(number, error.what());
        }
    }
    double valueOf(const std::string& text, std::uint64_t number) const {
        double value = 0;
        const auto [end, error] = fromChars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
            fail(number, "'" + text + "' is not a number");
        return value;
    }

    std::string name_;
    ColorTable table_;
    std::vector<Column> columns_;
    std::optional<std::int32_t> first_, last_, labelFirst_, labelLast_;  ///< of the current row
};

/// The cells of a line. A quoted cell may contain the separator, and quotes as "".
Cells cellsOf(std::string_view line, char separator) {
    Cells cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
            cells.back() += line[++i];
        else if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    }
    for (std::string& cell : cells) {
        cell.erase(0, std::min(cell.find_first_not_of(" \t\r"), cell.size()));
        cell.erase(cell.find_last_not_of(" \t\r") + 1);
    }
    return cells;
}

ColorTable readCsv(std::string_view text, const std::string& name, const std::string& column, char lineEnd) {
    TableReader reader(name, "line");
    std::uint64_t number = 0;
    char separator = '\0';
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(lineEnd), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        if (separator == '\0') {
            if (line[0] == '#') continue;
            separator = ',';
            for (const char sign : {'\t', ';'})
                if (sign != lineEnd && line.find(',') == std::string_view::npos &&
                    line.find(sign) != std::string_view::npos)
                    separator = sign;
            const Cells names = cellsOf(line, separator);
            if (names.size() > kMostColumns) reader.fail(number, "it has more than 1000 columns");
            reader.header(names, column, number);
        } else {
            reader.row(cellsOf(line, separator), number);
        }
    }
    return reader.finish();
}

std::string textOf(const TableJson& value) {
    if (value.is_null()) return {};
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// A list of objects, or an object of lists.
ColorTable readJson(const std::string& text, const std::string& name, const std::string& column) {
    const auto refuse = [&](const std::string& why) { throw Error("cannot read colours", name, why); };
    const auto json = parseJsonText<TableJson>(text, "cannot read colours", name);
    TableReader reader(name, "row");
    Cells names;
    std::vector<Cells> rows;
    const auto columnOf = [&](const std::string& key) {
        const auto at = static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin());
        if (at == names.size()) names.push_back(key);
        if (names.size() > kMostColumns) refuse("it has more than 1000 columns");
        return at;
    };
    if (json.is_object()) {
        for (const auto& [key, list] : json.items()) {
            if (!list.is_array()) refuse("\"" + key + "\": expected a list");
            if (!rows.empty() && rows.size() != list.size())
                refuse("\"" + key + "\" has " + std::to_string(list.size()) + " values, where others have " +
                       std::to_string(rows.size()));
            rows.resize(list.size());
            const std::size_t at = columnOf(key);
            for (std::size_t i = 0; i < list.size(); ++i) {
                rows[i].resize(at + 1);
                rows[i][at] = textOf(list[i]);
            }
        }
    } else if (json.is_array()) {
        for (const TableJson& one : json) {
            if (!one.is_object()) refuse("(row " + std::to_string(rows.size() + 1) + "): expected an object");
            Cells& cells = rows.emplace_back();
            for (const auto& [key, value] : one.items()) {
                const std::size_t at = columnOf(key);
                if (cells.size() <= at) cells.resize(at + 1);
                cells[at] = textOf(value);
            }
        }
    } else {
        refuse("expected a list of objects, or an object of lists");
    }
    reader.header(names, column, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].resize(names.size());
        reader.row(rows[i], i + 1);
    }
    return reader.finish();
}

std::string bytesOfTable(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw Error("cannot read colours", path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error("cannot read colours", path, "the file is missing or not readable");
    std::string text;
    std::array<char, 1 << 16> buffer{};
    while (file.read(buffer.data(), buffer.size()) || file.gcount() > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > kMostTableBytes)
            throw Error("cannot read colours", path,
                        "it is larger than the limit of " + std::to_string(kMostTableBytes >> 20) + " MB");
    }
    return text;
}

}  // namespace

ColorTable readColorTable(const std::string& text, const std::string& name, const std::string& column) {
    if (isJsonText(text)) return readJson(text, name, column);
    return readCsv(text, name, column, '\n');
}

RepresentationOptions withTables(RepresentationOptions look) {
    for (Coloring& coloring : look.colorFrom) {
        if (coloring.table) continue;
        constexpr std::string_view kCsv = "csv:";
        ColorTable table;
        if (coloring.source.starts_with(kCsv))
            table =
                readCsv(std::string_view(coloring.source).substr(kCsv.size()), "--color-from", coloring.column, ';');
        else if (isTableText(coloring.source))
            table = readColorTable(coloring.source, "--color-from", coloring.column);
        else
            table = readColorTable(bytesOfTable(coloring.source), coloring.source, coloring.column);
        coloring.table = std::make_shared<const ColorTable>(std::move(table));
    }
    return look;
}

}  // namespace nacre::app
