#pragma once
// What residues are, where they stand and how they fold: computed once per molecule and handed on.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/residue_kind.h"

namespace nacre {

/// Each fact is computed when it is first asked for. Copies share them. A function that takes this also takes a
/// molecule, and then computes them for itself. The molecule outlives it and stays as it is, but for moved(). One
/// thread at a time.
class ResidueFacts {
public:
    ResidueFacts(const Molecule& molecule) : molecule_(&molecule), known_(std::make_shared<Known>()) {}

    /// The same facts of the same atoms at other positions.
    ResidueFacts moved(const Molecule& molecule) const {
        ResidueFacts facts = *this;
        facts.molecule_ = &molecule;
        return facts;
    }

    const Molecule& molecule() const { return *molecule_; }
    /// residueKinds()
    const std::vector<ResidueKind>& kinds() const;
    /// The first residue record of the position (chain, number, insertion code) of each: where residues alternate,
    /// several stand in a row.
    const std::vector<std::uint32_t>& positions() const;
    /// secondaryStructure(), one value per residue.
    const std::vector<SecondaryStructure>& folds() const;
    /// Atoms of the conformer that is drawn: drawnAtoms() by default.
    const std::vector<std::uint32_t>& conformer() const;

    bool isPolymer(std::uint32_t residue) const {
        return kinds()[residue] == ResidueKind::protein || kinds()[residue] == ResidueKind::nucleic;
    }

private:
    struct Known {
        std::optional<std::vector<ResidueKind>> kinds;
        std::optional<std::vector<std::uint32_t>> positions, conformer;
        std::optional<std::vector<SecondaryStructure>> folds;
    };
    const Molecule* molecule_;
    std::shared_ptr<Known> known_;
};

}  // namespace nacre
