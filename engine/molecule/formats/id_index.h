#pragma once
// Atoms by the numbers that a file gives them.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace nacre {

/// A table where files number their atoms one after the other, as they do; where one does not, and its table would be
/// mostly holes, a sorted list. No hash, for which a file could choose numbers that collide.
class IdIndex {
public:
    enum class Found : std::uint8_t { none, one, several };

    /// @param ids  of the atoms, in order; negative ones are never found
    explicit IdIndex(const std::vector<std::int64_t>& ids);

    /// @param atom  set to the index of the atom of that number, if it is one alone
    Found find(std::int64_t id, std::uint32_t& atom) const;
    /// Whether any number stands twice.
    bool repeats() const { return repeats_; }

private:
    using Entry = std::pair<std::int64_t, std::uint32_t>;
    void fillTable(const std::vector<std::int64_t>& ids, std::size_t size);
    void sortEntries(const std::vector<std::int64_t>& ids);
    Found findSorted(std::int64_t id, std::uint32_t& atom) const;

    std::vector<std::uint32_t> table_;
    std::vector<Entry> entries_;
    bool repeats_ = false;
};

}  // namespace nacre
