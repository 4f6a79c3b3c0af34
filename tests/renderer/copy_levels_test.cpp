// Scenes of many copies by levels of detail, beside the same scenes with every atom.

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <random>

#include "engine/error.h"
#include "engine/frame/level_scenes.h"
#include "engine/threads.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// 3,000 turned copies of a piece of DNA, 1.5 million atoms.
Representation crowdOfDna() {
    Molecule m = molecule("sample:dna");
    addCopies(m, {});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int i = 0; i < 3000; ++i) {
        const glm::mat3 turn =
            glm::mat3_cast(glm::normalize(glm::quat(unit(random), unit(random), unit(random), 0.1f)));
        const glm::vec3 place(i % 20 * 30, i / 20 % 10 * 30, i / 200 * 30);
        m.assemblies[0].parts[0].transforms.emplace_back(turn[0], turn[1], turn[2], place + 8.0f * unit(random));
    }
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::chain, .assembly = "1"};
    return represent(m, drawnAtoms(m), options);
}

/// As in multisample_test.cpp.
double measureDecibels(const Picture& a, const Picture& b) {
    double sum = 1e-9;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        for (std::size_t c = i; c < i + 3; ++c) {
            const double d = coded(a.rgba[c]) - coded(b.rgba[c]);
            sum += d * d;
        }
    return 10 * std::log10(static_cast<double>(a.rgba.size()) * 0.75 / sum);
}

/// Share of the covered samples of a picture that have no covered sample of another within some samples.
double outlineApart(const Picture& a, const Picture& b, int samples) {
    std::size_t covered = 0, alone = 0;
    const auto covers = [](const Picture& p, int x, int y) {
        if (x < 0 || y < 0 || x >= static_cast<int>(p.width) || y >= static_cast<int>(p.height)) return false;
        return p.rgba[4 * (static_cast<std::size_t>(y) * p.width + static_cast<std::size_t>(x)) + 3] > 0;
    };
    for (int y = 0; y < static_cast<int>(a.height); ++y)
        for (int x = 0; x < static_cast<int>(a.width); ++x) {
            if (!covers(a, x, y)) continue;
            ++covered;
            bool near = false;
            for (int j = -samples; j <= samples && !near; ++j)
                for (int i = -samples; i <= samples && !near; ++i)
                    near = i * i + j * j <= samples * samples && covers(b, x + i, y + j);
            alone += near ? 0 : 1;
        }
    return static_cast<double>(alone) / static_cast<double>(covered);
}

class CopyLevels : public SharedRenderers<Projection> {};

TEST_P(CopyLevels, ShowWhatTheAtomsShow) {
    const Representation r = crowdOfDna();
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    for (const std::uint32_t supersample : {RenderSettings::kEdges, 4u})
        for (const double zoom : {0.3, 0.7, 1.5, 6.0}) {
            // 30 dB: here even 4 x 4 samples of every atom are only 35 dB from 8 x 8 of them.
            if (supersample == RenderSettings::kEdges && zoom == 1.5) continue;
            RenderSettings s = settings(r, 160, GetParam(), {12, 20, 5}, zoom);
            s.supersample = supersample;
            s.levelsFrom = UINT64_MAX;
            const Picture whole = renderer->render(s);
            EXPECT_TRUE(renderer->stats().copyLevels.empty());
            const std::uint64_t submitted = renderer->stats().spheres;
            s.levelsFrom = 0;
            const Picture levels = renderer->render(s);
            ASSERT_FALSE(renderer->stats().copyLevels.empty());
            if (supersample != RenderSettings::kEdges) {
                EXPECT_LT(renderer->stats().spheres, submitted);
            }
            if (zoom < 1) {
                EXPECT_GT(renderer->stats().copyLevels.front().error, 0);
            }
            if (zoom > 2) {
                EXPECT_EQ(renderer->stats().copyLevels.back().error, 0);
            }
            // Levels have samples at edges, and small atoms without perspective everywhere.
            const bool apart = supersample == RenderSettings::kEdges && zoom > 2;
            EXPECT_GE(measureDecibels(whole, levels), apart ? 32 : 38) << zoom << ", " << supersample;
        }
}

TEST_P(CopyLevels, AreCutByPlanes) {
    const Representation r = crowdOfDna();
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 160, GetParam(), {12, 20, 5}, 6);
    s.supersample = 4;
    s.levelsFrom = 0;
    const Picture uncut = renderer->render(s);
    s.effects.clip = {-40, 60};
    const Picture levels = renderer->render(s);
    s.levelsFrom = UINT64_MAX;
    const Picture whole = renderer->render(s);
    EXPECT_GE(measureDecibels(whole, levels), 38);
    EXPECT_LT(measureDecibels(uncut, levels), 30);
}

// One sample per pixel, as in motion, shows atoms below a pixel by chance: levels come as near to the picture of many
// samples.
TEST_P(CopyLevels, AreNoWorseInMotion) {
    const Representation r = crowdOfDna();
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    for (const double zoom : {0.3, 0.7, 1.5}) {
        RenderSettings s = settings(r, 160, GetParam(), {12, 20, 5}, zoom);
        s.levelsFrom = UINT64_MAX;
        const Picture whole = renderer->render(s);
        s.supersample = 8;
        const Picture best = renderer->render(s);
        s.supersample = 1;
        s.levelsFrom = 0;
        EXPECT_GT(measureDecibels(renderer->render(s), best), measureDecibels(whole, best) - 0.5) << zoom;
    }
}

