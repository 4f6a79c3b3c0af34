// The way between two conformations.

#include "engine/molecule/trajectory/morph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "engine/error.h"
#include "engine/molecule/read.h"
#include "engine/molecule/superpose.h"
#include "tests/support/error_text.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

using Positions = std::vector<glm::vec3>;

/// Two rods of carbon on a square grid that share an end; the second one turned about z there.
Molecule hinge(double degrees) {
    Molecule m;
    m.chains.push_back({"A"});
    Residue residue;
    residue.name = std::string_view("HNG");
    const glm::dquat turn = glm::angleAxis(degrees * std::numbers::pi / 180, glm::dvec3(0, 0, 1));
    for (int rod = 0; rod < 2; ++rod)
        for (int i = 0; i < 12; ++i)
            for (int k = 0; k < 4; ++k) {
                glm::dvec3 at(1.5 * (rod == 0 ? -i - 1 : i + 1), 1.5 * (k % 2), 1.5 * (k / 2));
                if (rod == 1) at = turn * at;
                Atom atom;
                atom.name = std::string_view("C" + std::to_string(m.atoms.size()));
                atom.element = 6;
                atom.position = glm::vec3(at);
                const auto own = static_cast<std::uint32_t>(m.atoms.size());
                if (i > 0) m.bonds.push_back({own, own - 4});
                if (k % 2) m.bonds.push_back({own, own - 1});
                if (k / 2) m.bonds.push_back({own, own - 2});
                m.atoms.push_back(atom);
                ++residue.atomCount;
            }
    for (std::uint32_t k = 0; k < 4; ++k) m.bonds.push_back({k, k + 48});
    m.residues.push_back(residue);
    return m;
}

Positions listPositions(const Molecule& m) {
    Positions positions;
    for (const Atom& atom : m.atoms) positions.push_back(atom.position);
    return positions;
}

/// How far bonds are from between their lengths at both ends, Å.
float strain(const Molecule& m, const Positions& from, const Positions& to, const Positions& at) {
    float most = 0;
    for (const Bond& bond : m.bonds) {
        const float a = glm::distance(from[bond.a], from[bond.b]), b = glm::distance(to[bond.a], to[bond.b]);
        const float now = glm::distance(at[bond.a], at[bond.b]);
        most = std::max({most, std::min(a, b) - now, now - std::max(a, b)});
    }
    return most;
}

Positions halfWay(const Positions& a, const Positions& b) {
    Positions middle;
    for (std::size_t i = 0; i < a.size(); ++i) middle.push_back((a[i] + b[i]) / 2.0f);
    return middle;
}

TEST(Morph, AHingeTurnsInPlaceOfShrinking) {
    const Molecule open = hinge(0), closed = hinge(100), expected = hinge(50);
    const Positions from = listPositions(open), to = listPositions(closed);
    const auto morph = morphThrough(open, {from, to}, {0, 0.5, 1});
    EXPECT_STREQ(morph->format(), "morph");
    EXPECT_EQ(morph->read(0).positions, from);
    EXPECT_EQ(morph->read(2).positions, to);
    const Positions middle = morph->read(1).positions;
    EXPECT_GT(strain(open, from, to, halfWay(from, to)), 0.4f) << "straight lines would shrink them";
    // The bonds of the hinge itself differ at both ends.
    float most = 0;
    for (const Bond& bond : open.bonds)
        if ((bond.a < 48) == (bond.b < 48) && bond.a % 48 > 8 && bond.b % 48 > 8)
            most = std::max(most, std::abs(glm::distance(middle[bond.a], middle[bond.b]) - 1.5f));
    EXPECT_LT(most, 0.03f);
    // Half of the angle.
    std::vector<glm::dvec3> fixed, moving;
    for (std::size_t i = 0; i < middle.size(); ++i)
        fixed.emplace_back(expected.atoms[i].position), moving.emplace_back(middle[i]);
    EXPECT_LT(superpose(fixed, moving).rmsd, 0.4);
    // A frame does not depend on those read before.
    EXPECT_EQ(morph->read(1).positions, middle);
}

