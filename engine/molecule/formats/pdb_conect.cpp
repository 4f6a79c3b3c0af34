#include "engine/molecule/formats/pdb_conect.h"

#include <array>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/bonds/possible_bonds.h"
#include "engine/molecule/formats/id_index.h"
#include "engine/molecule/formats/molecule_builder.h"
#include "engine/molecule/formats/pdb_fields.h"
#include "engine/molecule/text.h"

namespace nacre::pdb {
namespace {

/// One kind of ignored record: number, and line of the first.
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

/// The numbers of a record, if some have six digits or more: then blanks separate them, and columns do not hold.
/// Numbers that fill their columns also touch, but end at column ends.
std::vector<std::string_view> longNumbers(std::string_view line) {
    constexpr std::size_t kBegin = 6, kWidth = 5, kTouching = 10;
    const std::vector<std::string_view> words = splitAllWords(line.substr(kBegin));
    const auto isLong = [&](std::string_view word) {
        const auto end = static_cast<std::size_t>(word.data() + word.size() - line.data());
        return word.size() > kWidth && word.size() < kTouching && (end - kBegin) % kWidth != 0;
    };
    const auto isNumber = [](std::string_view word) {
        return word.size() < kTouching && word.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const bool plain = std::all_of(words.begin(), words.end(), isNumber);
    return plain && std::any_of(words.begin(), words.end(), isLong) ? words : std::vector<std::string_view>();
}

constexpr float kManyTimesUsual = 3;

/// The median.
float usualLength(const Molecule& molecule, const std::vector<Bond>& bonds) {
    if (bonds.empty()) return 0;
    std::vector<float> lengths;
    for (const Bond& bond : bonds)
        lengths.push_back(glm::distance(molecule.atoms[bond.a].position, molecule.atoms[bond.b].position));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

}  // namespace

void ConectTable::add(std::string_view line, std::uint64_t lineNumber) {
    // In old files, columns 32 and on held hydrogen bonds and salt bridges, which are no bonds.
    constexpr std::array<std::size_t, 4> kPartners = {12, 17, 22, 27};
    const std::vector<std::string_view> words = longNumbers(line);
    const auto from = words.empty() ? integer(columns(line, 7, 11), 5) : integer(words[0], 5);
    if (!from || *from < 0) {
        if (unreadable_++ == 0) firstUnreadable_ = lineNumber;
        return;
    }
    const std::size_t before = pairs_.size();
    for (std::size_t i = 0; i < kPartners.size(); ++i) {
        const std::string_view field = words.empty()          ? trim(columns(line, kPartners[i], kPartners[i] + 4))
                                       : i + 1 < words.size() ? words[i + 1]
                                                              : std::string_view();
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
    Ignored dangling, ambiguous, impossible, own;
    std::vector<Bond> bonds;
    std::vector<std::uint32_t> lines;
    for (const Pair& pair : pairs_) {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        const IdIndex::Found foundA = index.find(pair.from, a);
        const IdIndex::Found foundB = index.find(pair.to, b);
        if (foundA == IdIndex::Found::none || foundB == IdIndex::Found::none) {
            dangling.note(pair.line);
        } else if (foundA == IdIndex::Found::several || foundB == IdIndex::Found::several) {
            ambiguous.note(pair.line);
        } else if (a == b) {
            own.note(pair.line);
        } else {
            bonds.push_back({std::min(a, b), std::max(a, b), pair.order, BondSource::file});
            lines.push_back(pair.line);
        }
    }
    const float farthest = kManyTimesUsual * usualLength(molecule, bonds);
    std::set<std::pair<std::uint32_t, std::uint32_t>> refused;  // each is listed with both of its atoms
    std::size_t kept = 0;
    for (std::size_t i = 0; i < bonds.size(); ++i) {
        if (mayBeBonded(molecule, bonds[i].a, bonds[i].b, farthest))
            bonds[kept++] = bonds[i];
        else if (refused.emplace(bonds[i].a, bonds[i].b).second)
            impossible.note(lines[i]);
    }
    bonds.resize(kept);
    mergeBonds(bonds, serials.size());
    if (bonds.size() > MoleculeBuilder::kMostBondsPerAtom * serials.size()) {
        molecule.warnings.push_back("ignored all " + std::to_string(bonds.size()) +
                                    " bonds of CONECT records: more than its atoms could form");
        return;
    }
    molecule.file.conectUniquePairs = static_cast<std::int64_t>(bonds.size() + refused.size());
    molecule.bonds.insert(molecule.bonds.end(), bonds.begin(), bonds.end());
    dangling.report(molecule, "CONECT of atoms that are not there");
    own.report(molecule, "CONECT of an atom to itself");
    impossible.report(molecule, "CONECT of atoms at a distance that no bond has");
    ambiguous.report(molecule, "CONECT of serial numbers that several atoms have");
    Ignored{tooMany_, firstTooMany_}.report(molecule, "CONECT beyond what its atoms could form");
    Ignored{unreadable_, firstUnreadable_}.report(molecule, "CONECT without serial numbers");
}

}  // namespace nacre::pdb
