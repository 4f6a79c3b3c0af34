// Sizes in Å and on paper, gaps of chains, forms of surfaces, and words of rules: as they are drawn.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "app/drawing/complete.h"
#include "app/drawing/drawing.h"
#include "app/picture/options.h"
#include "app/picture/usage_error.h"
#include "engine/molecule/read.h"

namespace nacre::app {
namespace {

using Values = std::initializer_list<std::pair<const char*, const char*>>;

PictureDescription sizedPicture(Values options) {
    PictureDescription picture;
    picture.input.path = "sample:dna";
    picture.input.cache = "off";
    for (const auto& [key, value] : options) setOption(option(key), value, picture);
    takePaper(picture);
    return picture;
}
Representation sizedScene(const Molecule& molecule, Values options) {
    Drawing drawing;
    drawing.prepare(molecule, sizedPicture(options));
    return drawing.scene();
}
float thickest(const std::vector<Cylinder>& sticks) {
    float radius = 0;
    for (const Cylinder& c : sticks) radius = std::max(radius, std::abs(c.radius));
    return radius;
}

TEST(Sizes, AreRadiiInAngstrom) {
    const Molecule dna = sampleMolecule("dna"), glucose = sampleMolecule("glucose");
    EXPECT_FLOAT_EQ(thickest(sizedScene(dna, {{"style", "licorice"}, {"stick-radius", "0.4"}}).cylinders), 0.4f);
    EXPECT_FLOAT_EQ(thickest(sizedScene(dna, {{"style", "backbone"}, {"tube-radius", "0.7"}}).cylinders), 0.7f);
    const Values balls{{"style", "ball-and-stick"}, {"bond-orders", "off"}, {"bond-radius", "0.05"}};
    EXPECT_FLOAT_EQ(thickest(sizedScene(glucose, balls).cylinders), 0.05f);
    const auto ballSize = [&](const char* scale) {
        return sizedScene(glucose, {{"style", "ball-and-stick"}, {"ball-scale", scale}}).spheres.front().radius;
    };
    EXPECT_FLOAT_EQ(ballSize("0.5"), 2 * ballSize("0.25"));
    const auto measureReach = [&](const char* scale) {
        return sizedScene(dna, {{"style", "cartoon"}, {"bases", "none"}, {"cartoon-scale", scale}}).radius;
    };
    EXPECT_GT(measureReach("3"), measureReach("1") + 0.5);
}

TEST(Sizes, RimsFollowThePictureTheCameraOrThePaper) {
    const Molecule dna = sampleMolecule("dna");
    const auto drawn = [&](Values options) {
        Drawing drawing;
        drawing.prepare(dna, sizedPicture(options));
        return drawing.settings;
    };
    const auto outline = [&](const char* width, const char* size) {
        return drawn({{"contours", width}, {"size", size}}).effects.contours.width;
    };
    EXPECT_DOUBLE_EQ(outline("0.5%", "400x300"), 1.5);
    EXPECT_DOUBLE_EQ(outline("0.5%", "3000x4000"), 15);
    EXPECT_DOUBLE_EQ(outline("1.5pt", "400x300"), 2);  // 96 dots per inch
    EXPECT_DOUBLE_EQ(outline("50%", "400x300"), 64);   // the widest
    const RenderSettings close = drawn({{"halos", "0.25A"}, {"zoom", "3"}});
    EXPECT_DOUBLE_EQ(close.effects.halos.width, close.view.pixelsPerAngstrom / 4);
    for (const char* text : {"0.5%", "0.2A", "1pt", "2", "off"}) {
        PictureDescription picture = sizedPicture({{"contours", "3%"}, {"contours", text}});
        EXPECT_EQ(option("contours").value.print(picture), text);
    }
    for (const char* text : {"0%", "nan%", "200A", "-1pt", "%", "1e"}) EXPECT_ANY_THROW(outline(text, "64x64")) << text;
}

TEST(Sizes, InPointsAreTheSameOnPaperWhateverTheResolution) {
    const Molecule dna = sampleMolecule("dna");
    for (const char* dpi : {"300", "600"})
        for (const auto& [option, style] : {std::pair{"stick-radius", "licorice"}, {"tube-radius", "backbone"}}) {
            Drawing drawing;
            drawing.prepare(dna, sizedPicture({{"style", style},
                                               {option, "2pt"},
                                               {"line-width", "1pt"},
                                               {"scale", "60A"},
                                               {"zoom", "1.5"},
                                               {"width", "85mm"},
                                               {"dpi", dpi}}));
            const double pixels =
                2 * static_cast<double>(thickest(drawing.scene().cylinders)) * drawing.settings.view.pixelsPerAngstrom;
            EXPECT_NEAR(pixels * 72 / std::stod(dpi), 2, 1e-5) << option << dpi;
        }
    const auto lineRadius = [&](const char* dpi) {
        return thickest(
            sizedScene(dna, {{"style", "line"}, {"line-width", "1pt"}, {"width", "20mm"}, {"dpi", dpi}}).wires);
    };
    EXPECT_NEAR(2 * lineRadius("300"), 300.0 / 72, 1e-4);
    EXPECT_NEAR(2 * lineRadius("600"), 600.0 / 72, 1e-4);
    EXPECT_THROW(sizedPicture({{"stick-radius", "2pt"}}), UsageError);  // which scale?
}

/// DNA whose first chain lacks residues 5 and 6.
Molecule gappedDna() {
    Molecule dna = sampleMolecule("dna");
    std::vector<bool> chosen = selectAtoms(ResidueFacts(dna), parseSelection("not (chain A and resi 5-6)"));
    Molecule kept = dna;
    kept.atoms.clear(), kept.residues.clear(), kept.bonds.clear();
    std::uint32_t last = ~0u;
    for (std::uint32_t i = 0; i < dna.atoms.size(); ++i) {
        if (!chosen[i]) continue;
        Atom atom = dna.atoms[i];
        if (atom.residue != last) {
            last = atom.residue;
            kept.residues.push_back(dna.residues[last]);
            kept.residues.back().firstAtom = static_cast<std::uint32_t>(kept.atoms.size());
        }
        atom.residue = static_cast<std::uint32_t>(kept.residues.size() - 1);
        kept.atoms.push_back(atom);
    }
    return kept;
}

TEST(Gaps, AreDashedBetweenTheEndsOfTheChain) {
    const Molecule molecule = gappedDna();
    for (const std::string style : {"cartoon", "backbone"}) {
        const Representation plain =
                                 sizedScene(molecule, {{"style", style.c_str()}, {"bases", "none"}, {"gaps", "off"}}),
                             dashed = sizedScene(molecule, {{"style", style.c_str()}, {"bases", "none"}});
        const auto added = [&](const auto& of) { return of(dashed).size() - of(plain).size(); };
        const std::size_t sticks = added([](const Representation&r) { return r.cylinders; }),
                          balls = added([](const Representation&r) { return r.spheres; });
        EXPECT_GT(sticks, 3u) << style;
        EXPECT_EQ(balls, 2 * sticks) << style;  // each dash has round ends
        // From residue 4 to residue 7, and nowhere else.
        double longest = 0;
        glm::dvec3 first(dashed.cylinders[dashed.cylinders.size() - sticks].a);
        for (std::size_t i = dashed.cylinders.size() - sticks; i < dashed.cylinders.size(); ++i)
            longest = std::max(longest, glm::distance(first, glm::dvec3(dashed.cylinders[i].b)));
        const auto place = [&](int number, const char* name) {
            for (const Atom& atom : molecule.atoms) {
                const Residue& residue = molecule.residues[atom.residue];
                if (residue.number == number && atom.name == Name(name)) return glm::dvec3(atom.position);
            }
            return glm::dvec3(0);
        };
        const glm::dvec3 end = place(4, style == "cartoon" ? "O3'" : "P");
        EXPECT_NEAR(longest, glm::distance(end, place(7, "P")), 1) << style;
    }
    const Molecule whole = sampleMolecule("dna");
    EXPECT_TRUE(sizedScene(whole, {{"style", "cartoon"}}).cylinders.empty());
}

TEST(Gaps, NeedAChainThatGoesOn) {
    const auto countDashes = [](const Molecule& molecule, Values options = {{"style", "cartoon"}, {"bases", "none"}}) {
        return sizedScene(molecule, options).cylinders.size();
    };
    const Molecule gapped = gappedDna();
    const std::size_t dashes = countDashes(gapped);
    const auto from = [](Molecule& molecule, int number, const auto& change) {
        for (Residue& residue : molecule.residues)
            if (residue.chain == 0 && residue.number >= number) change(residue);
    };
    // The numbers of mmCIF count; the author's may jump back.
    Molecule jumping = gapped;
    from(jumping, 7, [](Residue& residue) { residue.number -= 6; });
    EXPECT_EQ(countDashes(jumping), dashes);
    // A cleaved chain whose ends are far apart, and two chains of one name.
    Molecule cleaved = gapped;
    from(cleaved, 7, [](Residue& residue) { residue.labelNumber = residue.number -= 2; });
    EXPECT_EQ(countDashes(cleaved), 0u);
    Molecule two = gapped;
    two.subchains.push_back("C");
    from(two, 7, [&](Residue& residue) { residue.subchain = static_cast<std::uint32_t>(two.subchains.size() - 1); });
    EXPECT_EQ(countDashes(two), 0u);
    // A bond that is too long between neighbours by number.
    Molecule stretched = sampleMolecule("dna");
    for (Atom& atom : stretched.atoms) {
        const Residue& residue = stretched.residues[atom.residue];
        if (residue.chain == 0 && residue.number >= 7) atom.position += glm::vec3(2, 2, 2);
    }
    EXPECT_GT(countDashes(stretched), 0u);
    // Where residues are hidden the chain is whole.
    EXPECT_EQ(countDashes(sampleMolecule("dna"), {{"style", "cartoon"}, {"bases", "none"}, {"hide", "resi 5-6"}}), 0u);
}

TEST(Gaps, AreDashedInEachCopy) {
    Molecule molecule = gappedDna();
    AssemblyPart part;
    part.transforms = {glm::mat4x3(1), glm::mat4x3(1)};
    part.transforms[1][3] = {40, 0, 0};
    for (std::uint32_t i = 0; i < molecule.subchains.size(); ++i) part.subchains.push_back(i);
    molecule.assemblies.push_back({"1", "", {part}});
    for (const char* style : {"cartoon", "backbone"}) {
        const Representation one = sizedScene(molecule, {{"style", style}, {"bases", "none"}}),
                             two = sizedScene(molecule, {{"style", style}, {"bases", "none"}, {"assembly", "1"}});
        EXPECT_EQ(two.cylinders.size(), one.cylinders.size()) << style;
        EXPECT_EQ(two.spheres.size(), one.spheres.size()) << style;
        ASSERT_EQ(two.copies.transforms.size(), 2u);
        std::size_t covered = 0;
        for (const PrimitiveRun& run : two.copies.cylinders) {
            covered += run.count;
            EXPECT_EQ(two.copies.lists[run.list].size(), 2u) << style;
        }
        EXPECT_EQ(covered, two.cylinders.size()) << style;
    }
}

TEST(SurfaceForms, AreLinesAndDotsOnTheSurface) {
    const Molecule glucose = sampleMolecule("glucose");
    const Representation solid = sizedScene(glucose, {{"style", "surface"}});
    ASSERT_FALSE(solid.triangles.empty());
    EXPECT_TRUE(solid.wires.empty());
    // Nearest vertex of the solid.
    const auto away = [&](const glm::vec3& p) {
        float least = 1e9f;
        for (const MeshVertex& v : solid.meshVertices)
            least = std::min(least, glm::distance(p, decodePosition(v, solid.triangles.front().step())));
        return least;
    };
    for (const char* form : {"mesh", "dots"}) {
        const Representation r =
            sizedScene(glucose, {{"style", "surface"}, {"surface-form", form}, {"line-width", "2"}});
        EXPECT_TRUE(r.triangles.empty()) << form;
        ASSERT_GT(r.wires.size(), 300u) << form;
        EXPECT_FLOAT_EQ(thickest(r.wires), 1) << form;  // pixels
        float farthest = 0, longest = 0;
        for (std::size_t i = 0; i < r.wires.size(); i += 17) {
            farthest = std::max({farthest, away(r.wires[i].a), away(r.wires[i].b)});
            longest = std::max(longest, glm::distance(r.wires[i].a, r.wires[i].b));
        }
        if (form == std::string("dots")) {
            EXPECT_LT(farthest, 0.05f);
            EXPECT_LT(longest, 0.05f);
            continue;
        }
        // Lines of a mesh lie in planes 0.8 Å apart, within faces of the cells between them.
        EXPECT_LT(farthest, 0.3f);
        EXPECT_LT(longest, 0.8f * std::sqrt(2.0f) + 0.01f);
        for (const auto& wire : r.wires) {
            const glm::vec3 way = glm::abs(wire.b - wire.a);
            EXPECT_LT(std::min({way.x, way.y, way.z}), 1e-3f);
        }
    }
}

TEST(RuleWords, LabelsHaveTheColourAndPlaceOfTheLastRule) {
    const Molecule dna = sampleMolecule("dna");
    Drawing drawing;
    drawing.prepare(dna, sizedPicture({{"label", "resi 3+20={residue} {number} {chain}"},
                                       {"label-color", "chain A=red"},
                                       {"label-offset", "chain B=2,-1.5"}}));
    ASSERT_EQ(drawing.words.labels.size(), 2u);
    for (const PlacedLabel& label : drawing.words.labels) {
        const bool first = label.text.ends_with("A");
        EXPECT_EQ(label.color & 0xffffffu, first ? 0x0000ffu : 0u) << label.text;
        EXPECT_EQ(label.offset.has_value(), !first) << label.text;
        if (label.offset) {
            EXPECT_EQ(*label.offset, glm::dvec2(2, -1.5));
        }
    }
}

TEST(RuleWords, DashesHaveTheColourOfTheirKind) {
    const Molecule dna = sampleMolecule("dna");
    const auto colors = [&](Values options) {
        const Representation r = sizedScene(dna, options);
        std::map<InteractionKind, std::uint32_t> found;
        for (const DrawnContact& contact : r.contacts) found[contact.interaction.kind];
        std::set<std::uint32_t> dashes;
        for (const CylinderLook& look : r.cylinderLooks) dashes.insert(look.colorA & 0xffffffu);
        return std::pair(found.size(), dashes);
    };
    const auto [kinds, drawn] = colors({{"style", "cartoon"},
                                        {"bases", "none"},
                                        {"interactions", "chain A,chain B"},
                                        {"interaction-color", "hydrogen-bond=#123456"}});
    EXPECT_GE(kinds, 1u);
    EXPECT_TRUE(drawn.contains(0x563412u));
    const auto [same, usual] = colors({{"style", "cartoon"}, {"bases", "none"}, {"interactions", "chain A,chain B"}});
    EXPECT_EQ(same, kinds);
    EXPECT_FALSE(usual.contains(0x563412u));
    const auto [again, others] = colors({{"style", "cartoon"},
                                         {"bases", "none"},
                                         {"interactions", "chain A,chain B"},
                                         {"interaction-color", "metal=#123456"}});
    EXPECT_EQ(again, kinds);
    EXPECT_EQ(others, usual);
}

}  // namespace
}  // namespace nacre::app
