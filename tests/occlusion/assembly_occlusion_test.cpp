// Occlusion of an assembly is that of the whole: the same as where its copies' atoms are written out.

#include <algorithm>
#include <cmath>

#include "engine/occlusion/bake.h"
#include "engine/occlusion/depth_maps.h"
#include "tests/renderer/meshes.h"
#include "tests/renderer/scenes.h"
#include "tests/support/written_out.h"

namespace nacre::test {
namespace {

/// A buckyball and turned copies of it that touch it.
Molecule cluster(std::initializer_list<double> degrees) {
    Molecule m = sampleMolecule("buckyball");
    m.subchains = {"A"};
    m.assemblies = {{"1", "", {{{}, {0}}}}};
    for (const double angle : degrees) {
        const glm::mat3 turn(rotationMatrix({0, 0, angle}));
        m.assemblies[0].parts[0].transforms.emplace_back(turn[0], turn[1], turn[2], turn * glm::vec3(7, 0, 0));
    }
    return m;
}

Representation makeScene(const Molecule& m, bool instanced) {
    RepresentationOptions options{.style = Style::spacefill};
    if (instanced) options.assembly = "1";
    return represent(m, drawnAtoms(m), options);
}

LayerPicture baked(Renderer& renderer, const Representation& r, int directions) {
    RenderSettings s = settings(r, 200, Projection::orthographic, {30, 20, 10});
    s.occlusion.directions = directions;
    renderer.setScene(r);
    return renderer.layers(s);
}

struct LayerDifference {
    double mean = 0, rootMeanSquare = 0;
};

LayerDifference difference(const LayerPicture& a, const LayerPicture& b) {
    LayerDifference d;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        if (a.id[i] == 0 || b.id[i] == 0) continue;
        const double by = a.occlusion[i] - b.occlusion[i];
        d.mean += by;
        d.rootMeanSquare += by * by;
        ++count;
    }
    EXPECT_GT(count, 5000u);
    d.mean /= static_cast<double>(count);
    d.rootMeanSquare = std::sqrt(d.rootMeanSquare / static_cast<double>(count));
    return d;
}

TEST(AssemblyOcclusion, OfARingIsThatOfItsAtomsWrittenOut) {
    const Molecule m = cluster({0, 90, 180, 270});
    ValidatedRenderer renderer(Visibility::automatic);
    const LayerPicture whole = baked(*renderer.operator->(), makeScene(writtenOut(m, m.assemblies[0]), false), 256);
    const LayerPicture copies = baked(*renderer.operator->(), makeScene(m, true), 256);
    const LayerDifference d = difference(copies, whole);
    std::cout << "mean " << d.mean << ", RMS " << d.rootMeanSquare << "\n";
    // Each copy written out meets the directions in other places.
    EXPECT_LE(std::abs(d.mean), 0.01);
    EXPECT_LE(d.rootMeanSquare, 0.04);
}

TEST(AssemblyOcclusion, OfCopiesThatDifferIsTheirMean) {
    // Three in a row about a corner: the one in the middle has two neighbours.
    const Molecule m = cluster({0, 70, 140});
    const Representation r = makeScene(m, true);
    ValidatedRenderer renderer(Visibility::automatic);
    const LayerPicture whole = baked(*renderer.operator->(), makeScene(writtenOut(m, m.assemblies[0]), false), 255);
    const LayerPicture copies = baked(*renderer.operator->(), r, 255);
    const LayerDifference d = difference(copies, whole);
    std::cout << "mean " << d.mean << ", RMS " << d.rootMeanSquare << "\n";
    EXPECT_LE(std::abs(d.mean), 0.03);
    EXPECT_LE(d.rootMeanSquare, 0.2);
    // Alone, without its neighbours, the first is lighter.
    Molecule alone = m;
    alone.assemblies[0].parts[0].transforms.resize(1);
    const LayerPicture lone = baked(*renderer.operator->(), makeScene(alone, true), 255);
    double sumOfLone = 0, sumOfCopies = 0;
    std::size_t countLone = 0, countCopies = 0;
    for (std::size_t i = 0; i < lone.id.size(); ++i) {
        if (lone.id[i]) sumOfLone += lone.occlusion[i], ++countLone;
        if (copies.id[i]) sumOfCopies += copies.occlusion[i], ++countCopies;
    }
    EXPECT_LT(sumOfCopies / static_cast<double>(countCopies), sumOfLone / static_cast<double>(countLone));
}

TEST(AssemblyOcclusion, OfTwoPartsWithTheirOwnCopies) {
    // The second part lies inside the first one in the file, and beside it in the assembly.
    Molecule m = sampleMolecule("buckyball");
    const Molecule other = m;
    m.chains = {{"A"}, {"B"}};
    m.subchains = {"A", "B"};
    for (Residue residue : other.residues) {
        residue.firstAtom += 60;
        residue.chain = residue.subchain = 1;
        m.residues.push_back(residue);
    }
    for (Atom atom : other.atoms) {
        atom.residue += static_cast<std::uint32_t>(other.residues.size());
        atom.position += glm::vec3(1, 0, 0);
        m.atoms.push_back(atom);
    }
    m.bonds.clear();
    glm::mat4x3 here(1.0f), beside(1.0f);
    beside[3] = {9.5f, 0, 0};
    m.assemblies = {{"1", "", {{{here}, {0}}, {{beside}, {1}}}}};
    ValidatedRenderer renderer(Visibility::automatic);
    const LayerPicture whole = baked(*renderer.operator->(), makeScene(writtenOut(m, m.assemblies[0]), false), 128);
    const LayerPicture parts = baked(*renderer.operator->(), makeScene(m, true), 128);
    const LayerDifference d = difference(parts, whole);
    std::cout << "mean " << d.mean << ", RMS " << d.rootMeanSquare << "\n";
    EXPECT_LE(std::abs(d.mean), 0.005);
    EXPECT_LE(d.rootMeanSquare, 0.01);
}

// A texel asks one of two opposite directions where a step takes both: of every copy, and however many a step takes.
TEST(OcclusionSteps, OfAnyNumberOfDirectionsGiveTheSame) {
    const gpu::Device device{DeviceOptions{}};
    gpu::Executor executor{device};
    for (const Representation& r : {meshScene(), makeScene(cluster({0, 70, 140}), true)}) {
        const passes::SceneBuffers buffers = passes::makeSceneBuffers(device, r);
        std::vector<std::uint8_t> single;
        for (const std::uint32_t most : {1u, 3u, 7u, 16u}) {
            occlusion::Bake bake(device, buffers, r, {21, 4 << 20, OcclusionMaps::tiles, 12});
            while (!bake.complete()) bake.step(executor, most);
            bake.finish(executor);
            if (most == 1) single = bake.atlasTexels();
            EXPECT_EQ(bake.atlasTexels(), single) << most;
        }
        EXPECT_LT(*std::ranges::min_element(single), 100);
    }
}

TEST(AssemblyOcclusion, MeshesInManyCopiesHaveCoarserMaps) {
    Representation r;
    r.radius = 313;
    r.triangles.resize(86'000);
    r.meshVertices.resize(1);  // flat
    r.meshLooks.resize(4000);
    const auto measureSizes = [&](std::size_t copies) {
        std::vector<std::uint32_t> all(copies);
        for (std::uint32_t i = 0; i < copies; ++i) all[i] = i;
        r.copies.transforms.assign(copies, glm::dmat4x3(1.0));
        r.copies.lists = {all};
        r.copies.triangles = {{0, 86'000, 0, {}, 0}};
        return occlusion::DepthMapSizes::pixelsFor(r, 64u << 20, 32);
    };
    const std::uint32_t few = measureSizes(40), many = measureSizes(216), most = measureSizes(20'000);
    EXPECT_EQ(few, 784u);
    const double share = std::sqrt(8e6 / (216 * 86e3));
    EXPECT_NEAR(many, 784 * share, 8);
    EXPECT_NEAR(most, 784 * 0.4, 8);
}

}  // namespace
}  // namespace nacre::test
