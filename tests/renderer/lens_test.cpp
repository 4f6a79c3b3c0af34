// Depth of field against the mean of many pictures through points of the lens, and what it must never do.

#include "engine/frame/effects/lens/lens.h"

#include <algorithm>
#include <cmath>

#include "engine/frame/finer_places.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kLensPixels = 192;

RenderSettings lensSettings(const Representation& r, Projection projection, double strength, double focus) {
    RenderSettings s = settings(r, kLensPixels, projection);
    s.fine = true;
    s.effects.depthOfField = {strength, focus};
    return s;
}

/// The mean of pictures through points that are evenly spread over the lens.
std::vector<float> meanThroughLens(Renderer& renderer, RenderSettings s, int points) {
    const RenderSettings lens = s;
    s.effects.depthOfField = {};
    std::vector<float> sum;
    for (int i = 0; i < points; ++i) {
        const double away = std::sqrt((i + 0.5) / points), angle = 2.399963 * i;
        s.view = throughLens(lens, lens.view, away * glm::dvec2(std::cos(angle), std::sin(angle)));
        const Picture one = renderer.render(s);
        sum.resize(one.rgba.size());
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += one.rgba[k] / static_cast<float>(points);
    }
    return sum;
}

double codedLight(float linear) { return std::pow(std::clamp(linear, 0.0f, 1.0f), 1 / 2.2); }

/// Signal to noise of two pictures, dB.
double lensDecibels(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += std::pow(codedLight(a[k]) - codedLight(b[k]), 2);
    return -10 * std::log10(sum / static_cast<double>(a.size()));
}

class Lens : public SharedRenderers<Projection> {};

TEST_P(Lens, IsTheMeanOfPicturesThroughIt) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    for (const double strength : {0.05, 0.15})
        for (const double focus : {-0.5 * r.radius, 0.0}) {
            RenderSettings s = lensSettings(r, GetParam(), strength, focus);
            s.supersample = RenderSettings::kEdges;
            const std::vector<float> blurred = renderer->render(s).rgba;
            const std::vector<float> mean = meanThroughLens(*renderer.operator->(), s, 100);
            s.effects.depthOfField = {};
            const double off = lensDecibels(renderer->render(s).rgba, mean), on = lensDecibels(blurred, mean);
            EXPECT_GT(on, 36) << strength << ", " << focus;
            EXPECT_GT(on, off + 0.5) << strength << ", " << focus;
        }
}

TEST_P(Lens, ShowsTheSamePictureOnEveryPath) {
    for (const Style style : {Style::spacefill, Style::cartoon}) {
        const Representation r = scene("sample:dna", style);
        RenderSettings s = lensSettings(r, GetParam(), 0.1, -0.4 * r.radius);
        s.background = {0.2f, 0.3f, 0.9f, 0.5f};
        s.effects.contours.width = 2;
        std::vector<float> first;
        for (const Visibility path : devicePaths()) {
            ValidatedRenderer& renderer = sharedRenderer(path, r);
            const std::vector<float> picture = renderer->render(s).rgba;
            EXPECT_EQ(renderer->stats().frames, 2u);
            if (first.empty()) first = picture;
            EXPECT_EQ(picture, first) << visibilityName(path);
        }
    }
}

TEST_P(Lens, ReadsTheImageThatAllPathsAndSamplesEndIn) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const double halos : {0.0, 4.0})
        for (const std::uint32_t samples : {2u, RenderSettings::kEdges}) {
            RenderSettings s = lensSettings(r, GetParam(), 0.1, -0.4 * r.radius);
            s.fine = false;
            s.supersample = samples;
            s.effects.halos.width = halos;
            std::vector<float> first;
            for (const Visibility path : devicePaths()) {
                ValidatedRenderer& renderer = sharedRenderer(path, r);
                const std::vector<float> picture = renderer->render(s).rgba;
                EXPECT_EQ(renderer->planText().find("upload"), std::string::npos);
                if (first.empty()) first = picture;
                EXPECT_GT(lensDecibels(picture, first), 40) << visibilityName(path) << ", " << samples << ", " << halos;
            }
        }
}

