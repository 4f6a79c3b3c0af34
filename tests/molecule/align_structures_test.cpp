// Structural alignments. The judge is TM-align, version 20240303, by its authors: pairs, RMSD and TM-scores as it
// prints them for chains of real files.

#include "engine/molecule/align_structures.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <random>

#include "engine/molecule/read.h"
#include "engine/molecule/residue_facts.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using Places = std::vector<TraceResidue>;

Places readChain(const std::string& file, const std::string& name) {
    const Molecule molecule = readMoleculeFile(file, {});
    const ResidueFacts facts(molecule);
    Places chain;
    for (std::uint32_t r = 0; r < molecule.residues.size(); ++r) {
        const Residue& residue = molecule.residues[r];
        if (molecule.chains[residue.chain].name != name || !facts.isPolymer(r)) continue;
        for (std::uint32_t i = residue.firstAtom; i < residue.firstAtom + residue.atomCount; ++i) {
            if (molecule.atoms[i].name != Name("CA")) continue;
            chain.push_back({glm::dvec3(molecule.atoms[i].position), facts.folds()[r]});
            break;
        }
    }
    return chain;
}

/// A walk of steps of 3.8 Å, as chains have between their alpha carbons, that turns a little at each.
Places walk(std::size_t length, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Places chain(1);
    glm::dvec3 step(0, 0, 1);
    while (chain.size() < length) {
        step = glm::normalize(step + 0.6 * glm::dvec3(normal(random), normal(random), normal(random)));
        chain.push_back({chain.back().place + 3.8 * step});
    }
    return chain;
}

TEST(AlignStructures, ScoresChainsAsTmAlignDoes) {
    NACRE_NEEDS_DATA();
    using test::dataFile;
    struct Case {
        const char *moving, *of, *fixed, *onto;
        std::size_t pairs;
        double rmsd, byMoving, byFixed;
    };
    const Case cases[] = {{"4hhb.pdb", "A", "4hhb.pdb", "B", 139, 1.41, 0.90417, 0.87557},
                          {"4hhb.pdb", "A", "1hpv.pdb", "A", 55, 4.31, 0.25755, 0.33261}};
    for (const Case& c : cases) {
        const Places moving = readChain(dataFile(c.moving), c.of), fixed = readChain(dataFile(c.fixed), c.onto);
        const StructureAlignment found = alignStructures(moving, fixed);
        EXPECT_NEAR(static_cast<double>(found.pairs.size()), static_cast<double>(c.pairs), 1) << c.fixed;
        EXPECT_NEAR(found.motion.rmsd, c.rmsd, 0.05) << c.fixed;
        EXPECT_NEAR(found.scoreByMoving, c.byMoving, 0.002) << c.fixed;
        EXPECT_NEAR(found.scoreByFixed, c.byFixed, 0.002) << c.fixed;
    }
    // Unlike folds have several alignments that are nearly as good: none here is worse by more than this.
    const Places crambin = readChain(dataFile("1crn.pdb"), "A"), globin = readChain(dataFile("4hhb.pdb"), "B");
    const Places rhodopsin = readChain(dataFile("3pqr.pdb"), "A"), protease = readChain(dataFile("1hpv.pdb"), "A");
    EXPECT_GT(alignStructures(crambin, protease).scoreByMoving, 0.27269 - 0.005);
    EXPECT_GT(alignStructures(globin, rhodopsin).scoreByMoving, 0.38535 - 0.005);
}

TEST(AlignStructures, FindsAChainThatWasMovedAndCut) {
    const Places whole = walk(150, 1);
    const glm::dquat turn = glm::normalize(glm::dquat(0.3, 0.5, -0.7, 0.2));
    Places moved;
    for (const TraceResidue& residue : whole) moved.push_back({turn * residue.place + glm::dvec3(40, -7, 3)});
    const StructureAlignment same = alignStructures(moved, whole);
    EXPECT_EQ(same.pairs.size(), whole.size());
    EXPECT_NEAR(same.scoreByFixed, 1, 1e-6);
    EXPECT_NEAR(same.motion.rmsd, 0, 1e-6);
    EXPECT_LT(glm::distance(same.motion(moved[7].place), whole[7].place), 1e-5);
    // Thirty residues less: what is left is found, and each length has its score.
    moved.erase(moved.begin() + 60, moved.begin() + 90);
    const StructureAlignment cut = alignStructures(moved, whole);
    EXPECT_GE(cut.pairs.size(), 118u);
    EXPECT_GT(cut.scoreByMoving, 0.98);
    EXPECT_NEAR(cut.scoreByFixed / cut.scoreByMoving, 120.0 / 150, 0.02);
    for (const auto& [i, j] : cut.pairs) {
        EXPECT_TRUE(i <= 65 || j == i + 30) << i << " " << j;
    }
}

TEST(AlignStructures, OfRandomChainsScoreLow) {
    for (unsigned seed = 2; seed < 6; ++seed) {
        const StructureAlignment found = alignStructures(walk(120, seed), walk(130, seed + 100));
        EXPECT_LT(found.scoreByFixed, 0.4) << seed;
        EXPECT_GT(found.scoreByFixed, 0.05) << seed;
        for (std::size_t k = 1; k < found.pairs.size(); ++k) {
            EXPECT_GT(found.pairs[k].first, found.pairs[k - 1].first);
            EXPECT_GT(found.pairs[k].second, found.pairs[k - 1].second);
        }
    }
    const Places five = walk(kFewestAligned, 9);
    EXPECT_NEAR(alignStructures(five, five).scoreByFixed, 1, 1e-6);
}

}  // namespace
}  // namespace nacre
