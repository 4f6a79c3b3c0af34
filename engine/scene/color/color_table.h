#pragma once
// Colours or numbers for residues and atoms from outside the molecule's file. Independent of files.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/molecule/residue_facts.h"

namespace nacre {

/// Each row selects atoms that match all its keys, and gives them a colour or a value. The last matching row wins.
struct ColorTable {
    struct Numbers {
        std::int32_t first = 0, last = 0;
    };
    struct Row {
        std::optional<std::string> chain;       ///< author's: auth_asym_id
        std::optional<std::string> labelChain;  ///< label_asym_id, as in Molecule::subchains
        std::optional<Numbers> numbers;         ///< author's: auth_seq_id
        std::optional<Numbers> labelNumbers;    ///< label_seq_id
        std::optional<char> insertionCode;      ///< '\0': residues without one
        std::optional<std::string> residue, atom, entity;
        std::optional<Element> element;
        std::optional<int> model;
        std::optional<std::uint32_t> id;  ///< 1-based position of the atom in the file
        double value = std::numeric_limits<double>::quiet_NaN();
        std::uint32_t color = 0;   ///< packed as in colors.h; 0: use the value
        std::string label;         ///< for its colour in the legend
        std::uint64_t number = 0;  ///< line of the file, or index of the row
    };
    std::string title;    ///< meaning of the values, for the legend
    std::string rowWord;  ///< "line" or "row", for Row::number
    std::vector<Row> rows;
};

struct TableMatch {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> rows;  ///< for each atom of the molecule the matching row, or kNone
    std::size_t idle = 0;             ///< rows that match no atom
    std::uint64_t firstIdle = 0;      ///< Row::number of the first one
};

/// @throws Error if it would take too long: many rows without a residue number or an atom id
TableMatch matchTable(const ResidueFacts& facts, const ColorTable& table);

}  // namespace nacre
