#pragma once
// Decides which bonds are drawn as double, triple, aromatic or delocalised, and on which side their additional strands
// lie. Used by representation.cpp.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/molecule/chemistry/chemistry.h"
#include "engine/scene/build/appearance.h"

namespace nacre {

/// Bond::order of bonds of order one and a half that are not aromatic (4): carboxylate and the like.
constexpr std::uint8_t kDelocalised = 5;

/// Drawn orders of a molecule's bonds. Everything independent of positions is computed once.
class DrawnOrders {
public:
    /// Perceives nothing unless something is drawn as sticks. Perceives orders, rings and delocalised groups
    /// (chemistry.h) of ligands and small molecules, and of polymers with BondOrders::on. Other polymer orders come
    /// from the file or the residues' templates, in ball-and-stick only.
    DrawnOrders(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options);

    /// @param bond   index into Molecule::bonds @param style  of its sticks
    std::uint8_t drawnOrder(std::size_t bond, Style style) const;

    /// Atoms of the ring with a bond's inner line: the smallest aromatic one, else the smallest. Empty outside rings.
    /// @param a, b  the bond's atoms
    std::span<const std::uint32_t> findRing(std::uint32_t a, std::uint32_t b) const;
    struct DrawnRing {
        std::vector<std::uint32_t> atoms;  ///< in ring order
        bool aromatic = false;             ///< Ring::drawnAromatic
    };
    const std::vector<DrawnRing>& rings() const { return rings_; }
    AromaticForm form() const { return form_; }

private:
    void perceive(const ResidueFacts& facts, const std::vector<bool>& wanted);
    /// Takes orders and rings of one conformer.
    void take(const Molecule& molecule, const Chemistry& chemistry, const std::vector<bool>& wanted);

    BondOrders mode_;
    AromaticForm form_;
    std::vector<std::uint8_t> orders_;  ///< by bond
    std::vector<bool> perceived_;       ///< by bond
    std::vector<DrawnRing> rings_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> ringOfBond_;  ///< index into rings_
};

}  // namespace nacre
