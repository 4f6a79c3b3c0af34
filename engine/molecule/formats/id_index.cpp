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
        table_.assign(static_cast<std::size_t>(std::max<std::int64_t>(*last, 0)) + 1, kNone);
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
        if (ids[i] < 0) continue;
        std::uint32_t& slot =
            table_.empty() ? tree_.emplace(ids[i], kNone).first->second : table_[static_cast<std::size_t>(ids[i])];
        repeats_ = repeats_ || slot != kNone;
        slot = slot == kNone ? i : kSeveral;
    }
}

IdIndex::Found IdIndex::find(std::int64_t id, std::uint32_t& atom) const {
    if (table_.empty()) {
        const auto found = tree_.find(id);
        atom = found == tree_.end() ? kNone : found->second;
    } else {
        const bool there = id >= 0 && id < static_cast<std::int64_t>(table_.size());
        atom = there ? table_[static_cast<std::size_t>(id)] : kNone;
    }
    return atom == kNone ? Found::none : atom == kSeveral ? Found::several : Found::one;
}

}  // namespace nacre
