// A part of a molecule that is to be seen whole: its pixels beside those that it has alone.

#include "engine/scene/view/uncover.h"

#include <set>

#include "engine/scene/view/orientation.h"
#include "tests/molecule/build_molecule.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct UncoverCase {
    const char* file;
    const char* part;
    Style style;
    Projection projection;
};

void PrintTo(const UncoverCase& c, std::ostream* out) { *out << c.file << " " << c.part; }

class UncoveredPart : public testing::TestWithParam<UncoverCase> {};

/// The part and nothing else, where it stands.
Representation alone(Representation r, const std::vector<bool>& chosen) {
    const auto keep = [&](std::uint32_t atom) { return chosen[atom - 1]; };
    std::vector<Sphere> spheres;
    std::vector<SphereLook> looks;
    for (std::size_t i = 0; i < r.spheres.size(); ++i)
        if (keep(r.sphereLooks[i].atom)) spheres.push_back(r.spheres[i]), looks.push_back(r.sphereLooks[i]);
    r.spheres = spheres, r.sphereLooks = looks;
    std::vector<Cylinder> cylinders;
    std::vector<CylinderLook> sticks;
    for (std::size_t i = 0; i < r.cylinders.size(); ++i)
        if (keep(r.cylinderLooks[i].atomA) && keep(r.cylinderLooks[i].atomB))
            cylinders.push_back(r.cylinders[i]), sticks.push_back(r.cylinderLooks[i]);
    r.cylinders = cylinders, r.cylinderLooks = sticks;
    std::erase_if(r.triangles, [&](const Triangle& t) { return !keep(r.meshLooks[r.meshVertices[t.a].look].atom); });
    r.coarseTriangles.clear();
    r.meshes.clear();
    if (!r.triangles.empty())
        r.meshes = {{0,
                     static_cast<std::uint32_t>(r.triangles.size()),
                     {},
                     0,
                     static_cast<std::uint32_t>(r.meshVertices.size())}};
    return r;
}

std::size_t countPixels(const LayerPicture& picture, const std::vector<bool>& chosen) {
    return static_cast<std::size_t>(std::count_if(picture.id.begin(), picture.id.end(),
                                                  [&](std::uint32_t id) { return id != 0 && chosen[id - 1]; }));
}

RenderSettings closeTo(const std::vector<bool>& chosen, const Representation& r, Projection projection) {
    Camera camera{.projection = projection};
    camera = closeUp(camera, chosenBalls(r, chosen), r.radius, 3, 1000);
    RenderSettings s{.view = makeView(camera, r.radius, 96, 96)};
    s.occlusion.directions = 0;
    s.supersample = 1;
    return s;
}

TEST_P(UncoveredPart, ShowsNearlyAllThatItShowsAlone) {
    const UncoverCase c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Molecule m = molecule(c.file);
    const std::vector<bool> chosen = selectAtoms(m, parseSelection(c.part));
    Representation r = represent(m, drawnAtoms(m), {c.style, ColorScheme::element});
    const RenderSettings s = closeTo(chosen, r, c.projection);
    ValidatedRenderer renderer(Visibility::tiles);
    const auto pixels = [&](const Representation& scene) {
        renderer->setScene(scene);
        return static_cast<double>(countPixels(renderer->layers(s), chosen));
    };
    const double all = pixels(alone(r, chosen)), before = pixels(r);
    const std::size_t primitives = r.spheres.size() + r.triangles.size();
    const Uncovered u = uncover(r, chosen, s.view, -Clip::kNone);
    EXPECT_GT(all, 100);
    EXPECT_LT(before, 0.9 * all);
    EXPECT_NEAR(u.before, before / all, 0.03);
    EXPECT_GE(u.after, 1 - kStillCovered);
    EXPECT_GE(pixels(r), 0.96 * all);
    // What stands behind or beside stays.
    EXPECT_GT(r.spheres.size() + r.triangles.size(), primitives / 5);
    EXPECT_EQ(r.spheres.size(), r.sphereLooks.size());
    EXPECT_EQ(r.cylinders.size(), r.cylinderLooks.size());
}

