#pragma once
// The built-in molecules, one function each, and shared helpers. Callers use sampleMolecule() of read.h.

#include <string_view>

#include "engine/molecule/formats/molecule_builder.h"

namespace nacre {

Molecule sampleDna();
Molecule sampleGlucose();
Molecule sampleBuckyball();

/// Appends atoms to a molecule residue by residue.
class SampleBuilder {
public:
    explicit SampleBuilder(std::string_view title);

    void chain(std::string_view name) { chain_ = name; }
    /// Adds a residue to the latest chain; `hetero` marks its atoms.
    void residue(std::string_view name, std::int32_t number, bool hetero) {
        residue_ = name;
        number_ = number;
        hetero_ = hetero;
    }
    /// Adds an atom to the latest residue and returns its index. The position is in Å.
    std::uint32_t atom(std::string_view name, std::string_view symbol, glm::dvec3 position);
    /// Adds a bond between two different atoms.
    void bond(std::uint32_t a, std::uint32_t b, std::uint8_t order) { builder_.addBond(a, b, order, 0); }

    /// The molecule with summary and sorted bonds.
    Molecule finish();

private:
    MoleculeBuilder builder_;
    std::string chain_, residue_;
    std::int32_t number_ = 0;
    bool hetero_ = false;
};

}  // namespace nacre
