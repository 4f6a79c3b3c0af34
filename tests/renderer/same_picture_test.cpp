// One picture, however it is made: prepass on and off, merged and unmerged, encoded and fragdepth, bit for bit.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "engine/error.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

void expectSameLayers(const LayerPicture& a, const LayerPicture& b, const std::string& what) {
    std::size_t ids = 0, depths = 0, covered = 0;
    for (std::size_t i = 0; i < a.id.size(); ++i) {
        covered += a.id[i] != 0;
        ids += a.id[i] != b.id[i];
        depths += a.z[i] != b.z[i];
    }
    EXPECT_GT(covered, 1000u) << what;
    EXPECT_EQ(ids, 0u) << what;
    EXPECT_EQ(depths, 0u) << what;
    EXPECT_EQ(a.normal, b.normal) << what;
    EXPECT_EQ(a.rgba, b.rgba) << what;
}

struct Case {
    const char* file;
    Style style;
    Projection projection;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.file; }

class SamePicture : public SharedRenderers<Case> {};

TEST_P(SamePicture, WhateverThePath) {
    const Case& c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Representation r = scene(c.file, c.style);
    RenderSettings s = settings(r, 160, c.projection, {75, -40, 120});
    std::vector<LayerPicture> pictures;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        for (const bool prepass : {true, false})
            for (const bool merge : {true, false}) {
                s.tuning.plates = prepass ? PlateShape::octagon : PlateShape::none;
                s.tuning.merge = merge;
                pictures.push_back(renderer->layers(s));
                const std::string what = "path " + std::to_string(static_cast<int>(visibility)) +
                                         (prepass ? "" : ", no prepass") + (merge ? "" : ", unmerged");
                expectSameLayers(pictures.front(), pictures.back(), what);
            }
    }
}

TEST_P(SamePicture, WhateverThePlatesAndImpostors) {
    const Case& c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Representation r = scene(c.file, c.style);
    RenderSettings s = settings(r, 160, c.projection, {33, 190, -70});
    for (const Visibility visibility : {Visibility::encoded, Visibility::fragdepth}) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        s.tuning.plates = PlateShape::none;
        s.tuning.impostor = ImpostorShape::square;
        const LayerPicture plain = renderer->layers(s);
        for (const PlateShape plates : {PlateShape::square, PlateShape::octagon, PlateShape::dome2, PlateShape::dome3})
            for (const ImpostorShape impostor : {ImpostorShape::octagon, ImpostorShape::pyramid}) {
                s.tuning.plates = plates;
                s.tuning.impostor = impostor;
                expectSameLayers(plain, renderer->layers(s),
                                 "plates " + std::to_string(static_cast<int>(plates)) + ", impostor " +
                                     std::to_string(static_cast<int>(impostor)));
            }
    }
}

TEST_P(SamePicture, OfColourToo) {
    const Case& c = GetParam();
    NACRE_NEEDS_DATA(c.file);
    const Representation r = scene(c.file, c.style);
    RenderSettings s = settings(r, 128, c.projection);
    std::vector<float> first;
    for (const Visibility visibility : devicePaths()) {
        ValidatedRenderer& renderer = sharedRenderer(visibility, r);
        for (const bool prepass : {true, false})
            for (const bool merge : {true, false}) {
                s.tuning.plates = prepass ? PlateShape::octagon : PlateShape::none;
                s.tuning.merge = merge;
                const Picture p = renderer->render(s);
                if (first.empty()) first = p.rgba;
                EXPECT_EQ(p.rgba, first) << "prepass " << prepass << ", merge " << merge;
            }
    }
}

TEST(SamePicture, OfOcclusionToo) {
    PathRenderers renderers;
    for (const Style style : {Style::spacefill, Style::licorice}) {
        const Representation r = scene("sample:dna", style);
        RenderSettings s = settings(r, 200, Projection::orthographic);
        s.occlusion.directions = 8;
        const std::vector<float> occlusion = sameOnEveryPath(renderers, r, s).occlusion;
        EXPECT_LT(*std::min_element(occlusion.begin(), occlusion.end()), 0.5f);
    }
}

TEST(SamePicture, WhateverWasDrawnBefore) {
    // Buffers of a frame are used again: nothing of what they held may show, whatever size and place that had.
    const Representation r = scene("sample:dna", Style::spacefill), small = scene("sample:glucose", Style::spacefill);
    ValidatedRenderer used(Visibility::tiles);
    for (const auto& [size, zoom] : {std::pair{200u, 0.4}, {200u, 2.0}, {200u, 0.3}, {120u, 1.0}, {200u, 0.3}}) {
        const RenderSettings s = settings(r, size, Projection::orthographic, {20, 30, 10}, zoom);
        ValidatedRenderer fresh(Visibility::tiles);
        used->setScene(r);
        fresh->setScene(r);
        const Picture picture = used->render(s);
        EXPECT_EQ(picture.rgba, fresh->render(s).rgba) << size << " at " << zoom;
        EXPECT_EQ(used->layers(s).id, fresh->layers(s).id) << size << " at " << zoom;
        used->setScene(small);
        used->render(s);
    }
}

