// Rules that limit contacts beyond their distances: partners, angles, and what stands in the way.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/chemistry/interactions.h"
#include "tests/molecule/build_molecule.h"

namespace nacre {
namespace {

using test::MoleculeText;

/// Number of contacts of a kind between the residues numbered 1 and 2.
std::size_t contacts(MoleculeText text, InteractionKind kind, InteractionRules rules) {
    perceiveBonds(text.molecule);
    InteractionQuery query;
    for (const Atom& atom : text.molecule.atoms) query.a.push_back(text.molecule.residues[atom.residue].number == 1);
    query.kinds = {};
    query.kinds[static_cast<std::size_t>(kind)] = true;
    std::size_t count = 0;
    for (const Interaction& found : InteractionFinder(text.molecule, rules).find(text.molecule, query))
        count += text.molecule.residues[text.molecule.atoms[found.b.atoms[0]].residue].number == 2;
    return count;
}

MoleculeText twoCarbons(std::string_view residue, float apart) {
    MoleculeText text;
    text.residue("LIG", 1).atom("C1", "C", {-1.53f, 0, 0}).atom("C2", "C", {0, 0, 0});
    text.residue(residue, 2).atom("CB", "C", {apart, 0, 0}).atom("CA", "C", {apart + 1.53f, 0, 0});
    return text;
}

TEST(LineOfSight, AnAtomNearTheMiddleIsInTheWay) {
    const auto at = [](float aside, InteractionRules rules, std::string_view symbol = "O") {
        MoleculeText text = twoCarbons("ALA", 3.9f);
        text.residue("XXX", 3).atom("X", symbol, {1.95f, aside, 0});
        return contacts(text, InteractionKind::hydrophobic, rules);
    };
    EXPECT_EQ(at(1.4f, InteractionRules::molstar), 0u);  // an oxygen's radius is 1.52 Å
    EXPECT_EQ(at(1.6f, InteractionRules::molstar), 1u);
    EXPECT_EQ(at(1.0f, InteractionRules::molstar, "H"), 1u);  // hydrogens are in nobody's way
    EXPECT_EQ(at(1.4f, InteractionRules::plip), 1u);          // PLIP does not look
}

/// Chlorobenzene's bond along x; a ketone's oxygen at a distance, turned off that line, its carbon turned off the way.
std::size_t halogenBonds(double distance, double off, double atAcceptor, InteractionRules rules) {
    MoleculeText text;
    text.residue("LIG", 1).atom("C", "C", {-1.74f, 0, 0}).atom("CL", "Cl", {0, 0, 0});
    const double turn = glm::radians(off);
    const glm::dvec3 oxygen(distance * std::cos(turn), distance * std::sin(turn), 0);
    const double back = glm::radians(180 + off - atAcceptor);
    const glm::dvec3 carbon = oxygen + 1.23 * glm::dvec3(std::cos(back), std::sin(back), 0);
    text.residue("ALA", 2).atom("O", "O", oxygen).atom("C", "C", carbon);
    return contacts(text, InteractionKind::halogenBond, rules);
}

TEST(HalogenBonds, HaveTheDistanceAndAnglesOfTheirRules) {
    for (const InteractionRules rules : {InteractionRules::molstar, InteractionRules::plip}) {
        EXPECT_EQ(halogenBonds(3.9, 0, 120, rules), 1u);
        EXPECT_EQ(halogenBonds(4.1, 0, 120, rules), 0u);
        EXPECT_EQ(halogenBonds(3.5, 0, 88, rules), 0u);
    }
    EXPECT_EQ(halogenBonds(3.5, 29, 120, InteractionRules::molstar), 1u);  // 151 degrees at the halogen
    EXPECT_EQ(halogenBonds(3.5, 31, 120, InteractionRules::molstar), 0u);
    EXPECT_EQ(halogenBonds(3.5, 44, 120, InteractionRules::plip), 1u);
    EXPECT_EQ(halogenBonds(3.5, 46, 120, InteractionRules::plip), 0u);
    EXPECT_EQ(halogenBonds(3.5, 0, 165, InteractionRules::molstar), 1u);  // not limited
    EXPECT_EQ(halogenBonds(3.5, 0, 165, InteractionRules::plip), 0u);
}

std::size_t metalContacts(std::string_view metal, std::string_view residue, std::string_view atom,
                          std::string_view symbol, InteractionRules rules) {
    MoleculeText text;
    text.residue(metal, 1).atom(metal, metal, {0, 0, 0});
    text.residue(residue, 2).atom(atom, symbol, {2.2f, 0, 0}).atom("CX", "C", {3.4f, 0.6f, 0});
    return contacts(text, InteractionKind::metal, rules);
}

TEST(Metals, AreHeldByTheAtomsOfTheirRules) {
    constexpr auto kMolstar = InteractionRules::molstar, kPlip = InteractionRules::plip;
    EXPECT_EQ(metalContacts("ZN", "HIS", "NE2", "N", kMolstar), 1u);
    EXPECT_EQ(metalContacts("CA", "HIS", "NE2", "N", kMolstar), 0u);  // nitrogen holds transition metals alone
    EXPECT_EQ(metalContacts("CA", "ASP", "OD1", "O", kMolstar), 1u);
    EXPECT_EQ(metalContacts("ZN", "LYS", "NZ", "N", kMolstar), 0u);
    EXPECT_EQ(metalContacts("ZN", "HIS", "NE2", "N", kPlip), 1u);
    EXPECT_EQ(metalContacts("NA", "ASP", "OD1", "O", kMolstar), 1u);
    EXPECT_EQ(metalContacts("NA", "ASP", "OD1", "O", kPlip), 0u);  // its program reports no sodium
    EXPECT_EQ(metalContacts("MG", "ASP", "OD1", "O", kPlip), 1u);
    EXPECT_EQ(metalContacts("MG", "G", "OP1", "O", kMolstar), 1u);
    EXPECT_EQ(metalContacts("MG", "G", "OP1", "O", kPlip), 0u);  // neither a receptor nor the metal's own ligand
}

TEST(Plip, LigandsMeetProteinsAndNotNucleicAcids) {
    constexpr auto kHydrophobic = InteractionKind::hydrophobic;
    EXPECT_EQ(contacts(twoCarbons("ALA", 3.8f), kHydrophobic, InteractionRules::plip), 1u);
    EXPECT_EQ(contacts(twoCarbons("DT", 3.8f), kHydrophobic, InteractionRules::plip), 0u);
    EXPECT_EQ(contacts(twoCarbons("DT", 3.8f), kHydrophobic, InteractionRules::molstar), 1u);
    // A modified amino acid is a ligand as well, whatever its record says.
    EXPECT_EQ(contacts(twoCarbons("MSE", 3.8f), kHydrophobic, InteractionRules::plip), 0u);
    EXPECT_EQ(contacts(twoCarbons("MSE", 3.8f), kHydrophobic, InteractionRules::molstar), 1u);
}

TEST(Plip, ABentCarbonylIsAHydroxyl) {
    const auto bonds = [](double degrees) {
        const double bend = glm::radians(degrees);
        MoleculeText text;
        text.residue("LIG", 1).atom("C2", "C", 1.5f * glm::vec3(std::cos(bend), std::sin(bend), 0));
        text.atom("C1", "C", {0, 0, 0}).atom("O1", "O", {1.22f, 0, 0});
        const glm::vec3 way(0.333f, -0.943f, 0), acceptor = glm::vec3(1.22f, 0, 0) + 2.9f * way;  // of a hydrogen
        text.residue("ALA", 2).atom("O", "O", acceptor).atom("C", "C", acceptor + 1.23f * way);
        text.atom("CA", "C", acceptor + 2.76f * way);
        return contacts(text, InteractionKind::hydrogenBond, InteractionRules::plip);
    };
    EXPECT_EQ(bonds(120), 0u);
    EXPECT_EQ(bonds(111), 1u);  // Open Babel takes its carbon for tetrahedral
}

}  // namespace
}  // namespace nacre
