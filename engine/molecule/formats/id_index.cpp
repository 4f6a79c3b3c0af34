#include "engine/molecule/formats/id_index.h"

#include <algorithm>

namespace nacre {

namespace {

constexpr std::uint32_t kNone = ~0u, kSeveral = kNone - 1;

}  // namespace

IdIndex::IdIndex(const std::vector<std::int64_t>& ids) {
    const auto last = std::max_element(ids.begin(), ids.end());
    const std::int64_t longest = static_cast<std::int64_t>(ids.size()) * 4 + 100'000;
    if (last != ids.end() && *last < longest)
        fillTable(ids, static_cast<std::size_t>(std::max<std::int64_t>(*last, 0)) + 1);
    else
        sortEntries(ids);
}

IdIndex::Found IdIndex::find(std::int64_t id, std::uint32_t& atom) const {
    if (table_.empty()) return findSorted(id, atom);
    if (id < 0 || id >= static_cast<std::int64_t>(table_.size())) return Found::none;
    atom = table_[static_cast<std::size_t>(id)];
    return atom == kNone ? Found::none : atom == kSeveral ? Found::several : Found::one;
}

void IdIndex::fillTable(const std::vector<std::int64_t>& ids, std::size_t size) {
    table_.assign(size, kNone);
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
        if (ids[i] < 0) continue;
        std::uint32_t& slot = table_[static_cast<std::size_t>(ids[i])];
        repeats_ = repeats_ || slot != kNone;
        slot = slot == kNone ? i : kSeveral;
    }
}

void IdIndex::sortEntries(const std::vector<std::int64_t>& ids) {
    entries_.reserve(ids.size());
    for (std::uint32_t i = 0; i < ids.size(); ++i)
        if (ids[i] >= 0) entries_.emplace_back(ids[i], i);
    if (!std::is_sorted(entries_.begin(), entries_.end())) std::sort(entries_.begin(), entries_.end());
    const auto same = [](const Entry& l, const Entry& r) { return l.first == r.first; };
    repeats_ = std::adjacent_find(entries_.begin(), entries_.end(), same) != entries_.end();
}

IdIndex::Found IdIndex::findSorted(std::int64_t id, std::uint32_t& atom) const {
    const auto [begin, end] = std::equal_range(entries_.begin(), entries_.end(), Entry(id, 0),
                                               [](const Entry& l, const Entry& r) { return l.first < r.first; });
    if (begin == end) return Found::none;
    atom = begin->second;
    return end - begin == 1 ? Found::one : Found::several;
}

}  // namespace nacre
