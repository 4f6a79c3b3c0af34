#include "app/input/color_file.h"

#include <algorithm>

#include "app/files/json_text.h"
#include "app/input/color_rows.h"
#include "app/picture/appearance_values.h"
#include "app/picture/geometry_options.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

using TableJson = nlohmann::ordered_json;

constexpr std::size_t kMostTableBytes = std::size_t{64} << 20, kMostColumns = 1000;

/// The cells of a line. A quoted cell may contain the separator, and quotes as "".
Cells splitCells(std::string_view line, char separator) {
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
    ColorRows reader(name, "line");
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
            const Cells names = splitCells(line, separator);
            if (names.size() > kMostColumns) reader.fail(number, "it has more than 1000 columns");
            reader.header(names, column, number);
        } else {
            reader.row(splitCells(line, separator), number);
        }
    }
    return reader.finish();
}

std::string toText(const TableJson& value) {
    if (value.is_null()) return {};
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// A list of objects, or an object of lists.
ColorTable readJson(const std::string& text, const std::string& name, const std::string& column) {
    const auto refuse = [&](const std::string& why) { throw Error("cannot read colours", name, why); };
    const auto json = parseJsonText<TableJson>(text, "cannot read colours", name);
    ColorRows reader(name, "row");
    Cells names;
    std::vector<Cells> rows;
    const auto findColumn = [&](const std::string& key) {
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
            const std::size_t at = findColumn(key);
            for (std::size_t i = 0; i < list.size(); ++i) {
                rows[i].resize(at + 1);
                rows[i][at] = toText(list[i]);
            }
        }
    } else if (json.is_array()) {
        for (const TableJson& one : json) {
            if (!one.is_object()) refuse("(row " + std::to_string(rows.size() + 1) + "): expected an object");
            Cells& cells = rows.emplace_back();
            for (const auto& [key, value] : one.items()) {
                const std::size_t at = findColumn(key);
                if (cells.size() <= at) cells.resize(at + 1);
                cells[at] = toText(value);
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
            table = readColorTable(readTextFile("cannot read colours", coloring.source, kMostTableBytes),
                                   coloring.source, coloring.column);
        coloring.table = std::make_shared<const ColorTable>(std::move(table));
    }
    return look;
}

}  // namespace nacre::app
