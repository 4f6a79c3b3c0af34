#pragma once
// Finds atoms by their numbers in a file.

#include <cstdint>
#include <map>
#include <vector>

namespace nacre {

/// A table for consecutive numbers, the usual case; a tree for sparse ones. No hash: a file could choose colliding
/// numbers.
class IdIndex {
public:
    enum class Found : std::uint8_t { none, one, several };

    /// @param ids  of the atoms, in order; negative ones are never found
    explicit IdIndex(const std::vector<std::int64_t>& ids);

    /// @param atom  set to the atom's index, if the number is unique
    Found find(std::int64_t id, std::uint32_t& atom) const;
    /// Whether any number repeats.
    bool repeats() const { return repeats_; }

private:
    std::vector<std::uint32_t> table_;
    std::map<std::int64_t, std::uint32_t> tree_;  ///< instead of the table
    bool repeats_ = false;
};

}  // namespace nacre
