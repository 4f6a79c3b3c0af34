// Assemblies drawn by instancing: the same picture by every path, and the one that their atoms written out give.

#include <array>
#include <cmath>
#include <set>

#include "engine/scene/color/colors.h"
#include "tests/renderer/scenes.h"
#include "tests/support/written_out.h"

namespace nacre::test {
namespace {

struct AssemblyCase {
    const char* file;
    const char* assembly;
    Style style;
    Projection projection;
    double zoom = 1;
};

void PrintTo(const AssemblyCase& c, std::ostream* out) { *out << c.file << " " << c.assembly; }

/// A buckyball and a glucose about it: two parts, three and two copies, one of them mirrored.
Molecule twoParts() {
    Molecule m = sampleMolecule("buckyball");
    const Molecule glucose = sampleMolecule("glucose");
    m.chains = {{"A"}, {"B"}};
    m.subchains = {"A", "B"};
    const auto atoms = static_cast<std::uint32_t>(m.atoms.size());
    const auto residues = static_cast<std::uint32_t>(m.residues.size());
    for (Atom atom : glucose.atoms) {
        atom.residue += residues;
        atom.position += glm::vec3(7, 2, 1);
        m.atoms.push_back(atom);
    }
    for (Residue residue : glucose.residues) {
        residue.firstAtom += atoms;
        residue.chain = residue.subchain = 1;
        m.residues.push_back(residue);
    }
    for (Bond bond : glucose.bonds) {
        bond.a += atoms, bond.b += atoms;
        m.bonds.push_back(bond);
    }
    const auto place = [](const glm::dvec3& degrees, const glm::vec3& shift, float side = 1) {
        const glm::mat3 turn(rotationMatrix(degrees));
        return glm::mat4x3(turn[0] * side, turn[1], turn[2], shift);
    };
    const glm::mat4x3 here = place({}, {});
    m.assemblies = {{"1",
                     "",
                     {{{here, place({40, 10, 0}, {4, 5, -3}), place({0, 0, 90}, {-6, 1, 2}, -1)}, {0}},
                      {{place({15, 0, 70}, {-5, 3, 2}), place({40, 10, 0}, {4, 5, -3})}, {1}}}}};
    return m;
}

Molecule makeMolecule(const AssemblyCase& c) {
    return std::string(c.file) == "two parts" ? twoParts() : molecule(c.file);
}

Representation makeScene(const Molecule& m, const AssemblyCase& c, bool instanced) {
    RepresentationOptions options{.style = c.style};
    options.bondOrders = BondOrders::off;  // dashes of aromatic bonds are spheres, too
    if (instanced) options.assembly = c.assembly;
    return represent(m, drawnAtoms(m), options);
}

class AssemblyPicture : public SharedRenderers<AssemblyCase> {};

TEST_P(AssemblyPicture, IsTheSameByEveryPath) {
    const AssemblyCase& c = GetParam();
    if (std::string(c.file) != "two parts") NACRE_NEEDS_DATA(c.file);
    const Representation r = makeScene(makeMolecule(c), c, true);
    RenderSettings s = settings(r, 256, c.projection, {75, -40, 120}, c.zoom);
    FirstPicture picture;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        for (const PlateShape plates : {PlateShape::octagon, PlateShape::none}) {
            s.tuning.plates = plates;
            picture.expectSame(renderer, s, visibilityName(visibility));
        }
    }
    EXPECT_GT(std::ranges::count_if(picture.layers.id, [](std::uint32_t id) { return id > 0; }), 5000);
}

TEST_P(AssemblyPicture, IsThatOfItsAtomsWrittenOut) {
    const AssemblyCase& c = GetParam();
    if (std::string(c.file) != "two parts") NACRE_NEEDS_DATA(c.file);
    const Molecule m = makeMolecule(c);
    const auto assembly = std::ranges::find_if(m.assemblies, [&](const Assembly& a) { return a.id == c.assembly; });
    ASSERT_NE(assembly, m.assemblies.end());
    const Representation whole = makeScene(writtenOut(m, *assembly), c, false);
    const Representation r = makeScene(m, c, true);
    EXPECT_LT(r.spheres.size(), whole.spheres.size());
    // The same view for both: centres differ by rounding.
    RenderSettings s = settings(r, 256, c.projection, {75, -40, 120}, c.zoom);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::automatic, whole);
    const LayerPicture expected = renderer->layers(s);
    renderer->setScene(r);
    const LayerPicture p = renderer->layers(s);
    // Atoms round to other bits where they are written out, so that edges may fall on the other side of a pixel's
    // centre: 1 pixel in 500 may, and all others agree to 1e-3 Å.
    std::size_t covered = 0, differ = 0;
    for (std::size_t i = 0; i < p.id.size(); ++i) {
        covered += expected.id[i] != 0;
        const bool both = p.id[i] != 0 && expected.id[i] != 0;
        const bool near = both && std::abs(p.z[i] - expected.z[i]) <= 1e-3f &&
                          std::abs(p.rgba[4 * i] - expected.rgba[4 * i]) <= 0.01f;
        const bool neither = p.id[i] == 0 && expected.id[i] == 0;
        differ += !near && !neither;
    }
    std::cout << c.file << ": " << differ << " of " << covered << " pixels differ\n";
    EXPECT_GT(covered, 5000u);
    EXPECT_LE(differ * 500, covered);
}

