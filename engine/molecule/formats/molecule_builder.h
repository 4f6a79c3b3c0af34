#pragma once
// Puts a Molecule together while a reader walks through its file. Must also compile as C++17.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "engine/molecule/molecule.h"

namespace nacre {

class MoleculeBuilder {
public:
    /// @param name file name for messages
    MoleculeBuilder(std::string name, std::size_t maxAtoms) : name_(std::move(name)), maxAtoms_(maxAtoms) {}

    /// Adds an atom to the residue of the atom before it, or begins another if any of these differ.
    /// @param subchain null: the chain
    /// @throws Error if there are more than maxAtoms, or the name of a chain is too long for one
    void addAtom(Atom atom, std::string_view chain, std::int32_t number, char insertionCode, std::string_view residue,
                 std::string_view subchain = {});

    /// Index of a subchain by name, if atoms are in it.
    std::optional<std::uint32_t> subchain(std::string_view name) const;

    /// Adds a bond that the file states; a pair that is there already is passed over.
    /// @throws Error, with the line, if an index is out of range or both are the same, or there are more bonds than
    /// maxAtoms could form
    /// @param a, b 0-based
    /// @param line  0 if there is none
    void addBond(std::int64_t a, std::int64_t b, int order, std::uint64_t line);

    /// Element of a symbol as files write it: "C", "fe", "T", "Fe3+", "C12", "26". Unknown ones are counted for a
    /// warning.
    /// @param line 0 if there is none
    Element element(std::string_view symbol, std::uint64_t line);

    void warn(const std::string& sentence);

    /// Bonds that a reader may put aside until it knows all atoms.
    std::size_t mostBonds() const { return kMostBondsPerAtom * maxAtoms_; }

    Molecule& molecule() { return molecule_; }
    const std::string& name() const { return name_; }

    /// The molecule, bonds sorted. @throws Error if it has no atoms
    Molecule finish();

private:
    static constexpr std::size_t kMostBondsPerAtom = 8;
    using Indices = std::map<std::string, std::uint32_t, std::less<>>;  // no hash that a file could aim at
    std::uint32_t chainIndex(std::string_view chain);
    std::uint32_t subchainIndex(std::string_view subchain);

    std::string name_;
    std::size_t maxAtoms_;
    Molecule molecule_;
    Indices chains_, subchains_;
    std::size_t unknownElements_ = 0;
    std::string firstUnknown_;
    std::size_t warningsLeftOut_ = 0;
};

}  // namespace nacre