TEST(SamePicture, OfSticksWhateverWasDrawnBefore) {
    // Shaders write the pixels that sticks cover: the host clears the others, where a frame before has drawn some.
    ValidatedRenderer used(Visibility::tiles);
    for (const Style style : {Style::licorice, Style::ballAndStick}) {
        const Representation r = scene("sample:dna", style);
        ValidatedRenderer fresh(Visibility::tiles);
        used->setScene(r);
        fresh->setScene(r);
        const RenderSettings s = settings(r, 200, Projection::orthographic, {20, 30, 10});
        const Picture picture = fresh->render(s);
        used->render(settings(r, 200, Projection::orthographic, {50, -10, 80}));
        EXPECT_EQ(used->render(s).rgba, picture.rgba);
    }
}

TEST(SamePicture, OfEveryMoleculeThatThereIs) {
    NACRE_NEEDS_DATA();
    std::vector<std::unique_ptr<ValidatedRenderer>> renderers;
    for (const Visibility path : devicePaths()) renderers.push_back(std::make_unique<ValidatedRenderer>(path));
    std::size_t molecules = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(*dataFolder())) {
        const std::string name = entry.path().string();
        if (!entry.is_regular_file() || name.find("/bad/") != std::string::npos) continue;
        Representation r;
        try {
            const Molecule m = readMoleculeFile(name);
            // Larger ones add time, not cases: the paths differ in how they draw, not in what.
            if (m.atoms.size() > 7000 || m.atoms.empty()) continue;
            r = represent(m, drawnAtoms(m), {defaultStyle(m, drawnAtoms(m)), {}});
        } catch (const Error&) {
            continue;  // no structure file
        }
        ++molecules;
        const RenderSettings s = settings(r, 96, Projection::orthographic);
        LayerPicture first;
        for (const auto& renderer : renderers) {
            (*renderer)->setScene(r);
            const LayerPicture p = (*renderer)->layers(s);
            if (first.id.empty()) first = p;
            EXPECT_EQ(p.id, first.id) << name;
            EXPECT_EQ(p.z, first.z) << name;
        }
    }
    EXPECT_GE(molecules, 65u);
}

TEST(SamePicture, TransientOrStored) {
    const Representation r = scene("sample:dna", Style::spacefill);
    const RenderSettings s = settings(r, 128, Projection::orthographic);
    std::vector<std::vector<float>> pictures;
    for (const char* stored : {"0", "1"}) {
        setenv("NACRE_NO_TRANSIENT", stored, 1);
        ValidatedRenderer renderer(Visibility::encoded, r, ValidatedRenderer::fresh);
        pictures.push_back(renderer->render(s).rgba);
        // Stored attachments show in the frame's traffic: depth and encoded depth beside the colour.
        EXPECT_EQ(renderer->stats().storedBytes, 128u * 128u * (stored[0] == '1' ? 12u : 4u));
    }
    unsetenv("NACRE_NO_TRANSIENT");
    EXPECT_EQ(pictures[0], pictures[1]);
    // The same for one picture.
    ValidatedRenderer renderer(Visibility::encoded, r);
    RenderSettings one = s;
    for (const bool transient : {true, false}) {
        one.tuning.transient = transient;
        EXPECT_EQ(renderer->render(one).rgba, pictures[0]);
        EXPECT_EQ(renderer->stats().storedBytes, 128u * 128u * (transient ? 4u : 12u));
    }
}

TEST(Frame, OfNothingIsTheBackground) {
    for (const Visibility path : devicePaths())
        for (const bool set : {false, true}) {
            ValidatedRenderer renderer(path, ValidatedRenderer::fresh);
            if (set) renderer->setScene({});
            RenderSettings s{.view = makeView({}, 1, 40, 30), .supersample = 1, .background = {1, 0, 0, 1}};
            s.occlusion.directions = 8;
            const std::vector<float> rgba = renderer->render(s).rgba;
            ASSERT_EQ(rgba.size(), 4u * 40 * 30);
            for (std::size_t i = 0; i < rgba.size(); i += 4)
                ASSERT_EQ(std::vector(&rgba[i], &rgba[i] + 4), (std::vector<float>{1, 0, 0, 1}));
            EXPECT_EQ(renderer->layers(s).id, std::vector<std::uint32_t>(40 * 30));
            EXPECT_EQ(renderer->advanceOcclusion(s, 1), 1.0);
            renderer->drawFrame(s);
            EXPECT_EQ(renderer->atomAt(s, 20, 15, 4), 0u);
            s.debug = DebugView::patches;
            renderer->render(s);
        }
}

