// Interactions as dashed lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "engine/effects.h"
#include "engine/error.h"
#include "engine/molecule/drawn_atoms.h"
#include "engine/molecule/read.h"
#include "engine/scene/build/representation.h"
#include "engine/scene/color/colors.h"
#include "engine/scene/view/uncover.h"
#include "tests/support/test_data.h"

namespace nacre {
namespace {

/// The two strands of DNA, whose bases are bound to each other.
RepresentationOptions bondedStrands(Style style = Style::licorice) {
    RepresentationOptions options{style, ColorScheme::element};
    options.contacts.of = parseSelection("chain A");
    options.contacts.with = parseSelection("chain B");
    options.contacts.kinds = {true};
    return options;
}

Molecule dna() { return sampleMolecule("dna"); }

struct Ends {
    glm::dvec3 a, b;
};
glm::dvec3 atomPosition(const Molecule& molecule, const Representation& scene, std::uint32_t atom) {
    return glm::dvec3(molecule.atoms[atom].position) - scene.center;
}

TEST(Dashes, FillALineEvenlyWithRoundEnds) {
    Representation scene;
    const DashedLine line{{0, 0, 0}, {0, 0, 2.1}, 0.05, {{0.3, 0.2, 0, 0}}, {7, 9}};
    EXPECT_EQ(appendDashes(line, scene), 4u);  // four patterns of 0.5 Å, stretched
    ASSERT_EQ(scene.cylinders.size(), 4u);
    ASSERT_EQ(scene.spheres.size(), 8u);
    const double scale = 2.1 / 4 / 0.5;
    for (std::size_t i = 0; i < 4; ++i) {
        const Cylinder& c = scene.cylinders[i];
        EXPECT_NEAR(c.a.z, scale * (0.1 + 0.5 * static_cast<double>(i)) + 0.05, 1e-5);
        EXPECT_NEAR(c.b.z - c.a.z, scale * 0.3 - 0.1, 1e-5);
        EXPECT_EQ(scene.spheres[2 * i].center, c.a);
        EXPECT_EQ(scene.spheres[2 * i + 1].center, c.b);
        EXPECT_EQ(scene.cylinderLooks[i].atomA, 9u);
        EXPECT_EQ(scene.sphereLooks[i].color, 7u);
    }
}

TEST(Dashes, OfNoLengthAreDots) {
    Representation scene;
    EXPECT_EQ(appendDashes({{0, 0, 0}, {3, 0, 0}, 0.07, {{0, 0.3, 0, 0}}, {1, 1}}, scene), 10u);
    EXPECT_TRUE(scene.cylinders.empty());
    ASSERT_EQ(scene.spheres.size(), 10u);
    EXPECT_NEAR(scene.spheres[1].center.x - scene.spheres[0].center.x, 0.3, 1e-5);
    EXPECT_FLOAT_EQ(scene.spheres[0].radius, 0.07f);
    // Dash and dot in turns.
    scene = {};
    EXPECT_EQ(appendDashes({{0, 0, 0}, {2, 0, 0}, 0.05, {{0.4, 0.3, 0, 0.3}}, {1, 1}}, scene), 4u);
    EXPECT_EQ(scene.cylinders.size(), 2u);
    EXPECT_EQ(scene.spheres.size(), 6u);
    EXPECT_EQ(appendDashes({{0, 0, 0}, {0.05, 0, 0}}, scene), 0u);
}

TEST(Dashes, OfALongLineAreLonger) {
    Representation scene;
    EXPECT_EQ(appendDashes({{0, 0, 0}, {1e5, 0, 0}}, scene), kMostPatterns);
}

TEST(Contacts, EndAtTheSurfacesOfTheirAtoms) {
    const Molecule molecule = dna();
    const Representation scene = represent(molecule, drawnAtoms(molecule), bondedStrands());
    ASSERT_GT(scene.contacts.size(), 20u);
    EXPECT_EQ(scene.firstContact, molecule.atoms.size() + 1);
    std::vector<std::size_t> dashes(scene.contacts.size());
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < scene.cylinders.size(); ++i) {
        const std::uint32_t number = scene.cylinderLooks[i].atomA;
        const DrawnContact* contact = scene.findContact(number);
        if (!contact) continue;
        ++dashes[number - scene.firstContact];
        colors.insert(scene.cylinderLooks[i].colorA);
        const Interaction& bond = contact->interaction;
        const Ends ends{atomPosition(molecule, scene, bond.a.atoms.front()),
                        atomPosition(molecule, scene, bond.b.atoms.front())};
        for (const glm::vec3& point : {scene.cylinders[i].a, scene.cylinders[i].b})
            for (const glm::dvec3& atom : {ends.a, ends.b})
                EXPECT_GT(glm::distance(glm::dvec3(point), atom), 0.25 + 0.07);
        // On the line between the atoms.
        const glm::dvec3 way = glm::normalize(ends.b - ends.a), off = glm::dvec3(scene.cylinders[i].a) - ends.a;
        EXPECT_LT(glm::length(off - way * glm::dot(off, way)), 1e-4);
    }
    for (const std::size_t count : dashes) EXPECT_GE(count, 3u);
    EXPECT_EQ(colors, std::set<std::uint32_t>{contactLook(InteractionKind::hydrogenBond).color});
    EXPECT_EQ(scene.findAtom(scene.firstContact), scene.contacts[0].interaction.a.atoms.front() + 1);
    EXPECT_EQ(scene.atomGroups.size(), molecule.atoms.size() + scene.contacts.size());
    ASSERT_FALSE(scene.legends.empty());
    EXPECT_EQ(scene.legends.back().scheme, kContactScheme);
    ASSERT_EQ(scene.legends.back().entries.size(), 1u);
    EXPECT_EQ(scene.legends.back().entries[0].label, "Hydrogen bond");
}

TEST(Contacts, OfWhatIsHiddenAreNotDrawn) {
    const Molecule molecule = dna();
    RepresentationOptions options = bondedStrands();
    Rule hide;
    hide.action = Rule::Action::hide;
    hide.selection = parseSelection("chain B");
    options.rules = {hide};
    const Representation scene = represent(molecule, drawnAtoms(molecule), options);
    EXPECT_TRUE(scene.contacts.empty());
    EXPECT_FALSE(scene.warnings.empty());
    options.contacts.of = parseSelection("resn XYZ");
    EXPECT_THROW(represent(molecule, drawnAtoms(molecule), options), Error);
}

TEST(Contacts, OfStackedBasesMarkTheMiddlesOfTheirRings) {
    const Molecule molecule = dna();
    RepresentationOptions options = bondedStrands();
    options.contacts.with.reset();
    options.contacts.kinds = {false, false, true};
    options.contacts.of = parseSelection("all");
    const Representation scene = represent(molecule, drawnAtoms(molecule), options);
    ASSERT_FALSE(scene.contacts.empty());
    for (const DrawnContact& contact : scene.contacts)
        for (const InteractionEnd* end : {&contact.interaction.a, &contact.interaction.b}) {
            EXPECT_TRUE(end->ring);
            const glm::vec3 middle(glm::dvec3(end->place) - scene.center);
            std::size_t marks = 0;
            for (std::size_t i = 0; i < scene.spheres.size(); ++i)
                marks += scene.sphereLooks[i].atom >= scene.firstContact &&
                         glm::distance(scene.spheres[i].center, middle) < 1e-4f;
            EXPECT_GE(marks, 1u);
        }
}

TEST(Contacts, AreThoseOfTheAtomsWhereTheyHaveMoved) {
    Molecule molecule = dna();
    MovingScene moving(molecule, drawnAtoms(molecule), bondedStrands());
    const std::size_t spheres = moving.scene().spheres.size(), cylinders = moving.scene().cylinders.size();
    const std::size_t contacts = moving.scene().contacts.size();
    for (int frame = 0; frame < 3; ++frame) {
        for (Atom& atom : molecule.atoms) atom.position.x *= 1.01f;
        moving.move(molecule);
        EXPECT_EQ(moving.scene().spheres.size(), spheres);
        EXPECT_EQ(moving.scene().cylinders.size(), cylinders);
        EXPECT_EQ(moving.scene().legends.size(), 2u);
        const Interaction& first = moving.scene().contacts.front().interaction;
        EXPECT_LT(glm::distance(first.a.place, molecule.atoms[first.a.atoms.front()].position), 1e-5f);
    }
    for (Atom& atom : molecule.atoms) atom.position *= 2.0f;
    moving.move(molecule);
    EXPECT_LT(moving.scene().contacts.size(), contacts);
    EXPECT_EQ(moving.scene().spheres.size(), spheres);
}

TEST(Contacts, OfAnAssemblyStandInEachCopy) {
    Molecule molecule = dna();
    molecule.assemblies = {{"1", "", {{}}}};
    for (std::uint32_t i = 0; i < molecule.subchains.size(); ++i)
        molecule.assemblies[0].parts[0].subchains.push_back(i);
    for (const float x : {0.0f, 40.0f}) {
        glm::mat4x3 transform(1.0f);
        transform[3].x = x;
        molecule.assemblies[0].parts[0].transforms.push_back(transform);
    }
    RepresentationOptions options = bondedStrands();
    options.assembly = "1";
    const Representation scene = represent(molecule, drawnAtoms(molecule), options);
    std::size_t copies = 0;
    for (const PrimitiveRun& run : scene.copies.cylinders)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            if (scene.findContact(scene.cylinderLooks[i].atomA)) copies += scene.copies.lists[run.list].size();
    std::size_t dashes = 0;
    for (const CylinderLook& look : scene.cylinderLooks) dashes += scene.findContact(look.atomA) != nullptr;
    EXPECT_GT(dashes, 60u);
    EXPECT_EQ(copies, 2 * dashes);
}

/// A molecule's copies as a molecule of their own.
Molecule spelledOut(const Molecule& molecule, const std::vector<glm::mat4x3>& transforms) {
    Molecule all;
    for (const glm::mat4x3& transform : transforms) {
        const auto atoms = static_cast<std::uint32_t>(all.atoms.size());
        const auto residues = static_cast<std::uint32_t>(all.residues.size());
        const auto chains = static_cast<std::uint32_t>(all.chains.size());
        for (Atom atom : molecule.atoms) {
            atom.position = transform * glm::vec4(atom.position, 1);
            atom.residue += residues;
            all.atoms.push_back(atom);
        }
        for (Residue residue : molecule.residues) {
            residue.firstAtom += atoms;
            residue.chain += chains;
            all.residues.push_back(residue);
        }
        for (Bond bond : molecule.bonds) {
            bond.a += atoms;
            bond.b += atoms;
            all.bonds.push_back(bond);
        }
        all.chains.insert(all.chains.end(), molecule.chains.begin(), molecule.chains.end());
    }
    all.subchains = molecule.subchains;
    return all;
}

struct SeenContact {
    InteractionKind kind;
    glm::dvec3 middle;
};

/// Every contact of every copy, where it is seen.
std::vector<SeenContact> seenContacts(const Representation& scene) {
    std::vector<SeenContact> seen;
    std::set<std::uint32_t> done;
    const auto add = [&](std::uint32_t number, const std::vector<std::uint32_t>* list) {
        const DrawnContact* contact = scene.findContact(number);
        if (!contact || !done.insert(number).second) return;
        const glm::dvec4 middle(contact->middle, 1);
        if (!list) seen.push_back({contact->interaction.kind, contact->middle + scene.center});
        for (std::size_t i = 0; list && i < list->size(); ++i)
            seen.push_back({contact->interaction.kind, scene.copies.transforms[(*list)[i]] * middle + scene.center});
    };
    for (const PrimitiveRun& run : scene.copies.spheres)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            add(scene.sphereLooks[i].atom, &scene.copies.lists[run.list]);
    if (scene.copies.transforms.empty())
        for (const SphereLook& look : scene.sphereLooks) add(look.atom, nullptr);
    return seen;
}

/// Those between copies: in an assembly by their images, spelled out by their atoms.
std::vector<SeenContact> betweenCopies(const Representation& scene, std::size_t atoms) {
    Representation kept = scene;
    const auto joins = [&](const Interaction& i) {
        if (!scene.copies.transforms.empty()) return i.a.image != i.b.image;
        return i.a.atoms.front() / atoms != i.b.atoms.front() / atoms;
    };
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        if (!joins(scene.contacts[i].interaction))
            for (SphereLook& look : kept.sphereLooks)
                if (look.atom == scene.firstContact + i) look.atom = 1;
    return seenContacts(kept);
}

TEST(Contacts, JoinTheCopiesOfAnAssembly) {
    NACRE_NEEDS_DATA();
    Molecule molecule = readMoleculeFile(test::dataFile("1stp-v5.cif"));  // a tetramer of 222 symmetry
    const std::vector<glm::mat4x3> four = molecule.assemblies.at(0).parts.at(0).transforms;
    ASSERT_EQ(four.size(), 4u);
    RepresentationOptions options{Style::licorice, ColorScheme::element};
    options.contacts.of = parseSelection("all");
    for (std::size_t other = 1; other <= 4; ++other) {
        const std::vector<glm::mat4x3> transforms = other == 4 ? four : std::vector{four[0], four[other]};
        const Molecule all = spelledOut(molecule, transforms);
        options.assembly.clear();
        const auto expected = betweenCopies(represent(all, drawnAtoms(all), options), molecule.atoms.size());
        molecule.assemblies[0].parts[0].transforms = transforms;
        options.assembly = molecule.assemblies[0].id;
        const auto seen = betweenCopies(represent(molecule, drawnAtoms(molecule), options), molecule.atoms.size());
        // Of four copies a third one may stand in the way, which the search between two does not see.
        EXPECT_LE(expected.size(), seen.size());
        EXPECT_LE(seen.size(), expected.size() + (other == 4 ? 4 : 0));
        EXPECT_GT(expected.size(), other == 4 ? 20u : 0u);
        for (const SeenContact& one : expected)
            EXPECT_TRUE(std::any_of(seen.begin(), seen.end(),
                                    [&](const SeenContact& found) {
                                        return one.kind == found.kind && glm::distance(one.middle, found.middle) < 1e-2;
                                    }))
                << interactionKindName(one.kind) << " of copy " << other << " at " << one.middle.x << " "
                << one.middle.y << " " << one.middle.z;
    }
}

TEST(Contacts, HideNothingThatIsUncoveredAndGoWithTheirAtoms) {
    const Molecule molecule = dna();
    Representation scene = represent(molecule, drawnAtoms(molecule), bondedStrands(Style::spacefill));
    const std::size_t contacts = scene.contacts.size();
    ASSERT_GT(contacts, 0u);
    Camera camera;
    uncover(scene, selectAtoms(molecule, parseSelection("chain B and resi 18")),
            makeView(camera, scene.radius, 256, 256), Clip{}.near);
    std::set<std::uint32_t> atoms;
    for (const SphereLook& look : scene.sphereLooks)
        if (!scene.findContact(look.atom)) atoms.insert(look.atom - 1);
    ASSERT_LT(atoms.size(), molecule.atoms.size());
    for (const SphereLook& look : scene.sphereLooks)
        if (const DrawnContact* contact = scene.findContact(look.atom)) {
            EXPECT_TRUE(atoms.contains(contact->interaction.a.atoms.front()));
            EXPECT_TRUE(atoms.contains(contact->interaction.b.atoms.front()));
        }
}

TEST(Contacts, DrawTheWatersOfBridges) {
    NACRE_NEEDS_DATA();
    const Molecule molecule = readMoleculeFile(test::dataFile("1hpv.pdb"));
    RepresentationOptions options{Style::licorice, ColorScheme::element};
    options.contacts.of = parseSelection("ligand");
    const Representation scene = represent(molecule, drawnAtoms(molecule), options);  // water is hidden
    std::set<std::uint32_t> bridging;
    for (const DrawnContact& contact : scene.contacts)
        bridging.insert(contact.interaction.waters.begin(), contact.interaction.waters.end());
    ASSERT_FALSE(bridging.empty());
    for (const std::uint32_t water : bridging) {
        std::size_t balls = 0;
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            if (scene.sphereLooks[i].atom != water + 1) continue;
            ++balls;
            EXPECT_LT(glm::distance(glm::dvec3(scene.spheres[i].center), atomPosition(molecule, scene, water)), 1e-4);
            EXPECT_NEAR(scene.spheres[i].radius, 0.38f, 0.01f);  // of an oxygen's ball
            EXPECT_EQ(scene.sphereLooks[i].color, elementColor(8));
        }
        EXPECT_EQ(balls, 1u) << water;
    }
}

}  // namespace
}  // namespace nacre
