#pragma once
// Positions in a grid of cells, to find neighbours. Internal to this folder.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/error.h"

namespace nacre {

/// Cells are sorted by number, so that distant positions cost nothing: 21 bits per axis, 2^20 cells in each direction.
class PlaceGrid {
public:
    /// @param reach  Å: the largest distance for near()
    PlaceGrid(const std::vector<glm::vec3>& places, double reach) : places_(places), reach_(reach) {
        entries_.reserve(places.size());
        for (std::uint32_t i = 0; i < places.size(); ++i) entries_.push_back({makeKey(findCell(places[i])), i});
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& l, const Entry& r) { return l.key != r.key ? l.key < r.key : l.index < r.index; });
    }

    /// Calls visit(index, squared distance) for each position at most `reach` away. In a protein a call tests about a
    /// hundred positions. @throws Error if all calls together test more than 100 million, and 4,000 per position: a
    /// crowd at one place would take forever
    template <typename Visit>
    void near(const glm::vec3& from, const Visit& visit) const {
        const Cell centre = findCell(from);
        const double most = reach_ * reach_;
        std::uint64_t looked = 0;
        for (std::int64_t x = centre.x - 1; x <= centre.x + 1; ++x) {
            for (std::int64_t y = centre.y - 1; y <= centre.y + 1; ++y) {
                const std::uint64_t first = makeKey({x, y, centre.z - 1}), last = makeKey({x, y, centre.z + 1});
                auto at = std::lower_bound(entries_.begin(), entries_.end(), first,
                                           [](const Entry& entry, std::uint64_t key) { return entry.key < key; });
                for (; at != entries_.end() && at->key <= last; ++at) {
                    ++looked;
                    const glm::dvec3 way = glm::dvec3(places_[at->index]) - glm::dvec3(from);
                    const double squared = glm::dot(way, way);
                    if (squared <= most) visit(at->index, squared);
                }
            }
        }
        if ((looked_ += looked) > 100'000'000 + 4'000 * entries_.size())
            throw Error("cannot find neighbours", "", "too many atoms lie at one place");
    }

private:
    struct Cell {
        std::int64_t x, y, z;
    };
    struct Entry {
        std::uint64_t key;
        std::uint32_t index;
    };

    Cell findCell(const glm::vec3& place) const {
        const auto axis = [&](float value) {
            constexpr double kFarthest = (1 << 20) - 2;
            const double cell = std::floor(static_cast<double>(value) / reach_);
            return static_cast<std::int64_t>(std::clamp(cell, -kFarthest, kFarthest)) + (1 << 20);
        };
        return {axis(place.x), axis(place.y), axis(place.z)};
    }
    static std::uint64_t makeKey(const Cell& cell) {
        return static_cast<std::uint64_t>(cell.x) << 42 | static_cast<std::uint64_t>(cell.y) << 21 |
               static_cast<std::uint64_t>(cell.z);
    }

    const std::vector<glm::vec3>& places_;
    double reach_;
    std::vector<Entry> entries_;
    mutable std::uint64_t looked_ = 0;  ///< positions tested by all calls
};

}  // namespace nacre
