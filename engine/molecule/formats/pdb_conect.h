#pragma once
// CONECT records: gathered while the file is scanned, resolved when all atoms are known.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre::pdb {

class ConectTable {
public:
    void add(std::string_view line, std::uint64_t lineNumber);

    /// Adds the stated bonds, sets FileSummary::conectUniquePairs and warns of what was ignored.
    /// @param serials  of the molecule's atoms, in order; negative where an atom has none that can be read
    void resolve(const std::vector<std::int64_t>& serials, Molecule& molecule) const;

    bool empty() const { return pairs_.empty() && unreadable_ == 0; }

private:
    struct Pair {
        std::int64_t from;
        std::int64_t to;
        std::uint64_t line;
        std::uint8_t order;
    };
    std::vector<Pair> pairs_;
    std::size_t unreadable_ = 0;
    std::uint64_t firstUnreadable_ = 0;
};

}  // namespace nacre::pdb
