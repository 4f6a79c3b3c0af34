#include "app/mvs/annotations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/files/json_text.h"
#include "app/mvs/cif_rows.h"
#include "engine/error.h"
#include "engine/molecule/text.h"

namespace nacre::app::mvs {
namespace {

[[noreturn]] void refuseTable(const std::string& name, const std::string& why) {
    throw Error("cannot read annotations", name, why);
}

std::optional<std::string> toCell(const Json& value) {
    if (value.is_null()) return std::nullopt;
    if (value.is_number_float() && std::abs(value.get<double>()) < 1e15 &&
        std::trunc(value.get<double>()) == value.get<double>())
        return std::to_string(value.get<std::int64_t>());  // 2.0 as 2
    return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', true);
}

void checkSize(const std::string& name, std::size_t rows, std::size_t columns) {
    if (rows > kMostAnnotationRows || rows * std::max<std::size_t>(columns, 1) > kMostAnnotationCells)
        refuseTable(name, "it has more than " + std::to_string(kMostAnnotationRows) + " rows or " +
                              std::to_string(kMostAnnotationCells) + " values");
}

/// Reads a list of rows, each an object.
AnnotationTable fromRows(const std::string& name, const Json& json, const std::vector<std::string_view>& wanted) {
    AnnotationTable table;
    table.columns.assign(wanted.begin(), wanted.end());
    checkSize(name, json.size(), table.columns.size());
    for (const Json& row : json) {
        if (!row.is_object()) refuseTable(name, "row " + std::to_string(table.rows.size() + 1) + " is no object");
        auto& cells = table.rows.emplace_back();
        for (const std::string& column : table.columns) {
            const auto found = row.find(column);
            cells.push_back(found == row.end() ? std::nullopt : toCell(*found));
        }
    }
    return table;
}

/// Reads an object of columns, each a list.
AnnotationTable fromColumns(const std::string& name, const Json& json, const std::vector<std::string_view>& wanted) {
    AnnotationTable table;
    std::size_t rows = 0;
    for (const auto& [key, values] : json.items()) {
        if (!values.is_array()) refuseTable(name, "\"" + nacre::printable(key) + "\" is no list");
        if (rows != 0 && values.size() != rows) refuseTable(name, "its columns differ in length");
        rows = values.size();
    }
    for (const std::string_view column : wanted)
        if (json.contains(std::string(column))) table.columns.emplace_back(column);
    checkSize(name, rows, table.columns.size());
    table.rows.resize(rows);
    for (const std::string& column : table.columns) {
        std::size_t i = 0;
        for (const Json& value : json[column]) table.rows[i++].push_back(toCell(value));
    }
    return table;
}

AnnotationTable fromJson(const std::string& name, const std::string& text,
                         const std::vector<std::string_view>& wanted) {
    if (text.size() > kMostSceneBytes)
        refuseTable(name, "it is larger than " + std::to_string(kMostSceneBytes >> 20) + " MiB");
    const Json json = parseJson<Json>(text);
    if (json.is_discarded()) refuseTable(name, "it is no JSON");
    if (json.is_array()) return fromRows(name, json, wanted);
    if (!json.is_object()) refuseTable(name, "it is neither a list of rows nor an object of columns");
    const bool columns = std::any_of(json.begin(), json.end(), [](const Json& value) { return value.is_array(); });
    return columns ? fromColumns(name, json, wanted) : fromRows(name, Json::array({json}), wanted);
}

}  // namespace

AnnotationTable readTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                          const std::vector<std::string_view>& wanted) {
    const std::size_t start = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (start == std::string::npos) refuseTable(name, "it is empty");
    if (bytes[start] == '{' || bytes[start] == '[') return fromJson(name, bytes, wanted);
    return readCifTable(name, bytes, place, wanted);
}

std::vector<AnnotationRow> readAnnotations(const std::string& name, const std::string& bytes, const TablePlace& place,
                                           std::string_view schema, const AnnotationFields& fields) {
    const std::vector<std::string_view>* known = fieldsOfSchema(schema);
    if (!known) refuseTable(name, "there is no schema '" + nacre::printable(schema) + "'");
    std::vector<std::string_view> wanted;
    const auto want = [&](std::string_view column) {
        if (std::find(wanted.begin(), wanted.end(), column) == wanted.end()) wanted.push_back(column);
    };
    std::vector<std::pair<std::string_view, std::string_view>> used;  // fields of the schema and their columns
    for (const std::string_view field : *known) {
        const auto other = fields.columns.find(field);
        const std::string_view column = other == fields.columns.end() ? field : std::string_view(other->second);
        if (column.empty()) continue;
        used.emplace_back(field, column);
        want(column);
    }
    for (const std::string& column : fields.values) want(column);
    const AnnotationTable table = readTable(name, bytes, place, wanted);
    std::vector<AnnotationRow> rows;
    rows.reserve(table.rows.size());
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        AnnotationRow& row = rows.emplace_back();
        row.values.resize(fields.values.size());
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const auto& cell = table.rows[i][c];
            const std::string& column = table.columns[c];
            if (!cell) continue;
            for (std::size_t v = 0; v < fields.values.size(); ++v)
                if (fields.values[v] == column) row.values[v] = *cell;
            for (const auto& [field, from] : used) {
                if (from != column) continue;
                try {
                    setField(row.expression, field, Json(*cell));
                } catch (const std::invalid_argument& why) {
                    refuseTable(name, "row " + std::to_string(i + 1) + ", " + column + ": " + why.what());
                }
            }
        }
    }
    return rows;
}

}  // namespace nacre::app::mvs