TEST_P(Lens, ReadsTheImageThatAFrameDrawsTo) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const Visibility path : {Visibility::encoded, Visibility::fragdepth}) {
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        RenderSettings s = lensSettings(r, GetParam(), 0.1, 0);
        s.tuning.timePasses = true;
        renderer->render(s);
        EXPECT_FALSE(renderer->stats().passTimes.empty());
        for (const PassTime& time : renderer->stats().passTimes) EXPECT_NE(time.name, "picture");  // no copy of it
    }
}

TEST_P(Lens, AddsSamplesOnlyWhereItIsSharp) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        for (const double halos : {0.0, 4.0}) {
            if (halos == 0 && path == Visibility::tiles) continue;  // draws its edges in one frame
            RenderSettings s = lensSettings(r, GetParam(), 0.1, -r.radius - 40);
            s.fine = false;
            s.effects.halos.width = halos;
            const auto decibels = [&] {
                s.supersample = 4;
                const std::vector<float> exact = renderer->render(s).rgba;
                s.supersample = RenderSettings::kEdges;
                return lensDecibels(renderer->render(s).rgba, exact);
            };
            EXPECT_GT(decibels(), 42) << visibilityName(path) << ", " << halos;
            EXPECT_EQ(renderer->stats().frames, 3u);  // the picture, distances, and the lens
            s.effects.depthOfField.focus = -0.4 * r.radius;
            EXPECT_GT(decibels(), 40) << visibilityName(path) << ", " << halos;
            EXPECT_EQ(renderer->stats().frames, 4u);
        }
    }
}

TEST(LensPlaces, AreSharpWithinPixelsOfWhatTheLensShowsSharp) {
    constexpr std::uint32_t kAcross = 20, kDown = 10;
    std::vector<float> distances(std::size_t{kAcross} * kDown, kNoDistance);
    for (std::size_t i = 0; i < std::size_t{kAcross} * kDown; ++i) {
        if (i % kAcross >= 10) distances[i] = i == 5 * kAcross + 15 ? 20 : 30;
    }
    passes::Lens lens;
    lens.focus = 20;
    lens.pixels = 0.5f;
    const std::vector<std::uint8_t> sharp = sharpPlaces(distances.data(), {kAcross, kDown}, lens, 0);
    const auto at = [&](int x, int y) { return sharp[static_cast<std::size_t>(y) * kAcross + x] != 0; };
    EXPECT_TRUE(at(15, 5) && at(14, 4) && at(16, 6));  // beside what is at the focus
    EXPECT_FALSE(at(13, 5) || at(17, 5) || at(15, 3) || at(15, 7));
    EXPECT_FALSE(at(9, 5));  // beside what is blurred
    EXPECT_TRUE(at(8, 5));   // something smaller than the frame's pixels may be there
}

TEST(LensPlaces, LieInNarrowBands) {
    constexpr std::uint32_t kSide = 128;
    std::vector<std::uint32_t> seen(std::size_t{kSide} * kSide);
    seen[20 * kSide + 5] = seen[100 * kSide + 120] = 0xffffffffu;
    const FinerPlaces places(seen.data(), kSide, {kSide, kSide});
    const std::vector<PictureRect> bands = places.bandsIn({0, 0, kSide, kSide});
    ASSERT_EQ(bands.size(), 2u);
    const auto [x, y, width, height] = bands[1];
    EXPECT_LE(x, 119u);
    EXPECT_LE(y, 99u);
    EXPECT_GE(x + width, 122u);
    EXPECT_GE(y + height, 102u);
    EXPECT_LT(bands[0].width + bands[1].width, 40u);
}

