// Four samples of a pixel in one fragment, resolved in the render pass: exact coverage, nearer to a picture of many
// samples, and nothing else of the renderer changes by it.

#include <cmath>

#include "engine/error.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

/// "Standard sample locations" of the Vulkan specification, from the pixel's middle.
constexpr glm::dvec2 kPlaces[] = {{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}};

/// A validated renderer whose pictures of one sample have four.
class Multisampled {
public:
    explicit Multisampled(Visibility path) : renderer_(makeOptions(path)) {}
    ~Multisampled() {
        for (const std::string& message : renderer_.validationMessages()) ADD_FAILURE() << message;
    }
    Renderer* operator->() { return &renderer_; }

    static DeviceOptions makeOptions(Visibility path) {
        DeviceOptions options{.validate = true, .visibility = path, .multisampling = Multisampling::four};
        return options;
    }

private:
    Renderer renderer_;
};

/// Peak signal-to-noise ratio in dB, of sRGB-coded colour over white.
double decibels(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        for (std::size_t c = i; c < i + 3; ++c) {
            const double d = coded(a.rgba[c]) - coded(b.rgba[c]);
            sum += d * d;
        }
    return 10 * std::log10(static_cast<double>(a.rgba.size()) * 0.75 / sum);
}

struct SampledCase {
    const char* file;
    Style style;
    Projection projection;
    double better;  ///< dB over one sample per pixel
    bool clip = false;
    int turns = 0;
};
void PrintTo(const SampledCase& c, std::ostream* out) {
    *out << c.file << " style " << static_cast<int>(c.style) << (c.clip ? " clip" : "") << " turns " << c.turns;
}

/// Paths that take several samples, on drivers that have them.
class FourSamples : public SharedRenderers<SampledCase> {
protected:
    static Multisampled& sampled(Visibility path) {
        static std::map<Visibility, std::unique_ptr<Multisampled>> made;
        std::unique_ptr<Multisampled>& renderer = made[path];
        if (!renderer) renderer = std::make_unique<Multisampled>(path);
        return *renderer;
    }
    static RenderSettings wanted(const Representation& r, std::uint32_t size) {
        const SampledCase& c = GetParam();
        RenderSettings s = settings(r, size, c.projection, {75, -40, 120});
        if (c.clip) s.effects.clip.near = 0, s.effects.clip.cap = Clip::Cap::dark;
        s.view.quarterTurns = c.turns;
        return s;
    }
};
constexpr Visibility kSampledPaths[] = {Visibility::fragdepth};  // software devices have no room for raster-order

TEST_P(FourSamples, IsNearerToSixteenSamples) {
    const Representation r = scene(GetParam().file, GetParam().style);
    RenderSettings s = wanted(r, 160);
    for (const Visibility path : kSampledPaths) {
        SCOPED_TRACE(visibilityName(path));
        ValidatedRenderer& plain = sharedRenderer(path, r);
        const Picture one = plain->render(s);
        RenderSettings fine = s;
        fine.supersample = 4;
        const Picture sixteen = plain->render(fine);
        Multisampled& renderer = sampled(path);
        renderer->setScene(r);
        const Picture four = renderer->render(s);
        EXPECT_EQ(renderer->stats().samples, 4u);
        EXPECT_EQ(renderer->stats().frames, 1u);
        EXPECT_GT(decibels(four, sixteen), decibels(one, sixteen) + GetParam().better);
        RecordProperty(std::string(visibilityName(path)) + "_dB",
                       std::to_string(decibels(one, sixteen)) + " " + std::to_string(decibels(four, sixteen)));
    }
}

/// The oracle is the renderer itself, by four pictures of one sample whose pixels stand where the samples do.
TEST_P(FourSamples, CoversTheSamplesThatPicturesThereCover) {
    const Representation r = scene(GetParam().file, GetParam().style);
    RenderSettings s = wanted(r, 96);
    s.background = {0, 0, 0, 0};
    if (s.view.quarterTurns != 0) GTEST_SKIP() << "pictures are upright";
    for (const Visibility path : kSampledPaths) {
        SCOPED_TRACE(visibilityName(path));
        ValidatedRenderer& plain = sharedRenderer(path, r);
        const Picture middle = plain->render(s);
        std::vector<float> coverage(middle.rgba.size() / 4);
        for (const glm::dvec2& place : kPlaces) {
            RenderSettings there = s;
            there.view.pan += glm::dvec2(-place.x, place.y) / s.view.pixelsPerAngstrom;
            const Picture one = plain->render(there);
            for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] += one.rgba[4 * i + 3] / 4;
        }
        Multisampled& renderer = sampled(path);
        renderer->setScene(r);
        const Picture four = renderer->render(s);
        std::size_t edges = 0, others = 0;
        for (std::size_t i = 0; i < coverage.size(); ++i) {
            edges += coverage[i] > 0 && coverage[i] < 1;
            others += std::abs(four.rgba[4 * i + 3] - coverage[i]) > 0.01f;
        }
        EXPECT_GT(edges, 100u);
        // The view moves by floats: a sample that a silhouette meets may fall on either side.
        EXPECT_LE(others, edges / 200);
    }
}