TEST(Morph, BondsOfARealPairKeepTheirLengths) {
    NACRE_NEEDS_DATA();
    const Molecule dark = readMoleculeFile(test::dataFile("1u19-rhodopsin.cif.gz"));
    const Molecule active = readMoleculeFile(test::dataFile("3pqr.cif"));
    const Conformation end = fitConformation(active, dark, "1u19");
    EXPECT_GT(end.matched, 2500u) << "326 residues of opsin";
    const Positions from = listPositions(active);
    const auto morph = morphThrough(active, {from, end.positions}, {0.25, 0.5, 0.75});
    const float straight = strain(active, from, end.positions, halfWay(from, end.positions));
    std::vector<float> lengths;
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const Positions at = morph->read(frame).positions;
        std::size_t stretched = 0;
        for (const Bond& bond : active.bonds) {
            const float a = glm::distance(from[bond.a], from[bond.b]);
            const float b = glm::distance(end.positions[bond.a], end.positions[bond.b]);
            const float now = glm::distance(at[bond.a], at[bond.b]);
            stretched += now < std::min(a, b) - 0.1f || now > std::max(a, b) + 0.1f;
        }
        EXPECT_EQ(stretched, 0u) << frame;
        lengths.push_back(strain(active, from, end.positions, at));
    }
    EXPECT_LT(*std::ranges::max_element(lengths), straight / 10);
}

TEST(Morph, IsBounded) {
    // A crowd at one place, all bonded to one atom.
    Molecule crowd;
    crowd.chains.push_back({"A"});
    crowd.residues.emplace_back();
    crowd.residues[0].atomCount = 30'000;
    crowd.atoms.resize(30'000);
    for (std::uint32_t i = 0; i < crowd.atoms.size(); ++i) {
        crowd.atoms[i].element = 6;
        crowd.atoms[i].position = glm::vec3(static_cast<float>(i) * 1e-5f, 0, 0);
        if (i > 0) crowd.bonds.push_back({0, i});
    }
    const Positions from = listPositions(crowd);
    Positions to = from;
    for (glm::vec3& p : to) p.y += 1;
    const Positions middle = morphThrough(crowd, {from, to}, {0.5})->read(0).positions;
    for (const glm::vec3& p : middle) ASSERT_LT(glm::distance(p, glm::vec3(0.15f, 0.5f, 0)), 2) << "on a line";
    crowd.atoms.resize(kMostMorphAtoms + 1);
    EXPECT_THROW(morphThrough(crowd, {listPositions(crowd), listPositions(crowd)}, {0}), Error);
}

TEST(Morph, FindsCounterpartsWhereverTheFileHasThem) {
    Molecule dna = sampleMolecule("dna"), moved = dna;
    const glm::dquat turn = glm::angleAxis(1.0, glm::normalize(glm::dvec3(1, 2, 3)));
    for (Atom& atom : moved.atoms) atom.position = glm::vec3(turn * glm::dvec3(atom.position) + glm::dvec3(5, 6, 7));
    const Conformation whole = fitConformation(dna, moved, "moved");
    EXPECT_EQ(whole.matched, dna.atoms.size());
    for (std::size_t i = 0; i < dna.atoms.size(); ++i)
        ASSERT_LT(glm::distance(whole.positions[i], dna.atoms[i].position), 1e-3f) << "it is superposed";
    // Of one chain alone the other one's atoms go with it.
    Molecule half = moved;
    half.atoms.resize(half.atoms.size() / 2);
    half.residues.resize(half.residues.size() / 2);
    half.chains.resize(1);
    std::erase_if(half.bonds, [&](const Bond& b) { return std::max(b.a, b.b) >= half.atoms.size(); });
    const Conformation part = fitConformation(dna, half, "half");
    EXPECT_EQ(part.matched, half.atoms.size());
    for (std::size_t i = 0; i < dna.atoms.size(); ++i)
        ASSERT_LT(glm::distance(part.positions[i], dna.atoms[i].position), 1e-3f);
    EXPECT_EQ(test::errorText([&] { fitConformation(dna, sampleMolecule("buckyball"), "ball.pdb"); }),
              "cannot take as a conformation: ball.pdb: only 4 of 486 atoms have a counterpart of the same "
              "residue and name");
}

}  // namespace
}  // namespace nacre