TEST(LensPlaces, AreBlurredAroundWhatIsShown) {
    constexpr std::uint32_t kBin = TileBins::kPixels;
    passes::Lens lens;
    lens.most = 8;
    lens.rim = 2;
    const TileBins::Span spans[] = {{3, 2, 6, 3}, {2, 6, 4, 7}};
    const auto at = [](const std::vector<PictureRect>& parts, std::uint32_t y) {
        const auto found =
            std::ranges::find_if(parts, [&](const PictureRect& p) { return p.y <= y && y < p.y + p.height; });
        return found == parts.end() ? PictureRect{} : *found;
    };
    const std::vector<PictureRect> parts = blurredBy(lens, spans, {120, 200});
    EXPECT_EQ(at(parts, 2 * kBin).x, 3 * kBin - 16);
    EXPECT_EQ(at(parts, 2 * kBin).x + at(parts, 2 * kBin).width, 6 * kBin + 16);
    EXPECT_EQ(at(parts, 6 * kBin).x, 2 * kBin - 16);
    EXPECT_EQ(at(parts, 7 * kBin).x + at(parts, 7 * kBin).width, 4 * kBin + 16);  // below what is shown
    EXPECT_GT(at(parts, kBin).width, 0u);                                         // and above
    EXPECT_EQ(at(parts, 10 * kBin).width, 0u);
    for (const PictureRect& part : blurredBy(lens, spans, {100, 100})) EXPECT_LE(part.x + part.width, 100u);
    EXPECT_TRUE(blurredBy(lens, {}, {100, 200}).empty());
}

TEST_P(Lens, KeepsWhatIsBlurredInPlace) {
    Representation r;
    r.spheres.push_back({{2, -1, 4}, 6});
    r.sphereLooks.push_back({0xffffffffu, 1});
    r.radius = 12;
    RenderSettings s = lensSettings(r, GetParam(), 0, -r.radius);
    s.background = {0, 0, 0, 0};
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const auto middle = [&] {
        const std::vector<float> picture = renderer->render(s).rgba;
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < picture.size() / 4; ++i)
            sum += static_cast<double>(picture[4 * i + 3]) * glm::dvec3(i % kLensPixels, i / kLensPixels, 1);
        return glm::dvec2(sum) / sum.z;
    };
    const glm::dvec2 sharp = middle();
    s.effects.depthOfField.strength = 0.3;
    const glm::dvec2 blurred = middle();
    EXPECT_LT(glm::length(sharp - blurred), 0.1);
    EXPECT_NE(sharp, blurred);
    EXPECT_NE(renderer->planText().find("large circles"), std::string::npos);
}

TEST_P(Lens, ShowsNoGrain) {
    Representation r;
    r.spheres.push_back({{0, 0, 0}, 6});
    r.sphereLooks.push_back({0xffffffffu, 1});
    r.radius = 12;
    RenderSettings s = lensSettings(r, GetParam(), 0.5, -2 * r.radius);
    s.background = {0, 0, 0, 1};
    s.lighting = false;
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const std::vector<float> picture = renderer->render(s).rgba;
    float grain = 0, most = 0, least = 1;
    for (std::size_t i = 1; i + 1 < picture.size() / 4; ++i) {
        grain = std::max(grain, std::abs(picture[4 * i - 4] - 2 * picture[4 * i] + picture[4 * i + 4]));
        most = std::max(most, picture[4 * i]), least = std::min(least, picture[4 * i]);
    }
    EXPECT_GT(most - least, 0.5f);
    EXPECT_LT(grain, 0.12f);  // of one pixel beside its neighbours
}

TEST_P(Lens, CostsNothingWhenOff) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    RenderSettings s = lensSettings(r, GetParam(), 0, -5);
    const std::vector<float> off = renderer->render(s).rgba;
    EXPECT_EQ(renderer->stats().frames, 1u);
    EXPECT_EQ(renderer->planText().find("circles"), std::string::npos);
    s.effects.depthOfField = {};
    EXPECT_EQ(off, renderer->render(s).rgba);
    s.effects.depthOfField.strength = 0.1;
    EXPECT_NE(off, renderer->render(s).rgba);
    EXPECT_NE(renderer->planText().find("circles"), std::string::npos);
}

