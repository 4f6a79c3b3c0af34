#pragma once
// The rows of a colour table: meaning of columns, and parsing of cells.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/color/color_table.h"

namespace nacre::app {

/// The content of a cell; empty: none.
using Cells = std::vector<std::string>;

/// Meaning of a column of a table.
enum class TableColumn : std::uint8_t {
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

class ColorRows {
public:
    /// @param name  of the file, for errors @param word  for a row: "line"
    ColorRows(std::string name, std::string word) : name_(std::move(name)) { table_.rowWord = std::move(word); }

    /// @param chosen  the column of the values; empty: the only unknown one, if none is named value
    void header(const Cells& names, const std::string& chosen, std::uint64_t number);
    void row(const Cells& cells, std::uint64_t number);
    /// @throws Error if no row has a colour or a value
    ColorTable finish();
    /// @throws Error with the row
    [[noreturn]] void fail(std::uint64_t number, const std::string& why) const;

private:
    using Column = TableColumn;
    bool has(Column column) const;
    void chooseUnknown(const Cells& names, const std::vector<std::string>& unknown, std::uint64_t number);
    template <typename Number>
    Number whole(const std::string& text, std::uint64_t number, const char* what) const;
    void parseNumbers(const std::string& text, ColorTable::Row& row) const;
    void take(Column column, const std::string& text, ColorTable::Row& row);
    std::uint32_t readColor(const std::string& text, std::uint64_t number) const;
    double parseValue(const std::string& text, std::uint64_t number) const;

    std::string name_;
    ColorTable table_;
    std::vector<Column> columns_;
    std::optional<std::int32_t> first_, last_, labelFirst_, labelLast_;  ///< of the current row
};

}  // namespace nacre::app