TEST_P(CopyLevels, HaveOutlinesWithinHalfAPixel) {
    const Representation r = crowdOfDna();
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    constexpr int kFiner = 8;  // samples per pixel and side
    constexpr double kFew = 0.0006;
    for (const double zoom : {0.3, 0.7, 1.5}) {
        RenderSettings s = settings(r, 160 * kFiner, GetParam(), {12, 20, 5}, zoom);
        s.background = {0, 0, 0, 0};  // covered samples are what is not clear
        s.levelsFrom = UINT64_MAX;
        const Picture whole = renderer->render(s);
        s.levelsFrom = 0;
        s.levelError *= kFiner;
        const Picture levels = renderer->render(s);
        EXPECT_LE(outlineApart(whole, levels, kFiner / 2), kFew) << zoom;
        EXPECT_LE(outlineApart(levels, whole, kFiner / 2), kFew) << zoom;
    }
}

TEST_P(CopyLevels, AreTheSameOnEveryPathAndByAnyNumberOfThreads) {
    const Representation r = crowdOfDna();
    RenderSettings s = settings(r, 120, GetParam(), {12, 20, 5}, 0.9);
    s.levelsFrom = 0;
    s.view.quarterTurns = 1;
    std::vector<float> first;
    for (const Visibility path : devicePaths())
        for (const unsigned threads : {1u, 2u}) {
            setThreadsPerTask(threads);
            ValidatedRenderer& renderer = sharedRenderer(path, r);
            const Picture p = renderer->render(s);
            if (first.empty()) first = p.rgba;
            EXPECT_TRUE(p.rgba == first) << visibilityName(path) << ", threads " << threads;
        }
    setThreadsPerTask(0);
}

INSTANTIATE_TEST_SUITE_P(Projections, CopyLevels, testing::Values(Projection::orthographic, Projection::perspective),
                         [](const auto& test) {
                             return test.param == Projection::perspective ? "perspective" : "orthographic";
                         });

TEST(SeenCopies, TakeBoundedMemoryForLargePictures) {
    EXPECT_EQ(LevelScenes::chooseGrid(640, 960), 4u);
    EXPECT_EQ(LevelScenes::chooseGrid(2048, 2048), 4u);
    EXPECT_EQ(LevelScenes::chooseGrid(4096, 4096), 2u);
    EXPECT_EQ(LevelScenes::chooseGrid(16384, 16384), 1u);
}

// Samples beside a pixel's centre may show what no centre shows.
TEST(FourSamplesOfCopyLevels, HaveNoHoles) {
    const Representation r = crowdOfDna();
    DeviceOptions options{true, "", Visibility::fragdepth};
    options.multisampling = Multisampling::four;
    Renderer renderer(options);
    renderer.setScene(r);
    RenderSettings s = settings(r, 160, Projection::orthographic, {12, 20, 5}, 6);
    s.background = {0, 0, 0, 0};
    s.levelsFrom = UINT64_MAX;
    const Picture whole = renderer.render(s);
    EXPECT_EQ(renderer.stats().samples, 4u);
    s.levelsFrom = 0;
    const Picture levels = renderer.render(s);
    ASSERT_FALSE(renderer.stats().copyLevels.empty());
    std::size_t holes = 0;
    for (std::size_t i = 3; i < whole.rgba.size(); i += 4) holes += levels.rgba[i] < whole.rgba[i] ? 1 : 0;
    EXPECT_EQ(holes, 0u);
}

// One atom of each of 70,000 chains in a place of its own: 70,000 squared numbers are more than shaders count.
TEST(CopiesBeyondNumbers, AreDrawnAndTellTheirAtoms) {
    constexpr std::uint32_t kSide = 265, kChains = kSide * kSide;
    Molecule m;
    m.chains = {{"A"}};
    m.assemblies = {{"1", "", {}}};
    for (std::uint32_t i = 0; i < kChains; ++i) {
        m.subchains.push_back(std::to_string(i));
        Residue residue;
        residue.subchain = i;
        residue.firstAtom = i;
        residue.atomCount = 1;
        m.residues.push_back(residue);
        Atom atom;
        atom.element = 6;
        atom.residue = i;
        m.atoms.push_back(atom);
        glm::mat4x3 place(1.0f);
        place[3] = {4.0f * static_cast<float>(i % kSide), 4.0f * static_cast<float>(i / kSide), 0};
        m.assemblies[0].parts.push_back({{place}, {i}});
    }
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::element, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        ValidatedRenderer renderer(path, r);
        RenderSettings s = settings(r, 400, Projection::orthographic, {0, 0, 0}, 8);
        EXPECT_GT(renderer->render(s).rgba.at(4 * (200 * 400 + 200) + 3), 0);
        // The middle of the grid is that of the picture.
        for (const int step : {-20, 0, 10}) {
            const double at = 200 + 4.0 * step * s.view.pixelsPerAngstrom;
            EXPECT_EQ(renderer->atomAt(s, at, 200, 2),
                      kSide * (kSide / 2) + kSide / 2 + static_cast<std::uint32_t>(step) + 1)
                << step;
        }
        s.occlusion.directions = 16;
        EXPECT_THROW(renderer->render(s), Error);
    }
}

}  // namespace
}  // namespace nacre::test
