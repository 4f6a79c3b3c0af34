#pragma once
// Kinds, positions and secondary structure of residues: computed once per molecule and passed on.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/molecule/molecule.h"
#include "engine/molecule/residue_kind.h"

namespace nacre {

/// Each fact is computed on first use. Copies share facts. Functions that take this also take a molecule, and then
/// compute the facts themselves. The molecule outlives it and does not change, except by moved(). One thread at a time.
class ResidueFacts {
public:
    ResidueFacts(const Molecule& molecule) : molecule_(&molecule), known_(std::make_shared<Known>()) {}

    /// The same facts for the same atoms at other positions.
    ResidueFacts moved(const Molecule& molecule) const {
        ResidueFacts facts = *this;
        facts.molecule_ = &molecule;
        return facts;
    }

    const Molecule& molecule() const { return *molecule_; }
    /// residueKinds()
    const std::vector<ResidueKind>& kinds() const;
    /// For each residue the first residue record at its position (chain, number, insertion code): alternative residues
    /// follow each other.
    const std::vector<std::uint32_t>& positions() const;
    /// secondaryStructure(), one value per residue.
    const std::vector<SecondaryStructure>& folds() const;
    /// Atoms of the drawn conformer: drawnAtoms() by default.
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
