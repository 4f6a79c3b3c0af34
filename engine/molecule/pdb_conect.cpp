#include "engine/molecule/pdb_conect.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "engine/molecule/pdb_fields.h"

namespace nacre::pdb {
namespace {

/// Atoms by serial number, as a sorted list.
class SerialIndex {
public:
    enum class Found { none, one, several };

    explicit SerialIndex(const std::vector<std::int64_t>& serials) {
        entries_.reserve(serials.size());
        for (std::uint32_t i = 0; i < serials.size(); ++i)
            if (serials[i] >= 0) entries_.emplace_back(serials[i], i);
        if (!std::is_sorted(entries_.begin(), entries_.end())) std::sort(entries_.begin(), entries_.end());
    }

    Found find(std::int64_t serial, std::uint32_t& atom) const {
        const auto [begin, end] = std::equal_range(entries_.begin(), entries_.end(), Entry(serial, 0),
                                                   [](const Entry& l, const Entry& r) { return l.first < r.first; });
        if (begin == end) return Found::none;
        atom = begin->second;
        return end - begin == 1 ? Found::one : Found::several;
    }

private:
    using Entry = std::pair<std::int64_t, std::uint32_t>;
    std::vector<Entry> entries_;
};

/// One kind of ignored record: how many, and where the first is.
struct Ignored {
    std::size_t count = 0;
    std::uint64_t firstLine = 0;

    void note(std::uint64_t line) {
        if (count++ == 0) firstLine = line;
    }
    void report(Molecule& molecule, const std::string& what) const {
        if (count == 0) return;
        molecule.warnings.push_back("ignored " + std::to_string(count) + " CONECT " + what + ", the first on line " +
                                    std::to_string(firstLine));
    }
};

}  // namespace

void ConectTable::add(std::string_view line, std::uint64_t lineNumber) {
    // Columns 32 and on held hydrogen bonds and salt bridges in old files; they are no bonds.
    constexpr std::array<std::size_t, 4> kPartners = {12, 17, 22, 27};
    const auto from = integer(columns(line, 7, 11), 5);
    if (!from || *from < 0) {
        if (unreadable_++ == 0) firstUnreadable_ = lineNumber;
        return;
    }
    const std::size_t before = pairs_.size();
    for (const std::size_t first : kPartners) {
        const std::string_view field = trim(columns(line, first, first + 4));
        if (field.empty()) continue;
        const auto to = integer(field, 5);
        if (!to) {
            if (unreadable_++ == 0) firstUnreadable_ = lineNumber;
            continue;
        }
        if (*to <= 0) continue;  // padding
        // A partner named twice in one record is the customary way to write a double bond.
        const auto known = std::find_if(pairs_.begin() + static_cast<std::ptrdiff_t>(before), pairs_.end(),
                                        [&](const Pair& pair) { return pair.to == *to; });
        if (known == pairs_.end()) {
            pairs_.push_back({*from, *to, lineNumber, 1});
        } else {
            known->order = static_cast<std::uint8_t>(std::min(known->order + 1, 3));
        }
    }
}

void ConectTable::resolve(const std::vector<std::int64_t>& serials, Molecule& molecule) const {
    molecule.file.conectUniquePairs = 0;
    if (empty()) return;
    const SerialIndex index(serials);
    Ignored dangling;
    Ignored ambiguous;
    std::vector<Bond> bonds;
    for (const Pair& pair : pairs_) {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        const SerialIndex::Found foundA = index.find(pair.from, a);
        const SerialIndex::Found foundB = index.find(pair.to, b);
        if (foundA == SerialIndex::Found::none || foundB == SerialIndex::Found::none) {
            dangling.note(pair.line);
        } else if (foundA == SerialIndex::Found::several || foundB == SerialIndex::Found::several) {
            ambiguous.note(pair.line);
        } else if (a != b) {
            bonds.push_back({std::min(a, b), std::max(a, b), pair.order, BondSource::file});
        }
    }
    const auto key = [](const Bond& bond) { return std::tie(bond.a, bond.b); };
    std::sort(bonds.begin(), bonds.end(), [&](const Bond& l, const Bond& r) {
        return key(l) != key(r) ? key(l) < key(r) : l.order > r.order;  // the higher order of the two directions stays
    });
    bonds.erase(std::unique(bonds.begin(), bonds.end(), [&](const Bond& l, const Bond& r) { return key(l) == key(r); }),
                bonds.end());
    molecule.file.conectUniquePairs = static_cast<std::int64_t>(bonds.size());
    molecule.bonds.insert(molecule.bonds.end(), bonds.begin(), bonds.end());
    dangling.report(molecule, "bonds to atoms that are not there");
    ambiguous.report(molecule, "bonds to serial numbers that several atoms bear");
    Ignored{unreadable_, firstUnreadable_}.report(molecule, "fields that are no serial numbers");
}

}  // namespace nacre::pdb
