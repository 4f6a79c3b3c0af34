#pragma once
// Atoms by the numbers that a file gives them.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace nacre {

/// A table where files number their atoms one after the other, as they do; where one does not, and its table would be
/// mostly holes, a tree. No hash, for which a file could choose numbers that collide.
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
    std::vector<std::uint32_t> table_;
    std::map<std::int64_t, std::uint32_t> tree_;  ///< without a table
    bool repeats_ = false;
};

}  // namespace nacre