constexpr Projection kOrtho = Projection::orthographic, kPerspective = Projection::perspective;
INSTANTIATE_TEST_SUITE_P(Scenes, UncoveredPart,
                         testing::Values(UncoverCase{"1hpv.pdb", "ligand", Style::spacefill, kOrtho},
                                         UncoverCase{"1hpv.pdb", "ligand", Style::spacefill, kPerspective},
                                         UncoverCase{"1hpv.pdb", "ligand", Style::licorice, kOrtho},
                                         UncoverCase{"4hhb.pdb", "resn HEM and chain A", Style::cartoon, kOrtho},
                                         UncoverCase{"1hpv.pdb", "chain A and resi 26", Style::cartoon, kPerspective},
                                         UncoverCase{"sample:dna", "chain B and resi 19", Style::spacefill, kOrtho}));

TEST(Uncover, CopiesStayWhatTheyAreOnEveryPath) {
    Molecule m = sampleMolecule("dna");
    addCopies(m, {{0, 0, 0}, {6, 3, 18}});
    for (const Style style : {Style::spacefill, Style::licorice, Style::cartoon}) {
        RepresentationOptions options{.style = style, .color = ColorScheme::element, .assembly = "1"};
        Representation r = represent(m, drawnAtoms(m), options);
        const std::vector<bool> chosen = selectAtoms(m, parseSelection("chain B and resi 19"));
        RenderSettings s = closeTo(chosen, r, kOrtho);
        const Uncovered u = uncover(r, chosen, s.view, -Clip::kNone);
        EXPECT_EQ(u.spheres > 0, style == Style::spacefill);
        EXPECT_GE(u.after, 1 - kStillCovered);
        std::size_t counted = 0;
        for (const auto* runs : {&r.copies.spheres, &r.copies.cylinders, &r.copies.triangles}) {
            std::uint32_t end = 0;
            for (const PrimitiveRun& run : *runs) {
                EXPECT_EQ(run.first, end);
                end += run.count;
            }
            counted += end;
        }
        EXPECT_EQ(counted, r.spheres.size() + r.cylinders.size() + r.triangles.size());
        PathRenderers renderers;
        if (style == Style::spacefill) sameOnEveryPath(renderers, r, s);
    }
}

// A chain of 14 carbons crosses the part near its end. What is left of that end, two atoms of 14, would float.
TEST(Uncover, LeavesNoScraps) {
    MoleculeText text;
    text.residue("LIG", 1).atom("P1", "C", {0, 0, 0}).atom("P2", "C", {0, 20, 12});
    text.residue("CHN", 2);
    for (int i = 0; i < 14; ++i) text.atom("C" + std::to_string(i), "C", {1.5f * static_cast<float>(i - 11), 0, 6});
    for (std::uint32_t i = 2; i < 15; ++i) text.molecule.bonds.push_back({i, i + 1});
    const Molecule& m = text.molecule;
    Representation r = represent(m, drawnAtoms(m), {Style::ballAndStick, ColorScheme::element});
    const std::vector<bool> part = selectAtoms(m, parseSelection("resn LIG"));
    const RenderSettings s = settings(r, 200, kOrtho, glm::dvec3(0));
    const Uncovered u = uncover(r, part, s.view, -Clip::kNone);
    EXPECT_GT(u.spheres, 0u);
    EXPECT_GE(u.after, 1 - kStillCovered);
    std::set<std::uint32_t> left;
    for (const SphereLook& look : r.sphereLooks) left.insert(look.atom);
    for (std::uint32_t atom : {1u, 2u, 3u, 10u}) EXPECT_TRUE(left.contains(atom)) << atom;  // the part, the long piece
    for (std::uint32_t atom : {14u, 15u, 16u}) EXPECT_FALSE(left.contains(atom)) << atom;
}

TEST(Uncover, LeavesAloneWhatHidesNothing) {
    const Molecule m = sampleMolecule("dna");
    Representation r = scene("sample:dna", Style::spacefill);
    const std::size_t spheres = r.spheres.size();
    const RenderSettings s = settings(r, 96, kOrtho);
    for (const char* part : {"all", "name XX"}) {
        const Uncovered u = uncover(r, selectAtoms(m, parseSelection(part)), s.view, -Clip::kNone);
        EXPECT_EQ(u.before, 1);
        EXPECT_EQ(r.spheres.size(), spheres);
    }
    // A plane that cuts all away before it leaves nothing to leave out.
    const std::vector<bool> last = selectAtoms(m, parseSelection("id 1"));
    const Representation before = r;
    uncover(r, last, s.view, 1e9);
    EXPECT_EQ(r.spheres.size(), before.spheres.size());
}

}  // namespace
}  // namespace nacre::test