TEST(Frame, IsSplitByTheEnvironment) {
    const Representation r = scene("sample:dna", Style::spacefill);
    setenv("NACRE_NO_MERGE", "1", 1);
    ValidatedRenderer renderer(Visibility::encoded, ValidatedRenderer::fresh);
    unsetenv("NACRE_NO_MERGE");
    renderer->setScene(r);
    renderer->render(settings(r, 64, Projection::orthographic));
    EXPECT_EQ(renderer->planText().find("subpass 1"), std::string::npos) << renderer->planText();
    EXPECT_GT(renderer->stats().loadedBytes, 0u);
}

TEST(Frame, OfEncodedIsOneRenderPassAndOfFragdepthOneSubpass) {
    const Representation r = scene("sample:dna", Style::spacefill);
    const RenderSettings s = settings(r, 64, Projection::orthographic);
    {
        ValidatedRenderer renderer(Visibility::encoded, r);
        renderer->render(s);
        EXPECT_NE(renderer->planText().find("subpass 2 impostor colour: depth test, encoded depth input"),
                  std::string::npos)
            << renderer->planText();
        EXPECT_EQ(renderer->stats().loadedBytes, 0u);
        EXPECT_EQ(renderer->stats().storedBytes, 64u * 64u * 4u);
    }
    ValidatedRenderer renderer(Visibility::fragdepth, r);
    renderer->render(s);
    // Software devices test depth after the shader: plates would spare nothing.
    const char* passes =
        isSoftwareDevice() ? "subpass 0 impostor colour" : "subpass 0 opaque prepass + impostor colour";
    EXPECT_NE(renderer->planText().find(passes), std::string::npos) << renderer->planText();
    EXPECT_EQ(renderer->planText().find("subpass 1"), std::string::npos);
}

/// Specks one behind another in a few pixels of one bin: a list of all of them, gone through to its end.
Representation specks(std::size_t count) {
    Representation r;
    for (std::size_t i = 0; i < count; ++i) {
        const float along = static_cast<float>(i) / static_cast<float>(count);
        // The last, and farthest, stands beside the others, so that an end before it would show.
        const float aside = i + 1 == count ? 0.18f : 0.08f;
        r.spheres.push_back(
            {{aside + 0.02f * std::sin(40 * along), aside + 0.02f * std::cos(90 * along), 9 - 18 * along}, 0.02f});
        r.sphereLooks.push_back({0xff405060u + static_cast<std::uint32_t>(i % 100), static_cast<std::uint32_t>(i + 1)});
    }
    r.radius = 10;
    r.drawnAtoms = count;
    return r;
}

TEST(SamePicture, OfAsManyInOnePlaceAsLoopsHaveTurnsAndOfMore) {
    ValidatedRenderer tiles(Visibility::tiles), fragdepth(Visibility::fragdepth);
    for (const std::size_t count : {27900u, 28100u}) {
        const Representation r = specks(count);
        RenderSettings s = settings(r, 64, Projection::orthographic, {0, 0, 0}, 20);
        tiles->setScene(r);
        fragdepth->setScene(r);
        const LayerPicture a = fragdepth->layers(s), b = tiles->layers(s);
        EXPECT_EQ(a.id, b.id) << count;
        EXPECT_EQ(a.z, b.z) << count;
        EXPECT_EQ(tiles->planText().find("compute nearest primitive") == std::string::npos, count > 28000u);
        EXPECT_GT(std::count(b.id.begin(), b.id.end(), count), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamePicture,
                         testing::Values(Case{"sample:dna", Style::spacefill, Projection::orthographic},
                                         Case{"sample:dna", Style::ballAndStick, Projection::perspective},
                                         Case{"sample:glucose", Style::licorice, Projection::orthographic},
                                         Case{"1bna.pdb", Style::spacefill, Projection::perspective},
                                         Case{"4hhb.pdb", Style::spacefill, Projection::orthographic},
                                         Case{"4hhb.pdb", Style::ballAndStick, Projection::orthographic},
                                         Case{"neon-pump.pdb", Style::licorice, Projection::perspective}),
                         [](const auto& test) { return testName(test.param.file) + std::to_string(test.index); });

}  // namespace
}  // namespace nacre::test
