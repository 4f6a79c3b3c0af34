// Models that are drawn over one another do not darken each other.

#include <algorithm>

#include "tests/occlusion/scenes.h"

namespace nacre::test {
namespace {

/// A buckyball, and the same again and again, each a little moved and turned, as models of one file.
Molecule ensemble(int models) {
    Molecule all = sampleMolecule("buckyball");
    const Molecule one = all;
    for (int m = 1; m < models; ++m) {
        const auto atoms = static_cast<std::uint32_t>(all.atoms.size());
        const auto residues = static_cast<std::uint32_t>(all.residues.size());
        const auto chains = static_cast<std::uint32_t>(all.chains.size());
        for (Chain chain : one.chains) {
            chain.model = m + 1;
            all.chains.push_back(chain);
        }
        for (Residue residue : one.residues) {
            residue.firstAtom += atoms;
            residue.chain += chains;
            all.residues.push_back(residue);
        }
        const glm::dmat3 turn = rotationMatrix({10.0 * m, 25.0 * m, 0});
        for (Atom atom : one.atoms) {
            atom.residue += residues;
            atom.position = glm::vec3(turn * glm::dvec3(atom.position)) + glm::vec3(1.5f * static_cast<float>(m), 0, 0);
            all.atoms.push_back(atom);
        }
        for (Bond bond : one.bonds) {
            bond.a += atoms;
            bond.b += atoms;
            all.bonds.push_back(bond);
        }
    }
    return all;
}

Representation makeScene(const Molecule& m, Style style, bool modelsOcclude) {
    RepresentationOptions options{.style = style};
    options.bondOrders = BondOrders::off;  // dashes of aromatic bonds are spheres, too
    options.modelsOcclude = modelsOcclude;
    return represent(m, drawnAtoms(m), options);
}

/// What is drawn of one model, where it is.
Representation only(const Representation& all, std::uint32_t model) {
    Representation r = all;
    const auto keep = [&](const std::vector<ModelRun>& runs, auto& primitives, auto& looks) {
        const auto run = std::find_if(runs.begin(), runs.end(), [&](const ModelRun& m) { return m.model == model; });
        if (run == runs.end()) return;
        const auto cut = [&](auto& list) {
            list = {list.begin() + run->first, list.begin() + run->first + run->count};
        };
        cut(primitives);
        cut(looks);
    };
    keep(all.sphereModels, r.spheres, r.sphereLooks);
    keep(all.cylinderModels, r.cylinders, r.cylinderLooks);
    r.sphereModels.clear();
    r.cylinderModels.clear();
    return r;
}

LayerPicture baked(Renderer& renderer, const Representation& r, const RenderSettings& s) {
    renderer.setScene(r);
    return renderer.layers(s);
}

class ModelsOcclusion : public SharedRenderers<std::tuple<Style, OcclusionMaps>> {};

TEST_P(ModelsOcclusion, OfEachIsWhatItIsAlone) {
    const auto [style, maps] = GetParam();
    const Representation all = makeScene(ensemble(3), style, false);
    ASSERT_EQ(all.sphereModels.size(), 3u);
    ASSERT_EQ(all.cylinderModels.empty(), style == Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::automatic);
    RenderSettings s = settings(all, 240, Projection::orthographic, {20, 40, 0});
    s.occlusion.directions = 48;  // deep texels are dropped on the way
    s.occlusion.bytes = 24'000'000;
    s.occlusion.maps = maps;
    const LayerPicture together = baked(*renderer.operator->(), all, s);
    std::size_t compared = 0;
    for (std::uint32_t model = 0; model < 3; ++model) {
        const LayerPicture alone = baked(*renderer.operator->(), only(all, model), s);
        const std::size_t before = compared;
        for (std::size_t i = 0; i < together.id.size(); ++i) {
            if (together.id[i] == 0 || together.id[i] != alone.id[i]) continue;  // seen through the others
            // Both are eight bits a texel, between which a pixel's place may round otherwise.
            ASSERT_NEAR(together.occlusion[i], alone.occlusion[i], 1.01 / 255) << "model " << model << ", pixel " << i;
            ++compared;
        }
        EXPECT_GT(compared, before + 500) << model;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, ModelsOcclusion,
                         testing::Combine(testing::Values(Style::spacefill, Style::ballAndStick),
                                          testing::Values(OcclusionMaps::tiles, OcclusionMaps::encoded,
                                                          OcclusionMaps::fragdepth)));

double computeMean(const LayerPicture& p) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < p.id.size(); ++i)
        if (p.id[i] != 0) sum += p.occlusion[i], ++count;
    return sum / static_cast<double>(count);
}

TEST(ModelsOcclusion, OfAllTogetherIsDarker) {
    const Molecule m = ensemble(12);
    ValidatedRenderer renderer(Visibility::automatic);
    const Representation apart = makeScene(m, Style::licorice, false), whole = makeScene(m, Style::licorice, true);
    EXPECT_TRUE(whole.sphereModels.empty());
    RenderSettings s = settings(apart, 200, Projection::orthographic);
    s.occlusion.directions = 32;
    const double own = computeMean(baked(*renderer.operator->(), apart, s));
    const double all = computeMean(baked(*renderer.operator->(), whole, s));
    std::cout << "own " << own << ", all " << all << "\n";
    EXPECT_GT(own, all + 0.1);
}

TEST(ModelsOcclusion, IsBakedLittleByLittleToTheSameEnd) {
    const Representation all = makeScene(ensemble(3), Style::spacefill, false);
    ValidatedRenderer renderer(Visibility::automatic);
    RenderSettings s = settings(all, 160, Projection::orthographic);
    s.occlusion.directions = 40;
    const LayerPicture atOnce = baked(*renderer.operator->(), all, s);
    renderer->setScene(all);
    double share = 0;
    for (int step = 0; step < 1000 && share < 1; ++step) {
        const double next = renderer->advanceOcclusion(s, 0.0);
        ASSERT_GT(next, share);
        share = next;
    }
    EXPECT_EQ(share, 1);
    EXPECT_EQ(renderer->layers(s).occlusion, atOnce.occlusion);
}

TEST(ModelsOcclusion, OfAnAssemblyHasEachModelInItsCopies) {
    Molecule m = ensemble(2);
    m.subchains = {"A"};
    glm::mat4x3 here(1.0f), beside(1.0f);
    beside[3] = {0, 9.0f, 0};
    m.assemblies = {{"1", "", {{{here, beside}, {0}}}}};
    RepresentationOptions options{.style = Style::spacefill, .assembly = "1"};
    const Representation all = represent(m, drawnAtoms(m), options);
    ASSERT_EQ(all.sphereModels.size(), 2u);
    ValidatedRenderer renderer(Visibility::automatic);
    RenderSettings s = settings(all, 200, Projection::orthographic);
    s.occlusion.directions = 64;
    const LayerPicture together = baked(*renderer.operator->(), all, s);
    // The first model alone, in the same copies.
    Molecule lone = ensemble(1);
    lone.subchains = m.subchains;
    lone.assemblies = m.assemblies;
    const LayerPicture alone =
        baked(*renderer.operator->(), represent(lone, drawnAtoms(lone), options, Bounds{all.center, all.radius}), s);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < together.id.size(); ++i) {
        if (together.id[i] == 0 || together.id[i] != alone.id[i]) continue;
        ASSERT_NEAR(together.occlusion[i], alone.occlusion[i], 1.01 / 255) << i;
        ++compared;
    }
    EXPECT_GT(compared, 500u);
}

}  // namespace
}  // namespace nacre::test
