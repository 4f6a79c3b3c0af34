#include "engine/molecule/formats/pdb_conect.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/pdb_fields.h"

namespace nacre::pdb {
namespace {

/// One kind of ignored record: how many, and where the first is.
struct Ignored {
    std::size_t count = 0;
    std::uint64_t firstLine = 0;

    void note(std::uint64_t line) {
        if (count++ == 0) firstLine = line;
    }
    void report(Molecule& molecule, const char* why) const {
        addNote(molecule.notes, ReadAction::leftOut, "bonds", why, static_cast<std::int64_t>(count), firstLine);
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
            if (pairs_.size() >= mostPairs_) {
                if (tooMany_++ == 0) firstTooMany_ = lineNumber;
                continue;
            }
            pairs_.push_back({static_cast<std::int32_t>(*from), static_cast<std::int32_t>(*to),
                              static_cast<std::uint32_t>(lineNumber), 1});
        } else {
            known->order = static_cast<std::uint8_t>(std::min(known->order + 1, 3));
        }
    }
}

void ConectTable::resolve(const std::vector<std::int64_t>& serials, Molecule& molecule) const {
    molecule.file.conectUniquePairs = 0;
    if (empty()) return;
    const IdIndex index(serials);
    Ignored dangling;
    Ignored ambiguous;
    std::vector<Bond> bonds;
    for (const Pair& pair : pairs_) {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        const IdIndex::Found foundA = index.find(pair.from, a);
        const IdIndex::Found foundB = index.find(pair.to, b);
        if (foundA == IdIndex::Found::none || foundB == IdIndex::Found::none) {
            dangling.note(pair.line);
        } else if (foundA == IdIndex::Found::several || foundB == IdIndex::Found::several) {
            ambiguous.note(pair.line);
        } else if (a != b) {
            bonds.push_back({std::min(a, b), std::max(a, b), pair.order, BondSource::file});
        }
    }
    mergeBonds(bonds, serials.size());
    if (bonds.size() > kMostBondsPerAtom * serials.size()) {
        molecule.warnings.push_back("ignored all " + std::to_string(bonds.size()) +
                                    " bonds of CONECT records: more than its atoms could form");
        return;
    }
    molecule.file.conectUniquePairs = static_cast<std::int64_t>(bonds.size());
    molecule.bonds.insert(molecule.bonds.end(), bonds.begin(), bonds.end());
    dangling.report(molecule, "CONECT of atoms that are not there");
    ambiguous.report(molecule, "CONECT of serial numbers that several atoms have");
    Ignored{tooMany_, firstTooMany_}.report(molecule, "CONECT beyond what its atoms could form");
    Ignored{unreadable_, firstUnreadable_}.report(molecule, "CONECT without serial numbers");
}

}  // namespace nacre::pdb
