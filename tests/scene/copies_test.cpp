#include "engine/scene/instances/copies.h"

#include <gtest/gtest.h>

#include <bit>
#include <glm/mat3x3.hpp>
#include <numeric>

#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/view/camera.h"
#include "tests/support/test_data.h"
#include "tests/support/written_out.h"

namespace nacre::test {
namespace {

glm::mat4x3 shift(float x, float y, float z) {
    glm::mat4x3 m(1.0f);
    m[3] = {x, y, z};
    return m;
}

/// Carbon monoxide A, carbon monoxide B 10 Å beside it, and a water's oxygen as subchain C of chain B.
Molecule threeSubchains() {
    Molecule m;
    m.chains = {{"A"}, {"B"}};
    m.subchains = {"A", "B", "C"};
    const auto add = [&](std::uint32_t chain, std::uint32_t subchain, std::initializer_list<glm::vec3> places) {
        Residue residue;
        residue.chain = chain;
        residue.subchain = subchain;
        residue.firstAtom = static_cast<std::uint32_t>(m.atoms.size());
        residue.atomCount = static_cast<std::uint32_t>(places.size());
        for (const glm::vec3& place : places) {
            Atom atom;
            atom.position = place;
            atom.element = m.atoms.size() % 2 ? 8 : 6;
            atom.residue = static_cast<std::uint32_t>(m.residues.size());
            m.atoms.push_back(atom);
        }
        m.residues.push_back(residue);
    };
    add(0, 0, {{0, 0, 0}, {1.1f, 0, 0}});
    add(1, 1, {{10, 0, 0}, {11.1f, 0, 0}});
    add(1, 2, {{12, 0, 0}});
    m.bonds = {{0, 1, 3, BondSource::file}, {2, 3, 3, BondSource::file}, {3, 4, 1, BondSource::file}};
    return m;
}

std::vector<std::uint32_t> everyAtom(const Molecule& molecule) {
    std::vector<std::uint32_t> drawn(molecule.atoms.size());
    std::iota(drawn.begin(), drawn.end(), 0u);
    return drawn;
}

RepresentationOptions look(Style style) {
    RepresentationOptions options{.style = style, .assembly = "1"};
    return options;
}

/// Atoms that stand in two places each: their own, and one that no other atom has.
Molecule manyParts(std::uint32_t count) {
    Molecule m;
    m.chains = {{"A"}};
    m.assemblies = {{"1", "", {}}};
    for (std::uint32_t i = 0; i < count; ++i) {
        m.subchains.push_back(std::to_string(i));
        Residue residue;
        residue.subchain = i;
        residue.firstAtom = i;
        residue.atomCount = 1;
        m.residues.push_back(residue);
        Atom atom;
        atom.position = {4.0f * static_cast<float>(i % 256), 4.0f * static_cast<float>(i / 256), 0};
        atom.element = 6;
        atom.residue = i;
        m.atoms.push_back(atom);
        m.assemblies[0].parts.push_back({{shift(0, 0, 0), shift(0, 0, 4 + static_cast<float>(i) / 1024)}, {i}});
    }
    return m;
}

TEST(Assembly, OfManyPartsWithCopiesOfTheirOwn) {
    constexpr std::uint32_t kParts = 65536;
    const Molecule m = manyParts(kParts);
    const Representation r = represent(m, everyAtom(m), look(Style::spacefill));
    EXPECT_EQ(r.drawnAtoms, 2u * kParts);
    EXPECT_EQ(r.copies.transforms.size(), kParts + 1u);
    ASSERT_EQ(r.copies.spheres.size(), kParts);
    ASSERT_EQ(r.copies.lists.size(), kParts);
    for (const PrimitiveRun& run : r.copies.spheres) ASSERT_EQ(r.copies.lists[run.list].size(), 2u);
}

TEST(Assembly, BondsBetweenManyPartsFindTheirListsWithoutReadingAll) {
    constexpr std::uint32_t kLists = 100'000;
    std::vector<std::vector<std::uint32_t>> lists;
    for (std::uint32_t i = 0; i < kLists; ++i) lists.push_back({0, i + 1, i + 2});
    CopyLists index(lists);
    for (std::uint32_t i = 0; i + 1 < kLists; ++i) ASSERT_EQ(index.common(i, i + 1), kLists + i);
    ASSERT_EQ(lists.back(), (std::vector<std::uint32_t>{0, kLists}));
    EXPECT_EQ(index.common(0, 5), 2 * kLists - 1) << "the place that all have";
    EXPECT_EQ(index.common(3, 4), kLists + 3);
    EXPECT_LT(index.comparisons(), kLists * 2 * 20u * 2);
}

TEST(Assembly, OfTwoPartsSortsPrimitivesByTheirCopies) {
    Molecule m = threeSubchains();
    // B stands in between A and C in the file and has other copies than both.
    m.assemblies = {{"1", "", {{{shift(0, 0, 0), shift(0, 5, 0)}, {0, 2}}, {{shift(0, 0, 0)}, {1}}}}};
    const Representation r = represent(m, everyAtom(m), look(Style::ballAndStick));
    ASSERT_EQ(r.copies.transforms.size(), 2u);
    ASSERT_EQ(r.copies.spheres.size(), 2u);
    std::vector<std::uint32_t> atoms;
    for (const SphereLook& sphere : r.sphereLooks) atoms.push_back(sphere.atom);
    EXPECT_EQ(atoms, (std::vector<std::uint32_t>{1, 2, 5, 3, 4}));
    EXPECT_EQ(r.copies.lists[r.copies.spheres[0].list], (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(r.copies.lists[r.copies.spheres[1].list], (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(r.drawnAtoms, 2u * 3 + 2);
    // The bond between B and C is drawn where both are: once.
    EXPECT_EQ(r.drawnBonds, 2u + 1 + 1);
    for (const PrimitiveRun& run : r.copies.cylinders)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            EXPECT_EQ(r.copies.lists[run.list].size(), r.cylinderLooks[i].atomA <= 2 ? 2u : 1u);
}

TEST(Assembly, LeavesOutWhatItDoesNotMention) {
    Molecule m = threeSubchains();
    m.assemblies = {{"1", "", {{{shift(0, 0, 0)}, {0}}}}};
    const Representation r = represent(m, everyAtom(m), look(Style::spacefill));
    EXPECT_EQ(r.drawnAtoms, 2u);
    EXPECT_EQ(r.center, glm::dvec3(0.55f, 0, 0));
}

TEST(Assembly, StatedTwiceIsDrawnOnce) {
    Molecule m = threeSubchains();
    m.assemblies = {{"1", "", {{{shift(1, 0, 0), shift(1, 0, 0)}, {0}}, {{shift(1, 0, 0)}, {0, 1}}}}};
    const Representation r = represent(m, everyAtom(m), look(Style::spacefill));
    EXPECT_EQ(r.copies.transforms.size(), 1u);
    EXPECT_EQ(r.drawnAtoms, 4u);
}

TEST(Assembly, OfNoSuchNameIsRefusedWithTheNamesThereAre) {
    Molecule m = threeSubchains();
    m.assemblies = {{"1", "", {{{shift(0, 0, 0)}, {0}}}}, {"PAU", "", {{{shift(0, 0, 0)}, {0}}}}};
    try {
        placeAssembly(m, "2");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot draw assembly: 2: the file has no such assembly; it has 1, PAU");
    }
}

TEST(Assembly, ThatStretchesOrHasTooManySticksIsRefused) {
    Molecule m = threeSubchains();
    m.assemblies = {{"1", "", {{{glm::mat4x3(2.0f)}, {0}}}}};
    EXPECT_THROW(represent(m, everyAtom(m), look(Style::spacefill)), Error);
    Molecule many;
    many.chains = {{"A"}};
    many.subchains = {"A"};
    many.residues.resize(1);
    many.residues[0].atomCount = 5000;
    many.atoms.resize(5000);
    many.assemblies = {{"1", "", {{{}, {0}}}}};
    for (int i = 0; i < 860'000; ++i)
        many.assemblies[0].parts[0].transforms.push_back(shift(static_cast<float>(i), 0, 0));
    EXPECT_EQ(represent(many, everyAtom(many), look(Style::spacefill)).drawnAtoms, 4'300'000'000u);  // by levels
    many.atoms[1].position = {1.5f, 0, 0};
    many.bonds = {{0, 1, 1, BondSource::file}};
    EXPECT_THROW(represent(many, everyAtom(many), look(Style::licorice)), Error);
    const std::vector<std::uint32_t> one{0};
    EXPECT_EQ(represent(many, one, look(Style::spacefill)).drawnAtoms, 860'000u);
}

TEST(Assembly, WhoseChainsHaveTooManyPlacesIsRefused) {
    // A chain for each half of 12 parts: 924 lists of 48,000 places.
    constexpr std::uint32_t kParts = 12;
    Molecule m;
    m.chains = {{"A"}};
    m.assemblies = {{"1", "", {}}};
    for (std::uint32_t part = 0; part < kParts; ++part) {
        m.assemblies[0].parts.emplace_back();
        for (std::uint32_t i = 0; i < 8000; ++i)
            m.assemblies[0].parts.back().transforms.push_back(
                shift(static_cast<float>(i), static_cast<float>(part), 0));
    }
    for (std::uint32_t which = 0; which < 1u << kParts; ++which) {
        if (std::popcount(which) != kParts / 2) continue;
        const auto chain = static_cast<std::uint32_t>(m.subchains.size());
        m.subchains.push_back(std::to_string(chain));
        for (std::uint32_t part = 0; part < kParts; ++part)
            if (which >> part & 1) m.assemblies[0].parts[part].subchains.push_back(chain);
    }
    EXPECT_THROW(placeAssembly(m, "1"), Error);
    m.subchains.resize(1);
    for (AssemblyPart& part : m.assemblies[0].parts)
        std::erase_if(part.subchains, [](auto chain) { return chain > 0; });
    EXPECT_EQ(placeAssembly(m, "1").lists.at(0).size(), 48'000u);
}

// Comparing each with each other would take hours.
TEST(CopyColors, OfAMillionCopiesDifferBetweenNeighbours) {
    constexpr std::uint32_t kSide = 100, kColors = 12;
    std::vector<glm::dvec3> centers;
    for (std::uint32_t i = 0; i < kSide * kSide * kSide; ++i)
        centers.emplace_back(i % kSide, i / kSide % kSide, i / kSide / kSide);
    const std::vector<std::uint32_t> order = spreadCopies(centers, kColors);
    ASSERT_EQ(order.size(), centers.size());
    std::vector<std::uint32_t> colors(order.size(), kColors);
    for (std::uint32_t i = 0; i < order.size(); ++i) colors[order[i]] = i % kColors;
    std::size_t pairs = 0, alike = 0;
    for (std::uint32_t i = 0; i < colors.size(); ++i) {
        ASSERT_LT(colors[i], kColors);
        for (const std::uint32_t step : {1u, kSide, kSide * kSide}) {
            if (i / step % kSide + 1 == kSide) continue;
            ++pairs;
            alike += colors[i] == colors[i + step] ? 1 : 0;
        }
    }
    EXPECT_LT(alike * 8, pairs);
}

/// What the exact bounds are, from the copies' atoms written out.
class AssemblyBounds : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(AssemblyBounds, AreThoseOfItsAtomsWrittenOut) {
    NACRE_NEEDS_DATA();
    const Molecule m = readMoleculeFile(dataFile(GetParam().first));
    const auto assembly = std::find_if(m.assemblies.begin(), m.assemblies.end(),
                                       [&](const Assembly& a) { return a.id == GetParam().second; });
    ASSERT_NE(assembly, m.assemblies.end());
    const Molecule whole = writtenOut(m, *assembly);
    RepresentationOptions options{.style = Style::spacefill};
    const Representation expected = represent(whole, everyAtom(whole), options);
    options.assembly = GetParam().second;
    const Representation r = represent(m, everyAtom(m), options);
    EXPECT_EQ(r.drawnAtoms, whole.atoms.size());
    EXPECT_LT(r.spheres.size(), whole.atoms.size());
    EXPECT_LE(glm::length(r.center - expected.center), 1e-4);
    EXPECT_NEAR(r.radius, expected.radius, 1e-4);
    // Every run's sphere holds its primitives.
    for (const PrimitiveRun& run : r.copies.spheres)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            EXPECT_LE(glm::length(glm::dvec3(r.spheres[i].center) - run.center) + r.spheres[i].radius,
                      run.radius + 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Files, AssemblyBounds,
                         testing::Values(std::pair{"1stp-v5.cif", "1"}, std::pair{"1f2n-virus.cif.gz", "3"},
                                         std::pair{"1auy-virus.mmtf", "1"}, std::pair{"3pqr.pdb", "2"}));

// ---- Which copies see the same

glm::dmat4x3 motion(const glm::dmat3& turn, const glm::dvec3& move = {}) { return {turn[0], turn[1], turn[2], move}; }

/// n turns about the z axis, in an order that is not theirs.
std::vector<glm::dmat4x3> ring(int n) {
    std::vector<glm::dmat4x3> copies;
    for (int i = 0; i < n; ++i) copies.push_back(motion(rotationMatrix({0, 0, 360.0 * (i * 7 % n) / n}), {0, 0, 3}));
    return copies;
}

std::vector<std::uint32_t> all(const std::vector<glm::dmat4x3>& copies) {
    std::vector<std::uint32_t> list(copies.size());
    std::iota(list.begin(), list.end(), 0u);
    return list;
}

TEST(RepresentativeCopies, OfARingIsOne) {
    for (const int n : {1, 2, 5, 12}) EXPECT_EQ(representativeCopies(ring(n), all(ring(n)), 50).size(), 1u) << n;
}

TEST(RepresentativeCopies, OfARingWithAGapAreAll) {
    std::vector<glm::dmat4x3> copies = ring(12);
    copies.pop_back();
    EXPECT_EQ(representativeCopies(copies, all(copies), 50).size(), 11u);  // no turn maps it onto itself
}

TEST(RepresentativeCopies, OfTwoRingsAreOneOfEach) {
    // As (1-60)(61-88) makes a capsid of many chains: the same turns of several copies that they do not relate.
    std::vector<glm::dmat4x3> copies;
    for (const glm::dmat4x3& turn : ring(5))
        for (const double far : {20.0, 35.0}) {
            const glm::dmat3 r(turn[0], turn[1], turn[2]);
            const glm::dmat3 tilt = rotationMatrix({far, 10, 0});
            copies.push_back(motion(r * tilt, r * glm::dvec3(far, 0, 0) + turn[3]));
        }
    EXPECT_EQ(representativeCopies(copies, all(copies), 50), (std::vector<std::uint32_t>{0, 1}));
}

TEST(RepresentativeCopies, OfARowAreAll) {
    std::vector<glm::dmat4x3> copies;
    for (int i = 0; i < 4; ++i) copies.push_back(motion(glm::dmat3(1.0), {10.0 * i, 0, 0}));
    EXPECT_EQ(representativeCopies(copies, all(copies), 50).size(), 4u);
}

TEST(RepresentativeCopies, OfCapsidsAreOne) {
    NACRE_NEEDS_DATA();
    // Six decimals in the file; the transforms of 1AUY place the virus off the origin.
    for (const char* file : {"3j6r-hpv16.pdb.gz", "1f2n-virus.cif.gz", "1auy-virus.mmtf"}) {
        const Molecule m = readMoleculeFile(dataFile(file));
        const Representation r = represent(m, drawnAtoms(m), RepresentationOptions{.assembly = "1"});
        ASSERT_EQ(r.copies.transforms.size(), 60u);
        EXPECT_EQ(representativeCopies(r.copies.transforms, r.copies.lists.at(0), r.radius).size(), 1u) << file;
    }
}

}  // namespace
}  // namespace nacre::test