TEST_P(FourSamples, PlatesChangeNothing) {
    const Representation r = scene(GetParam().file, GetParam().style);
    RenderSettings s = wanted(r, 128);
    for (const Visibility path : kSampledPaths) {
        SCOPED_TRACE(visibilityName(path));
        Multisampled& renderer = sampled(path);
        renderer->setScene(r);
        s.tuning.plates = PlateShape::none;
        const Picture without = renderer->render(s);
        for (const PlateShape plates : {PlateShape::square, PlateShape::octagon, PlateShape::dome3})
            for (const ImpostorShape impostor :
                 {ImpostorShape::square, ImpostorShape::octagon, ImpostorShape::pyramid}) {
                s.tuning.plates = plates;
                s.tuning.impostor = impostor;
                EXPECT_TRUE(renderer->render(s).rgba == without.rgba)
                    << static_cast<int>(plates) << " " << static_cast<int>(impostor);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, FourSamples,
    testing::Values(SampledCase{"sample:dna", Style::spacefill, Projection::orthographic, 2},
                    SampledCase{"sample:dna", Style::licorice, Projection::perspective, 2},
                    SampledCase{"sample:glucose", Style::ballAndStick, Projection::orthographic, 2},
                    SampledCase{"sample:dna", Style::cartoon, Projection::perspective, 2},
                    SampledCase{"sample:glucose", Style::spacefill, Projection::perspective, 2, true},
                    SampledCase{"sample:dna", Style::spacefill, Projection::orthographic, 2, false, 1}),
    [](const auto& test) { return testName(test.param.file) + "_" + std::to_string(test.index); });

TEST(MultisamplingOf, PicturesOfMoreSamplesAndLayersIsNone) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer plain(Visibility::fragdepth);
    Multisampled sampled(Visibility::fragdepth);
    plain->setScene(r);
    sampled->setScene(r);
    RenderSettings s = settings(r, 96, Projection::orthographic);
    EXPECT_FALSE(sampled->render(s).rgba == plain->render(s).rgba);
    for (const std::uint32_t samples : {RenderSettings::kEdges, 2u}) {
        s.supersample = samples;
        EXPECT_TRUE(sampled->render(s).rgba == plain->render(s).rgba) << samples;
    }
    EXPECT_TRUE(sampled->layers(s).rgba == plain->layers(s).rgba);
    EXPECT_EQ(sampled->atomAt(s, 48, 48, 5), plain->atomAt(s, 48, 48, 5));
}

TEST(MultisamplingOf, NothingLeavesTheTileButThePicture) {
    for (const Visibility path : kSampledPaths) {
        Multisampled renderer(path);
        const Representation r = scene("sample:glucose", Style::ballAndStick);
        renderer->setScene(r);
        renderer->render(settings(r, 64, Projection::orthographic));
        const std::string& plan = renderer->planText();
        EXPECT_NE(plan.find("  colour samples  RGBA8 sRGB  clear  -"), std::string::npos) << plan;
        EXPECT_NE(plan.find("colour resolve"), std::string::npos) << plan;
        EXPECT_EQ(renderer->stats().loadedBytes, 0u);
        EXPECT_EQ(renderer->stats().storedBytes, 64u * 64 * 4);
        EXPECT_EQ(renderer->stats().tileBytesPerPixel, 16u);
    }
}

std::string catchError(Visibility path, const std::function<void(RenderSettings&)>& change = {}) {
    try {
        Multisampled renderer(path);
        const Representation r = scene("sample:glucose", Style::ballAndStick);
        RenderSettings s = settings(r, 64, Projection::orthographic);
        renderer->setScene(r);
        if (change) change(s);
        renderer->render(s);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(MultisamplingOf, WhatCannotTakeItSaysSo) {
    EXPECT_EQ(catchError(Visibility::fragdepth), "");
    for (const Visibility path : {Visibility::encoded, Visibility::deferred, Visibility::tiles})
        EXPECT_NE(catchError(path).find(std::string("--visibility ") + visibilityName(path)), std::string::npos)
            << catchError(path);
    const auto contours = [](RenderSettings& s) { s.effects.contours.width = 2; };
    EXPECT_NE(catchError(Visibility::fragdepth, contours).find("outlines"), std::string::npos);
    const auto fine = [](RenderSettings& s) { s.fine = true; };
    EXPECT_NE(catchError(Visibility::fragdepth, fine).find("16 bits per channel"), std::string::npos);
}

}  // namespace
}  // namespace nacre::test
