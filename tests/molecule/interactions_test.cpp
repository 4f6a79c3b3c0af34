#include "engine/molecule/chemistry/interactions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <set>
#include <string>
#include <tuple>

#include "engine/molecule/bonds/bonds.h"
#include "engine/molecule/chemistry/place_grid.h"
#include "engine/molecule/read.h"
#include "engine/molecule/selection/selection.h"
#include "tests/molecule/build_molecule.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using test::MoleculeText;

std::vector<Interaction> interactions(Molecule molecule, InteractionRules rules, const std::string& a = "all",
                                      const std::string& b = "") {
    InteractionQuery query;
    query.a = selectAtoms(molecule, parseSelection(a));
    if (!b.empty()) query.b = selectAtoms(molecule, parseSelection(b));
    return InteractionFinder(molecule, rules).find(molecule, query);
}

/// "hydrogen-bond 0-3 a": kind, first atoms, donor.
std::string words(const std::vector<Interaction>& found) {
    std::string text;
    for (const Interaction& interaction : found) {
        text += text.empty() ? "" : ", ";
        text += std::string(interactionKindName(interaction.kind)) + " " + std::to_string(interaction.a.atoms[0]) +
                "-" + std::to_string(interaction.b.atoms[0]);
        if (interaction.donor != DonorSide::none) text += interaction.donor == DonorSide::a ? " a" : " b";
    }
    return text;
}

Molecule bonded(MoleculeText& text) {
    perceiveBonds(text.molecule);
    return text.molecule;
}

TEST(PlaceGrid, FindsWhatEveryPairDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coordinate(-15, 15);
    std::vector<glm::vec3> places(500);
    for (glm::vec3& place : places) place = {coordinate(random), coordinate(random), coordinate(random)};
    places[0] = {1e8f, -1e8f, 3};  // far away, where cells end
    const PlaceGrid grid(places, 3.5);
    for (const glm::vec3& from : places) {
        std::set<std::uint32_t> near, expected;
        grid.near(from, [&](std::uint32_t i, double) { near.insert(i); });
        for (std::uint32_t i = 0; i < places.size(); ++i)
            if (glm::distance(glm::dvec3(places[i]), glm::dvec3(from)) <= 3.5) expected.insert(i);
        EXPECT_EQ(near, expected);
    }
}

/// An alcohol's hydroxyl with its hydrogen along x, and a ketone's oxygen where the test puts it.
Molecule hydroxylAndKetone(glm::vec3 oxygen) {
    MoleculeText text;
    text.residue("MOH").atom("C", "C", {-0.46f, -1.34f, 0}).atom("O", "O", {0, 0, 0}).atom("HO", "H", {0.96f, 0, 0});
    const glm::vec3 away = glm::normalize(oxygen);
    text.residue("KET", 2).atom("O", "O", oxygen).atom("C", "C", oxygen + 1.22f * away);
    text.atom("C1", "C", oxygen + 1.97f * away + glm::vec3(0, 0, 1.3f));
    text.atom("C2", "C", oxygen + 1.97f * away - glm::vec3(0, 0, 1.3f));
    return bonded(text);
}

TEST(HydrogenBonds, OfBakerAndHubbardByDistanceAndAngleAtTheHydrogen) {
    const auto at = [](double distance, double degrees) {
        const double turn = glm::radians(180 - degrees);
        const Molecule molecule = hydroxylAndKetone({0.96 + distance * std::cos(turn), distance * std::sin(turn), 0});
        return words(interactions(molecule, InteractionRules::bakerHubbard));
    };
    EXPECT_EQ(at(2.49, 180), "hydrogen-bond 1-3 a");
    EXPECT_EQ(at(2.51, 180), "");
    EXPECT_EQ(at(2.4, 121), "hydrogen-bond 1-3 a");
    EXPECT_EQ(at(2.4, 119), "");
}

TEST(HydrogenBonds, OfWernetAndNilssonByACone) {
    const auto at = [](double distance, double delta) {
        const double turn = glm::radians(delta);
        const Molecule molecule = hydroxylAndKetone({distance * std::cos(turn), distance * std::sin(turn), 0});
        return words(interactions(molecule, InteractionRules::wernetNilsson));
    };
    EXPECT_EQ(at(3.29, 0), "hydrogen-bond 1-3 a");
    EXPECT_EQ(at(3.31, 0), "");
    const double most = 3.3 - 0.00044 * 30 * 30;
    EXPECT_EQ(at(most - 0.01, 30), "hydrogen-bond 1-3 a");
    EXPECT_EQ(at(most + 0.01, 30), "");
}

