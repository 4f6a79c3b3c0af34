#pragma once
// Which bonds are drawn as double, triple, aromatic or delocalised, and on which side their further strands lie. Used
// by representation.cpp.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "engine/molecule/residue_facts.h"
#include "engine/scene/appearance.h"

namespace nacre {

/// Bond::order of bonds that are drawn as one and a half, beside 4, which is aromatic: carboxylate and the like.
constexpr std::uint8_t kDelocalised = 5;

/// Orders of a molecule's bonds as they are drawn. What does not move is found once.
class DrawnOrders {
public:
    /// Nothing is perceived unless something is drawn as sticks. Of ligands and small molecules orders, rings and
    /// delocalised groups are perceived (chemistry.h), of polymers too with BondOrders::on; else those of polymers are
    /// as the file or the residues' templates have them, in ball-and-stick alone.
    DrawnOrders(const ResidueFacts& facts, const Appearance& appearance, const RepresentationOptions& options);

    /// @param bond   index into Molecule::bonds @param style  of its sticks
    std::uint8_t orderOf(std::size_t bond, Style style) const;

    /// Atoms of the ring that a bond's inner line lies in: the smallest aromatic one, else the smallest. Empty if it is
    /// in none. @param a, b  its atoms
    std::span<const std::uint32_t> ringOf(std::uint32_t a, std::uint32_t b) const;
    struct DrawnRing {
        std::vector<std::uint32_t> atoms;  ///< in its order
        bool aromatic = false;
    };
    const std::vector<DrawnRing>& rings() const { return rings_; }
    AromaticForm form() const { return form_; }

private:
    void perceive(const ResidueFacts& facts, const std::vector<bool>& wanted);

    BondOrders mode_;
    AromaticForm form_;
    std::vector<std::uint8_t> orders_;  ///< by bond
    std::vector<bool> perceived_;       ///< by bond
    std::vector<DrawnRing> rings_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> ringOfBond_;  ///< index into rings_
};

}  // namespace nacre