TEST_P(AssemblyPicture, NamesAtomsByTheirPlaceInTheFile) {
    const AssemblyCase& c = GetParam();
    if (std::string(c.file) != "two parts") NACRE_NEEDS_DATA(c.file);
    const Molecule m = makeMolecule(c);
    const Representation r = makeScene(m, c, true);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::automatic, r);
    const LayerPicture p = renderer->layers(settings(r, 128, c.projection, {10, 20, 30}, c.zoom));
    for (const std::uint32_t id : p.id) ASSERT_LE(id, m.atoms.size());
    if (c.zoom == 1) {
        EXPECT_EQ(renderer->stats().spheres, r.drawnAtoms);
    }
}

/// The same scene with each copy stored for itself, in its colour.
Representation copiesStored(const Representation& r) {
    Representation all = r;
    all.copies = {};
    all.spheres.clear();
    all.sphereLooks.clear();
    all.cylinders.clear();
    all.cylinderLooks.clear();
    const std::vector<std::uint32_t>& colors = r.copies.colors;
    const auto colored = [&](std::uint32_t color, std::uint32_t copy) {
        return isCopyTint(color) ? colors[copy % colors.size()] : color;
    };
    const auto at = [&](std::uint32_t copy, const glm::vec3& p) {
        return glm::vec3(r.copies.transforms[copy] * glm::dvec4(p, 1.0));
    };
    for (const PrimitiveRun& run : r.copies.spheres)
        for (const std::uint32_t copy : r.copies.lists[run.list])
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                all.spheres.push_back({at(copy, r.spheres[i].center), r.spheres[i].radius});
                all.sphereLooks.push_back({colored(r.sphereLooks[i].color, copy), r.sphereLooks[i].atom});
            }
    for (const PrimitiveRun& run : r.copies.cylinders)
        for (const std::uint32_t copy : r.copies.lists[run.list])
            for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
                const Cylinder& c = r.cylinders[i];
                const CylinderLook& look = r.cylinderLooks[i];
                all.cylinders.push_back({at(copy, c.a), c.radius, at(copy, c.b), 0});
                all.cylinderLooks.push_back(
                    {colored(look.colorA, copy), colored(look.colorB, copy), look.atomA, look.atomB});
            }
    return all;
}

/// A copy by a mirror plane shows the fronts of its meshes, as bright as the molecule's own: its picture is the
/// molecule's from right to left.
TEST(MirroredCopy, ShowsTheFrontsOfItsMeshes) {
    Molecule m = sampleMolecule("glucose");
    m.subchains = {"A"};
    m.assemblies = {{"1", "", {{{glm::mat4x3({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0})}, {0}}}}};
    RepresentationOptions look{.style = Style::surface};
    const Representation own = represent(m, drawnAtoms(m), look);
    look.assembly = "1";
    const Representation mirrored = represent(m, drawnAtoms(m), look);
    ASSERT_FALSE(mirrored.triangles.empty());
    constexpr std::uint32_t kSize = 120;
    for (const bool cut : {false, true}) {
        RenderSettings s = settings(own, kSize, Projection::orthographic, {0, 0, 0});
        s.occlusion.directions = 32;
        if (cut) s.effects.clip.near = 0;
        for (const Visibility visibility : devicePaths()) {
            ValidatedRenderer renderer(visibility, own);
            const LayerPicture expected = renderer->layers(s);
            renderer->setScene(mirrored);
            const LayerPicture p = renderer->layers(s);
            std::size_t covered = 0, differ = 0;
            for (std::uint32_t y = 0; y < kSize; ++y)
                for (std::uint32_t x = 0; x < kSize; ++x) {
                    const std::size_t i = y * kSize + x, k = y * kSize + kSize - 1 - x;
                    covered += expected.id[k] != 0;
                    const bool alike = p.id[i] == expected.id[k] &&
                                       std::abs(p.normal[3 * i + 2] - expected.normal[3 * k + 2]) < 0.05f &&
                                       std::abs(p.occlusion[i] - expected.occlusion[k]) < 0.1f;
                    differ += !alike;
                }
            EXPECT_GT(covered, 5000u);
            EXPECT_LT(differ * 20, covered) << visibilityName(visibility) << (cut ? ", cut" : "");
        }
    }
}

