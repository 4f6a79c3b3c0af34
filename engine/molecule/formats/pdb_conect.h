#pragma once
// CONECT records: collected during the scan, resolved when all atoms are known.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace nacre::pdb {

class ConectTable {
public:
    /// @param maxAtoms  of the molecule; limits the collected pairs
    explicit ConectTable(std::size_t maxAtoms) : mostPairs_(kPairsPerAtom * maxAtoms + kFewPairs) {}

    void add(std::string_view line, std::uint64_t lineNumber);

    /// Size for shrink(): to drop records that turn out irrelevant, take it before them.
    std::size_t size() const { return pairs_.size(); }
    void shrink(std::size_t size) { pairs_.resize(std::min(size, pairs_.size())); }

    /// Adds the bonds, sets FileSummary::conectUniquePairs and warns about ignored records.
    /// @param serials  of the molecule's atoms, in order; negative if unreadable
    void resolve(const std::vector<std::int64_t>& serials, Molecule& molecule) const;

    bool empty() const { return pairs_.empty() && unreadable_ == 0; }

private:
    // Each bond is usually listed from both sides.
    static constexpr std::size_t kPairsPerAtom = 16, kFewPairs = 1000;

    struct Pair {
        std::int32_t from;  // five digits, or hybrid-36, which ends at 87,440,031
        std::int32_t to;
        std::uint32_t line;
        std::uint8_t order;
    };
    std::vector<Pair> pairs_;
    std::size_t mostPairs_, tooMany_ = 0;
    std::uint64_t firstTooMany_ = 0;
    std::size_t unreadable_ = 0;
    std::uint64_t firstUnreadable_ = 0;
};

}  // namespace nacre::pdb
