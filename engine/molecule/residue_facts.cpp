#include "engine/molecule/residue_facts.h"

#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/kabsch_sander.h"

namespace nacre {
namespace {

template <typename Fact, typename Compute>
const Fact& knownOr(std::optional<Fact>& known, const Compute& compute) {
    if (!known) known = compute();
    return *known;
}

}  // namespace

const std::vector<ResidueKind>& ResidueFacts::kinds() const {
    return knownOr(known_->kinds, [&] { return residueKinds(*molecule_); });
}

const std::vector<std::uint32_t>& ResidueFacts::positions() const {
    return knownOr(known_->positions, [&] {
        const std::vector<Residue>& residues = molecule_->residues;
        std::vector<std::uint32_t> first(residues.size());
        for (std::uint32_t i = 0; i < first.size(); ++i)
            first[i] = i > 0 && residues[i].sharesPosition(residues[i - 1]) ? first[i - 1] : i;
        return first;
    });
}

const std::vector<SecondaryStructure>& ResidueFacts::folds() const {
    return knownOr(known_->folds, [&] { return secondaryStructure(*this); });
}

const std::vector<std::uint32_t>& ResidueFacts::conformer() const {
    return knownOr(known_->conformer, [&] { return drawnAtoms(*molecule_); });
}

}  // namespace nacre
