#pragma once
// Colours or numbers of residues and atoms that come from outside the molecule's file. Knows no file.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Each row names atoms by all that it states, and gives them a colour or a value. Of several rows the last prevails.
struct ColorTable {
    struct Numbers {
        std::int32_t first = 0, last = 0;
    };
    struct Row {
        std::optional<std::string> chain;       ///< the author's: auth_asym_id
        std::optional<std::string> labelChain;  ///< label_asym_id, as Molecule::subchains has it
        std::optional<Numbers> numbers;         ///< the author's: auth_seq_id
        std::optional<Numbers> labelNumbers;    ///< label_seq_id
        std::optional<char> insertionCode;      ///< '\0': residues without one
        std::optional<std::string> residue, atom, entity;
        std::optional<Element> element;
        std::optional<int> model;
        std::optional<std::uint32_t> id;  ///< 1-based position of the atom in the file
        double value = std::numeric_limits<double>::quiet_NaN();
        std::uint32_t color = 0;   ///< as colors.h packs it; 0: the value is meant
        std::string label;         ///< of its colour in the legend
        std::uint64_t number = 0;  ///< line of the file, or the row's place in it
    };
    std::string title;    ///< what the values are, for the legend
    std::string rowWord;  ///< "line" or "row", for Row::number
    std::vector<Row> rows;
};

struct TableMatch {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> rows;  ///< of each atom of the molecule the row that prevails, or kNone
    std::size_t idle = 0;             ///< rows that match no atom
    std::uint64_t firstIdle = 0;      ///< Row::number of the first of them
};

/// @throws Error if that takes too long: many rows that state neither a residue's number nor an atom's id
TableMatch matchTable(const ResidueFacts& facts, const ColorTable& table);

}  // namespace nacre