TEST(HydrogenBonds, OfMolstarNeedNoHydrogens) {
    const auto at = [](float distance, const std::string& a, const std::string& b) {
        MoleculeText text;
        const glm::vec3 way = glm::normalize(glm::vec3(0.33f, 0.94f, 0));
        text.residue("MOH").atom("C", "C", {-1.43f, 0, 0}).atom("O", "O", {0, 0, 0});
        const glm::vec3 o = distance * way;
        text.residue("KET", 2).atom("O", "O", o).atom("C", "C", o + glm::vec3(0.9f, 0.8f, 0));
        text.atom("C1", "C", o + glm::vec3(2.3f, 0.3f, 0)).atom("C2", "C", o + glm::vec3(0.6f, 2.25f, 0));
        return words(interactions(bonded(text), InteractionRules::molstar, a, b));
    };
    EXPECT_EQ(at(3.49f, "all", ""), "hydrogen-bond 1-2 a");
    EXPECT_EQ(at(3.51f, "all", ""), "");
    EXPECT_EQ(at(3.0f, "resn KET", ""), "hydrogen-bond 2-1 b");  // the partner gives
    EXPECT_EQ(at(3.0f, "resn MOH", "resn KET"), "hydrogen-bond 1-2 a");
    EXPECT_EQ(at(3.0f, "resn MOH", "resn MOH"), "");
}

TEST(Interactions, HaveTheLimitsThatTheRulesState) {
    const auto pair = [](std::string_view first, std::string_view second, float distance, InteractionRules rules) {
        MoleculeText text;
        text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("CB", first, {1.53f, 0, 0});
        text.residue("LIG", 2).atom("X", second, {1.53f + distance, 0, 0}).atom("C", "C", {3.06f + distance, 0, 0});
        return words(interactions(bonded(text), rules));
    };
    for (const InteractionRules rules : {InteractionRules::molstar, InteractionRules::plip}) {
        EXPECT_EQ(pair("C", "C", 3.99f, rules), "hydrophobic 1-2");
        EXPECT_EQ(pair("C", "C", 4.01f, rules), "");
    }
    const auto metal = [](float distance) {
        MoleculeText text;
        text.residue("GLU").atom("CD", "C", {-1.25f, 0, 0}).atom("OE1", "O", {0, 0, 0});
        text.residue("ZN", 2).atom("ZN", "Zn", {distance, 0, 0});
        return words(interactions(bonded(text), InteractionRules::molstar, "resn ZN"));
    };
    EXPECT_EQ(metal(2.99f), "metal 2-1");
    EXPECT_EQ(metal(3.01f), "");
}

TEST(Interactions, OfRingsByDistanceAngleAndOffset) {
    const auto rings = [](glm::vec3 shift, float tilt) {
        MoleculeText text;
        for (int r = 0; r < 2; ++r) {
            text.residue("BNZ", r + 1);
            for (int i = 0; i < 6; ++i) {
                const float angle = 1.0471976f * static_cast<float>(i);
                glm::vec3 p(1.39f * std::cos(angle), 1.39f * std::sin(angle), 0);
                const float turn = glm::radians(r ? tilt : 0);
                p = {p.x, p.y * std::cos(turn), p.y * std::sin(turn)};
                text.atom("C" + std::to_string(i + 1), "C", p + (r ? shift : glm::vec3(0)));
            }
        }
        InteractionQuery query;
        query.a.assign(12, true);
        query.kinds = {false, false, true, false, false, false, false, false};
        const Molecule molecule = bonded(text);
        return InteractionFinder(molecule, InteractionRules::molstar).find(molecule, query);
    };
    ASSERT_EQ(rings({0, 0, 3.5f}, 0).size(), 1u);
    const Interaction stacked = rings({1.5f, 0, 3.5f}, 10)[0];
    EXPECT_EQ(stacked.kind, InteractionKind::piStacking);
    EXPECT_NEAR(stacked.angles[0].degrees, 10, 0.01);
    EXPECT_NEAR(stacked.distance, std::sqrt(1.5 * 1.5 + 3.5 * 3.5), 1e-3);
    EXPECT_LE(stacked.offset, 1.5 + 1e-3);
    EXPECT_TRUE(rings({2.3f, 0, 3.9f}, 0).empty());  // offset
    EXPECT_TRUE(rings({0, 0, 4.5f}, 45).empty());    // neither parallel nor across
    EXPECT_EQ(rings({0, 0, 5.2f}, 90).size(), 1u);
    EXPECT_TRUE(rings({0, 0, 5.6f}, 90).empty());
}

