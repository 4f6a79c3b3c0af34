#pragma once
// Annotations of a MolViewSpec scene: tables in CIF, BinaryCIF or JSON that assign colours, labels, tooltips or
// components to chains, residues or atoms.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/expressions.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostAnnotationRows = 1'000'000;
constexpr std::size_t kMostAnnotationCells = 4'000'000;
constexpr std::size_t kMostAnnotationFields = 100;  ///< maximum number of fields in a text

/// Columns of a table as text; missing values are empty optionals.
struct AnnotationTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::optional<std::string>>> rows;
};

/// Identifies a table in a file.
struct TablePlace {
    std::string block;           ///< header of the data block; empty: by `blockIndex`
    std::size_t blockIndex = 0;  ///< from 0
    std::string category;        ///< without '_'; empty: the block's first
};

/// The table in a text in CIF, BinaryCIF or JSON, detected by content. Skips unwanted columns. @param name  for
/// messages @throws Error
AnnotationTable readTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                          const std::vector<std::string_view>& wanted);

struct AnnotationRow {
    Expression expression;
    std::vector<std::optional<std::string>> values;  ///< of the requested columns, at least one

    const std::optional<std::string>& value() const { return values.front(); }
};

/// The columns to read.
struct AnnotationFields {
    std::vector<std::string> values;  ///< columns, at least one
    /// Column names for fields of the schema; empty: ignore the field. Unlisted fields keep their names.
    std::map<std::string, std::string, std::less<>> columns;
};

/// @param schema  as in fieldsOfSchema()
/// @throws Error
std::vector<AnnotationRow> readAnnotations(const std::string& name, const std::string& bytes, const TablePlace& place,
                                           std::string_view schema, const AnnotationFields& fields);

}  // namespace nacre::app::mvs
