#pragma once
// Annotations of a MolViewSpec scene: tables in CIF, BinaryCIF or JSON that say of chains, residues or atoms which
// colour, label, tooltip or component is theirs.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/mvs/expressions.h"

namespace nacre::app::mvs {

constexpr std::size_t kMostAnnotationRows = 1'000'000;
constexpr std::size_t kMostAnnotationCells = 4'000'000;
constexpr std::size_t kMostAnnotationFields = 100;  ///< that a text names

/// Columns of a table as text; missing values are empty optionals.
struct AnnotationTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::optional<std::string>>> rows;
};

/// Which table of a file.
struct TablePlace {
    std::string block;           ///< header of the data block; empty: by `blockIndex`
    std::size_t blockIndex = 0;  ///< from 0
    std::string category;        ///< without '_'; empty: the block's first
};

/// The table of a text in CIF, BinaryCIF or JSON; the content decides which. Columns that are not wanted are passed
/// over. @param name  for messages @throws Error
AnnotationTable readTable(const std::string& name, const std::string& bytes, const TablePlace& place,
                          const std::vector<std::string_view>& wanted);

struct AnnotationRow {
    Expression expression;
    std::vector<std::optional<std::string>> values;  ///< of the columns that are asked for, at least one

    const std::optional<std::string>& value() const { return values.front(); }
};

/// The columns that are read.
struct AnnotationFields {
    std::vector<std::string> values;  ///< columns, at least one
    /// Columns that stand for fields of the schema; empty: the field is ignored. Others have their own names.
    std::map<std::string, std::string, std::less<>> columns;
};

/// @param schema  as fieldsOfSchema()
/// @throws Error
std::vector<AnnotationRow> readAnnotations(const std::string& name, const std::string& bytes, const TablePlace& place,
                                           std::string_view schema, const AnnotationFields& fields);

}  // namespace nacre::app::mvs
