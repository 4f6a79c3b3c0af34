#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace nacre {

/// Union-find: sets of the numbers below a count, initially one set per number.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::size_t count() const { return parent_.size(); }
    /// The smallest number of a set.
    std::uint32_t findRoot(std::uint32_t number) {
        while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
        return number;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t one = findRoot(a), other = findRoot(b);
        parent_[std::max(one, other)] = std::min(one, other);
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace nacre