TEST(Interactions, OfOnePairAreOne) {
    NACRE_NEEDS_DATA();
    for (const char* file : {"2src.pdb", "1hpv.pdb", "interactions/1vsn.pdb.gz"})
        for (const InteractionRules rules : {InteractionRules::molstar, InteractionRules::plip}) {
            using Ends = std::set<std::vector<std::uint32_t>>;
            std::set<std::tuple<InteractionKind, Ends, std::vector<std::uint32_t>>> seen;
            for (const Interaction& found : interactions(readMoleculeFile(test::dataFile(file)), rules)) {
                std::vector<std::uint32_t> a = found.a.atoms, b = found.b.atoms;
                if (found.kind == InteractionKind::hydrogenBond || found.kind == InteractionKind::waterBridge) {
                    a.resize(1);  // without the hydrogen
                    b.resize(1);
                }
                std::sort(a.begin(), a.end());
                std::sort(b.begin(), b.end());
                EXPECT_TRUE(seen.emplace(found.kind, Ends{a, b}, found.waters).second)
                    << file << ": " << words({found});
            }
        }
}

TEST(Interactions, NeverJoinModelsThatLieOverEachOther) {
    MoleculeText text;
    text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("CB", "C", {1.53f, 0, 0});
    text.residue("LIG", 2).atom("C1", "C", {5.3f, 0, 0}).atom("C2", "C", {6.83f, 0, 0});
    Molecule molecule = bonded(text);
    EXPECT_EQ(interactions(molecule, InteractionRules::molstar).size(), 1u);
    molecule.chains.push_back({"A", 2});
    molecule.residues[1].chain = 1;
    EXPECT_TRUE(interactions(molecule, InteractionRules::molstar).empty());
    molecule.modelsAreInputs = true;  // a pose and its receptor
    EXPECT_EQ(interactions(molecule, InteractionRules::molstar).size(), 1u);
}

TEST(Interactions, OfACrystalStayWhenItTurnsAndMirrorWhenTheSidesDo) {
    NACRE_NEEDS_DATA();
    Molecule molecule = readMoleculeFile(test::dataFile("interactions/1eve.pdb.gz"));
    const std::string ligand = "resn E20";
    const auto before = words(interactions(molecule, InteractionRules::molstar, ligand));
    EXPECT_NE(before.find("cation-pi"), std::string::npos);
    EXPECT_NE(before.find("pi-stacking"), std::string::npos);
    auto forth = interactions(molecule, InteractionRules::molstar, ligand, "not resn E20");
    auto back = interactions(molecule, InteractionRules::molstar, "not resn E20", ligand);
    EXPECT_EQ(words(forth), before);
    EXPECT_EQ(forth.size(), back.size());
    const glm::mat4 turn = glm::rotate(glm::mat4(1), 1.1f, glm::normalize(glm::vec3(1, 2, -3)));
    for (Atom& atom : molecule.atoms) atom.position = glm::vec3(turn * glm::vec4(atom.position, 1));
    EXPECT_EQ(words(interactions(molecule, InteractionRules::molstar, ligand)), before);
}

TEST(Interactions, FollowAFrameOfATrajectory) {
    MoleculeText text;
    text.residue("ALA").atom("CA", "C", {0, 0, 0}).atom("CB", "C", {1.53f, 0, 0});
    text.residue("LIG", 2).atom("C1", "C", {5.3f, 0, 0}).atom("C2", "C", {6.83f, 0, 0});
    Molecule molecule = bonded(text);
    const InteractionFinder finder(molecule, InteractionRules::molstar);
    InteractionQuery query;
    query.a.assign(4, true);
    EXPECT_EQ(finder.find(molecule, query).size(), 1u);
    for (std::size_t i = 2; i < 4; ++i) molecule.atoms[i].position.x += 1;
    EXPECT_TRUE(finder.find(molecule, query).empty());
}

TEST(Interactions, NamesAreThoseOfTheCommandLine) {
    for (std::size_t i = 0; i < kInteractionKinds; ++i) {
        const auto kind = static_cast<InteractionKind>(i);
        EXPECT_EQ(interactionKindFromName(interactionKindName(kind)), kind);
    }
    EXPECT_EQ(interactionRulesFromName("plip"), InteractionRules::plip);
    EXPECT_FALSE(interactionRulesFromName("PLIP"));
}

TEST(Interactions, OfLargeMoleculesTakeLittleProcessorTime) {
    NACRE_NEEDS_DATA();
    for (const auto& [file, most] : {std::pair("4hhb.pdb", 0.1), std::pair("1aon-groel.pdb.gz", 1.0)}) {
        const Molecule molecule = readMoleculeFile(test::dataFile(file));
        const std::clock_t start = std::clock();  // of the processor: other programs may be busy
        const std::size_t found = interactions(molecule, InteractionRules::molstar).size();
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        RecordProperty(std::string("seconds_") + file, std::to_string(seconds));
        EXPECT_GT(found, molecule.atoms.size() / 10);
        EXPECT_LT(seconds, 5 * most) << file;  // measured: a fifth of it
    }
}

}  // namespace
}  // namespace nacre
