#include "engine/scene/color/color_table.h"

#include <algorithm>
#include <span>

#include "engine/error.h"

namespace nacre {
namespace {

/// Residues sorted by one of their numbers.
class ByNumber {
public:
    ByNumber(const Molecule& molecule, std::int32_t Residue::*number) {
        for (std::uint32_t i = 0; i < molecule.residues.size(); ++i)
            residues_.emplace_back(molecule.residues[i].*number, i);
        std::sort(residues_.begin(), residues_.end());
    }
    std::span<const std::pair<std::int32_t, std::uint32_t>> within(const ColorTable::Numbers& range) const {
        const auto first = std::lower_bound(residues_.begin(), residues_.end(), std::pair(range.first, 0u));
        const auto last = std::upper_bound(first, residues_.end(), std::pair(range.last, 0xffffffffu));
        return {first, last};
    }
    std::span<const std::pair<std::int32_t, std::uint32_t>> all() const { return residues_; }

private:
    std::vector<std::pair<std::int32_t, std::uint32_t>> residues_;
};

class Matching {
public:
    Matching(const Molecule& molecule, TableMatch& match)
        : molecule_(molecule),
          match_(match),
          byNumber_(molecule, &Residue::number),
          byLabel_(molecule, &Residue::labelNumber) {}

    void add(const ColorTable::Row& row, std::uint32_t number) {
        row_ = &row;
        number_ = number;
        any_ = false;
        if (row.id) {
            if (*row.id >= 1 && *row.id <= molecule_.atoms.size()) {
                const std::uint32_t atom = *row.id - 1;
                if (isResidue(molecule_.residues[molecule_.atoms[atom].residue])) take(atom);
            }
        } else {
            const auto residues = row.numbers        ? byNumber_.within(*row.numbers)
                                  : row.labelNumbers ? byLabel_.within(*row.labelNumbers)
                                                     : byNumber_.all();
            for (const auto& [value, index] : residues) visit(molecule_.residues[index]);
        }
        if (any_) return;
        if (match_.idle++ == 0) match_.firstIdle = row.number;
    }

private:
    void visit(const Residue& residue) {
        constexpr std::uint64_t kMostVisits = 2'000'000'000;
        if (++visits_ > kMostVisits)
            throw Error("cannot colour molecule", "",
                        "the table has too many rows that name neither a residue's number nor an atom's id");
        if (!isResidue(residue)) return;
        for (std::uint32_t atom = residue.firstAtom; atom < residue.firstAtom + residue.atomCount; ++atom) take(atom);
    }

    bool isResidue(const Residue& residue) const {
        const ColorTable::Row& row = *row_;
        const Chain& chain = molecule_.chains[residue.chain];
        const auto within = [](const std::optional<ColorTable::Numbers>& range, std::int32_t number) {
            return !range || (number >= range->first && number <= range->last && number != kNoLabelNumber);
        };
        return (!row.chain || *row.chain == chain.name) && (!row.model || *row.model == chain.model) &&
               (!row.labelChain || *row.labelChain == molecule_.subchains[residue.subchain]) &&
               within(row.numbers, residue.number) && within(row.labelNumbers, residue.labelNumber) &&
               (!row.insertionCode || *row.insertionCode == residue.insertionCode) &&
               (!row.residue || *row.residue == residue.name.view()) && (!row.entity || isEntity(residue));
    }
    bool isEntity(const Residue& residue) const {
        return residue.entity > 0 && molecule_.entities[residue.entity - 1] == *row_->entity;
    }

    void take(std::uint32_t index) {
        const Atom& atom = molecule_.atoms[index];
        if (row_->atom && *row_->atom != atom.name.view()) return;
        if (row_->element && *row_->element != atom.element) return;
        match_.rows[index] = number_;
        any_ = true;
    }

    const Molecule& molecule_;
    TableMatch& match_;
    ByNumber byNumber_, byLabel_;
    const ColorTable::Row* row_ = nullptr;
    std::uint32_t number_ = 0;
    std::uint64_t visits_ = 0;
    bool any_ = false;
};

}  // namespace

TableMatch matchTable(const ResidueFacts& facts, const ColorTable& table) {
    TableMatch match;
    match.rows.assign(facts.molecule().atoms.size(), TableMatch::kNone);
    Matching matching(facts.molecule(), match);
    for (std::uint32_t i = 0; i < table.rows.size(); ++i) matching.add(table.rows[i], i);
    return match;
}

}  // namespace nacre