TEST_P(Lens, ShinesNothingBlurredOverWhatIsSharpAndNearer) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    RenderSettings s = lensSettings(r, GetParam(), 0, 0);
    const LayerPicture layers = renderer->layers(s);
    const std::vector<float> sharp = renderer->render(s).rgba;
    const double front = *std::min_element(layers.z.begin(), layers.z.end());
    const double center = s.view.projection == Projection::perspective ? s.view.eyeDistance : s.view.radius;
    s.effects.depthOfField = {0.5, front - center};  // nothing is before the focus
    const std::vector<float> blurred = renderer->render(s).rgba;
    const passes::Lens lens = makeLens(s, s.view);
    int same = 0, changed = 0;
    for (std::size_t i = 0; i < layers.z.size(); ++i) {
        const bool is = std::equal(&sharp[4 * i], &sharp[4 * i] + 4, &blurred[4 * i]);
        const float z = layers.z[i];
        const float radius = lens.pixels * std::abs(z - lens.focus) / (lens.perspective > 0 ? z : 1);
        if (radius < 0.59f) {
            EXPECT_TRUE(is) << i;
            ++same;
        }
        changed += !is;
    }
    EXPECT_GT(same, 20);
    EXPECT_GT(changed, 3000);
}

TEST_P(Lens, LeavesNoHardEdgeOfWhatIsBlurred) {
    Representation r;
    const auto add = [&](glm::vec3 center, float radius, std::uint32_t color) {
        r.spheres.push_back({center, radius});
        r.sphereLooks.push_back({color, static_cast<std::uint32_t>(r.spheres.size())});
    };
    add({0, 0, 10}, 3, 0xff0000ffu);    // before the focus
    for (int x = -20; x <= 20; x += 2)  // a wall, which is sharp
        for (int y = -20; y <= 20; y += 2) add({x, y, -10}, 3, 0xffffffffu);
    r.radius = 35;
    RenderSettings s = lensSettings(r, GetParam(), 0.5, 7);
    s.view.rotation = glm::dmat3(1);
    s.view.pixelsPerAngstrom *= 2;
    s.lighting = false;
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    const auto steepest = [&] {
        const std::vector<float> picture = renderer->render(s).rgba;
        float step = 0;
        for (std::size_t x = 1; x < kLensPixels / 2; ++x) {
            const std::size_t at = 4 * (kLensPixels / 2 * kLensPixels + x) + 2;  // blue, which one of them has
            step = std::max(step, std::abs(picture[at] - picture[at - 4]));
        }
        return step;
    };
    EXPECT_LT(steepest(), 0.25f);
    s.effects.depthOfField = {};
    EXPECT_GT(steepest(), 0.9f);
}

TEST_P(Lens, BlursWhatIsTransparentAsWhatLiesOnABackground) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer& renderer = sharedRenderer(Visibility::tiles, r);
    RenderSettings s = lensSettings(r, GetParam(), 0.1, 0);
    const std::vector<float> onWhite = renderer->render(s).rgba;
    s.background = {0, 0, 0, 0};
    const std::vector<float> alone = renderer->render(s).rgba;
    float most = 0;
    int partly = 0;
    for (std::size_t i = 0; i < alone.size(); i += 4) {
        partly += alone[i + 3] > 0.1f && alone[i + 3] < 0.9f;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(alone[i + c] + 1 - alone[i + 3] - onWhite[i + c]));
    }
    EXPECT_LT(most, 1e-5f);
    EXPECT_GT(partly, 300);
}

INSTANTIATE_TEST_SUITE_P(Views, Lens, testing::Values(Projection::orthographic, Projection::perspective),
                         [](const auto& p) { return p.param == Projection::perspective ? "perspective" : "parallel"; });

}  // namespace
}  // namespace nacre::test