/// A clipped molecule beside its mirror image: every path draws the same caps, also at edges.
TEST(MirroredCopy, IsCutBesideTheMoleculeOnEveryPath) {
    Molecule m = sampleMolecule("glucose");
    m.subchains = {"A"};
    m.assemblies = {{"1",
                     "",
                     {{{glm::mat4x3({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}),
                        glm::mat4x3({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 0, 0})},
                       {0}}}}};
    RepresentationOptions look{.style = Style::surface};
    look.assembly = "1";
    const Representation both = represent(m, drawnAtoms(m), look);
    ASSERT_EQ(both.copies.transforms.size(), 2u);
    RenderSettings s = settings(both, 90, Projection::orthographic, {10, 20, 30});
    s.effects.clip.near = 0;
    s.supersample = RenderSettings::kEdges;
    PathRenderers renderers;
    sameOnEveryPath(renderers, both, s);
}

class CopyColors : public SharedRenderers<Style> {};

TEST_P(CopyColors, EachCopyHasItsColourOnEveryPath) {
    const Molecule m = twoParts();
    RepresentationOptions options;
    options.style = GetParam();
    options.assembly = "1";
    options.color = ColorScheme::copy;
    options.rules = {Rule{Rule::Action::color, parseSelection("elem O"), {}, ColorScheme::element}};
    const Representation r = represent(m, drawnAtoms(m), options);
    ASSERT_EQ(r.copies.colors.size(), 4u);  // of two parts with three and two copies, of which one stands alike
    RenderSettings s = settings(r, 256, Projection::orthographic, {75, -40, 120});
    s.occlusion.directions = 0;
    s.lighting = false;
    ValidatedRenderer& usual = sharedRenderer(Visibility::automatic, copiesStored(r));
    const Picture expected = usual->render(s);
    std::vector<Picture> pictures;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        pictures.push_back(renderer->render(s));
        EXPECT_EQ(pictures.front().rgba, pictures.back().rgba) << static_cast<int>(visibility);
    }
    // Rounding may settle a pixel on an edge otherwise.
    std::size_t differ = 0, covered = 0;
    std::set<std::array<float, 3>> colors;
    for (std::size_t i = 0; i < expected.rgba.size(); i += 4) {
        const auto rgb = [&](const Picture& p) { return std::array{p.rgba[i], p.rgba[i + 1], p.rgba[i + 2]}; };
        bool same = true;
        for (std::size_t c = 0; c < 3; ++c) same = same && std::abs(rgb(expected)[c] - rgb(pictures[0])[c]) < 0.01f;
        differ += !same;
        covered += rgb(expected) != std::array{1.0f, 1.0f, 1.0f};
        colors.insert(rgb(expected));
    }
    EXPECT_GT(covered, 5000u);
    EXPECT_LE(differ * 200, covered);
    EXPECT_GE(colors.size(), 5u);  // background, copies, oxygen
}

INSTANTIATE_TEST_SUITE_P(Styles, CopyColors, testing::Values(Style::spacefill, Style::licorice),
                         [](const auto& test) { return test.param == Style::spacefill ? "spacefill" : "licorice"; });

INSTANTIATE_TEST_SUITE_P(
    Assemblies, AssemblyPicture,
    testing::Values(AssemblyCase{"two parts", "1", Style::spacefill, Projection::orthographic},
                    AssemblyCase{"two parts", "1", Style::licorice, Projection::perspective},
                    AssemblyCase{"1stp-v5.cif", "1", Style::spacefill, Projection::perspective},
                    AssemblyCase{"1stp-v5.cif", "1", Style::licorice, Projection::orthographic},
                    AssemblyCase{"1f2n-virus.cif.gz", "3", Style::spacefill, Projection::orthographic, 6},
                    AssemblyCase{"1f2n-virus.cif.gz", "3", Style::spacefill, Projection::perspective, 6}),
    [](const auto& test) { return testName(test.param.file) + std::to_string(test.index); });

}  // namespace
}  // namespace nacre::test
