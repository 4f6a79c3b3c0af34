// The best distribution of pi bonds: dynamic programming over a frontier of atoms.

#include <algorithm>
#include <unordered_map>

#include "engine/molecule/chemistry/steps.h"

namespace nacre {
namespace {

/// Bonds in an order that opens and closes atoms quickly: breadth first from each start.
std::vector<std::uint32_t> frontierOrder(const PiSystem& system) {
    std::vector<std::vector<std::uint32_t>> atomBonds(system.atoms.size());
    for (std::uint32_t b = 0; b < system.bonds.size(); ++b) {
        atomBonds[system.bonds[b].a].push_back(b);
        atomBonds[system.bonds[b].b].push_back(b);
    }
    std::vector<std::uint32_t> starts(system.atoms.size()), order, queue;
    for (std::uint32_t i = 0; i < starts.size(); ++i) starts[i] = i;
    std::stable_sort(starts.begin(), starts.end(),
                     [&](std::uint32_t l, std::uint32_t r) { return atomBonds[l].size() < atomBonds[r].size(); });
    std::vector<std::uint8_t> seen(system.atoms.size()), taken(system.bonds.size());
    for (const std::uint32_t start : starts) {
        if (seen[start]) continue;
        queue.assign(1, start);
        seen[start] = 1;
        for (std::size_t at = 0; at < queue.size(); ++at) {
            for (const std::uint32_t b : atomBonds[queue[at]]) {
                if (taken[b]) continue;
                taken[b] = 1;
                order.push_back(b);
                const std::uint32_t other = system.bonds[b].a == queue[at] ? system.bonds[b].b : system.bonds[b].a;
                if (!seen[other]) queue.push_back(other);
                seen[other] = 1;
            }
        }
    }
    return order;
}

constexpr std::size_t kFrontierAtoms = 32;  // two bits each

struct PiState {
    float score = 0;
    std::uint32_t before = 0;  // index into the previous layer
    std::uint8_t placed = 0;   // pi bonds in this layer's bond
};

class PiSearch {
public:
    explicit PiSearch(const PiSystem& system) : system_(system), slot_(system.atoms.size(), kClosed) {
        lastUse_.resize(system.atoms.size());
        most_ = std::clamp<std::size_t>(kMostPiStatesInAll / (system.bonds.size() + 1), 8, kMostPiStates);
    }

    std::vector<std::uint8_t> run() {
        const std::vector<std::uint32_t> order = frontierOrder(system_);
        for (std::uint32_t i = 0; i < order.size(); ++i)
            lastUse_[system_.bonds[order[i]].a] = lastUse_[system_.bonds[order[i]].b] = i;
        keys_.assign(1, 0);
        layers_.assign(1, {PiState{}});
        for (std::uint32_t i = 0; i < order.size(); ++i) step(system_.bonds[order[i]], i);
        std::vector<std::uint8_t> placed(system_.bonds.size());
        std::uint32_t at = bestOfLast();
        for (std::size_t i = order.size(); i > 0; --i) {
            placed[order[i - 1]] = layers_[i][at].placed;
            at = layers_[i][at].before;
        }
        return placed;
    }

private:
    static constexpr std::uint8_t kClosed = 255;

    bool open(std::uint32_t atom) {
        if (slot_[atom] != kClosed) return true;
        for (std::uint8_t s = 0; s < kFrontierAtoms; ++s) {
            if (used_ >> s & 1u) continue;
            used_ |= 1u << s;
            slot_[atom] = s;
            return true;
        }
        return false;
    }

    static unsigned slotCount(std::uint64_t key, std::uint8_t slot) { return key >> (2 * slot) & 3u; }

    void step(const PiSystem::Bond& bond, std::uint32_t index) {
        const bool possible = open(bond.a) && open(bond.b);
        const bool closesA = lastUse_[bond.a] == index, closesB = lastUse_[bond.b] == index;
        std::unordered_map<std::uint64_t, std::uint32_t> found;
        std::vector<std::uint64_t> keys;
        std::vector<PiState> layer;
        for (std::uint32_t s = 0; s < keys_.size(); ++s) {
            for (std::uint8_t pi = 0; pi <= (possible ? 2 : 0); ++pi) {
                std::uint64_t key = keys_[s];
                float score = layers_.back()[s].score + bond.gain[pi];
                if (possible && !add(key, score, bond, pi, closesA, closesB)) continue;
                const auto [it, added] = found.emplace(key, static_cast<std::uint32_t>(keys.size()));
                if (added) {
                    keys.push_back(key);
                    layer.push_back({score, s, pi});
                } else if (layer[it->second].score < score) {
                    layer[it->second] = {score, s, pi};
                }
            }
        }
        for (const auto& [atom, closes] : {std::pair(bond.a, closesA), std::pair(bond.b, closesB)}) {
            if (!closes || slot_[atom] == kClosed) continue;
            used_ &= ~(1u << slot_[atom]);
            slot_[atom] = kClosed;
        }
        keepBest(keys, layer);
        keys_ = std::move(keys);
        layers_.push_back(std::move(layer));
    }

    bool add(std::uint64_t& key, float& score, const PiSystem::Bond& bond, std::uint8_t pi, bool closesA,
             bool closesB) {
        for (const auto& [atom, closes] : {std::pair(bond.a, closesA), std::pair(bond.b, closesB)}) {
            const std::uint8_t slot = slot_[atom];
            const unsigned count = slotCount(key, slot) + pi;
            if (count > system_.atoms[atom].most) return false;
            key &= ~(std::uint64_t{3} << (2 * slot));
            if (closes)
                score -= system_.atoms[atom].cost[count];
            else
                key |= std::uint64_t{count} << (2 * slot);
        }
        return true;
    }

    void keepBest(std::vector<std::uint64_t>& keys, std::vector<PiState>& layer) const {
        if (keys.size() <= most_) return;
        std::vector<std::uint32_t> rank(keys.size());
        for (std::uint32_t i = 0; i < rank.size(); ++i) rank[i] = i;
        std::nth_element(rank.begin(), rank.begin() + static_cast<std::ptrdiff_t>(most_), rank.end(),
                         [&](std::uint32_t l, std::uint32_t r) { return layer[l].score > layer[r].score; });
        rank.resize(most_);
        std::sort(rank.begin(), rank.end());
        std::vector<std::uint64_t> fewerKeys;
        std::vector<PiState> fewer;
        for (const std::uint32_t i : rank) {
            fewerKeys.push_back(keys[i]);
            fewer.push_back(layer[i]);
        }
        keys = std::move(fewerKeys);
        layer = std::move(fewer);
    }

    std::uint32_t bestOfLast() const {
        const std::vector<PiState>& last = layers_.back();
        const auto best = std::max_element(last.begin(), last.end(),
                                           [](const PiState& l, const PiState& r) { return l.score < r.score; });
        return static_cast<std::uint32_t>(best - last.begin());
    }

    const PiSystem& system_;
    std::size_t most_;  // states
    std::vector<std::uint8_t> slot_;
    std::vector<std::uint32_t> lastUse_;
    std::uint32_t used_ = 0;
    std::vector<std::uint64_t> keys_;
    std::vector<std::vector<PiState>> layers_;
};

}  // namespace

std::vector<std::uint8_t> bestPiBonds(const PiSystem& system) {
    if (system.bonds.empty()) return {};
    return PiSearch(system).run();
}

}  // namespace nacre
