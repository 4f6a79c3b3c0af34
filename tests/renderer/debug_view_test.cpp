// Debug views, held against the layers and the counters: what they show is what the frame works with.

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

constexpr std::uint32_t kSize = 80;
using Rgb = std::array<int, 3>;
constexpr Rgb kWhite{255, 255, 255};

/// A picture's bytes, as a PNG holds them.
std::vector<Rgb> toBytes(const Picture& picture) {
    std::vector<Rgb> bytes(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = picture.rgba[4 * i + c];
            bytes[i][c] = static_cast<int>(
                std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
        }
    return bytes;
}

std::vector<Rgb> show(ValidatedRenderer& renderer, RenderSettings s, DebugView view) {
    s.debug = view;
    return toBytes(renderer->render(s));
}

bool near(const Rgb& a, double r, double g, double b, double by) {
    return std::abs(a[0] - r) <= by && std::abs(a[1] - g) <= by && std::abs(a[2] - b) <= by;
}

/// The colour of a number of fragments in a pixel: seven for 1, 2, 4, .. 64, and those between.
Rgb heat(double fragments) {
    constexpr double kSteps[7][3] = {{0.20, 0.24, 0.56}, {0.13, 0.54, 0.62}, {0.43, 0.74, 0.35}, {0.98, 0.86, 0.25},
                                     {0.95, 0.52, 0.16}, {0.77, 0.10, 0.15}, {0.30, 0.00, 0.10}};
    const double at = std::log2(std::max(fragments, 1.0));
    const int low = std::min(static_cast<int>(at), 5);
    Rgb color{};
    for (std::size_t c = 0; c < 3; ++c)
        color[c] =
            static_cast<int>(std::lround(255 * (kSteps[low][c] + (at - low) * (kSteps[low + 1][c] - kSteps[low][c]))));
    return color;
}

int decodeFragments(const Rgb& color) {
    if (color == kWhite) return 0;
    for (int n = 1; n <= 64; ++n)
        if (const Rgb h = heat(n); near(color, h[0], h[1], h[2], 1)) return n;
    ADD_FAILURE() << "no number of fragments: " << color[0] << " " << color[1] << " " << color[2];
    return 0;
}

TEST(DebugView, ShowsTheLayersByEveryPath) {
    const Representation r = scene("sample:glucose", Style::ballAndStick);
    for (const Projection projection : {Projection::orthographic, Projection::perspective})
        for (const Visibility path : devicePaths()) {
            if (projection == Projection::perspective && path != Visibility::encoded) continue;
            ValidatedRenderer renderer(path, r);
            RenderSettings s = settings(r, kSize, projection);
            s.occlusion.directions = 4;
            const LayerPicture layers = renderer->layers(s);
            const auto depth = show(renderer, s, DebugView::depth), normals = show(renderer, s, DebugView::normals);
            const auto ids = show(renderer, s, DebugView::id), open = show(renderer, s, DebugView::occlusion);
            const double nearest = (projection == Projection::perspective ? s.view.eyeDistance : s.view.radius) -
                                   s.view.radius - 1;  // depth spans the bounding sphere and 1 Å before and behind it
            std::map<std::uint32_t, std::set<Rgb>> colors;
            std::size_t wrong = 0;
            for (std::size_t i = 0; i < layers.id.size(); ++i) {
                if (layers.id[i] == 0) {
                    wrong += depth[i] != kWhite || normals[i] != kWhite || ids[i] != kWhite || open[i] != kWhite;
                    continue;
                }
                const double d = 255 * (1 - (layers.z[i] - nearest) / (2 * (s.view.radius + 1)));
                wrong += !near(depth[i], d, d, d, 1);
                const float* n = &layers.normal[3 * i];
                wrong += !near(normals[i], 127.5 + 127.5 * n[0], 127.5 + 127.5 * n[1], 127.5 + 127.5 * n[2], 1);
                const double o = layers.occlusion[i];
                const double coded = 255 * (o <= 0.0031308 ? 12.92 * o : 1.055 * std::pow(o, 1 / 2.4) - 0.055);
                wrong += !near(open[i], coded, coded, coded, 1);
                colors[layers.id[i]].insert(ids[i]);
            }
            EXPECT_EQ(wrong, 0u);
            std::set<Rgb> all;
            for (const auto& [id, seen] : colors) {
                EXPECT_EQ(seen.size(), 1u) << id;
                all.insert(seen.begin(), seen.end());
            }
            EXPECT_EQ(all.size(), colors.size());
            EXPECT_GT(colors.size(), 15u);
        }
}

TEST(DebugView, OverdrawIsWhatTheCountersCount) {
    const Representation r = scene("sample:glucose", Style::spacefill);  // no pixel with more than 64
    ValidatedRenderer renderer(Visibility::encoded, r);
    for (const PlateShape plates : {PlateShape::none, PlateShape::octagon}) {
        RenderSettings s = settings(r, kSize, Projection::orthographic);
        s.tuning.plates = plates;
        s.tuning.countFragments = true;
        renderer->render(s);
        std::uint64_t counted = 0;
        for (const PassCount& pass : renderer->stats().passes)
            if (pass.name == "impostor colour") counted = pass.shadedFragments;
        s.tuning.countFragments = false;
        std::uint64_t shown = 0;
        const auto overdraw = show(renderer, s, DebugView::overdraw);
        for (const Rgb& color : overdraw) shown += static_cast<std::uint64_t>(decodeFragments(color));
        EXPECT_GT(counted, 4000u);
        EXPECT_EQ(shown, counted);

        const auto tiles = show(renderer, s, DebugView::tiles);
        for (std::uint32_t ty = 0; ty < kSize; ty += 16)
            for (std::uint32_t tx = 0; tx < kSize; tx += 16) {
                double sum = 0;
                std::size_t busy = 0;
                for (std::uint32_t y = ty; y < ty + 16; ++y)
                    for (std::uint32_t x = tx; x < tx + 16; ++x) {
                        const std::size_t at = std::size_t{y} * kSize + x;
                        sum += decodeFragments(overdraw[at]);
                        if (x > tx && y > ty && overdraw[at] != kWhite) busy = at;
                    }
                if (busy == 0) continue;
                const Rgb wanted = heat(sum / 256);
                EXPECT_TRUE(near(tiles[busy], wanted[0], wanted[1], wanted[2], 1)) << tx << " " << ty;
            }
    }
}

TEST(DebugView, PlatesAreThePictureWhereThePrepassCoversIt) {
    const Representation r = scene("sample:dna", Style::spacefill);
    for (const Visibility path : devicePaths()) {
        ValidatedRenderer renderer(path, r);
        RenderSettings s = settings(r, kSize, Projection::orthographic);
        s.tuning.plates = PlateShape::octagon;
        const auto picture = toBytes(renderer->render(s));
        const auto covered = [&] {
            const auto shown = show(renderer, s, DebugView::plates);
            std::size_t full = 0;
            for (std::size_t i = 0; i < shown.size(); ++i) {
                if (picture[i] == kWhite) {
                    EXPECT_EQ(shown[i], kWhite);
                } else if (shown[i] == picture[i]) {
                    ++full;
                } else {
                    for (std::size_t c = 0; c < 3; ++c) EXPECT_GE(shown[i][c], picture[i][c]);
                }
            }
            return full;
        };
        const std::size_t drawn = static_cast<std::size_t>(
            std::count_if(picture.begin(), picture.end(), [](auto& p) { return p != kWhite; }));
        const std::size_t octagons = covered();
        EXPECT_GT(octagons, drawn * 3 / 4);
        EXPECT_LT(octagons, drawn);
        s.tuning.plates = PlateShape::none;
        EXPECT_EQ(covered(), 0u);
    }
}

TEST(DebugView, EncodedIsTheAttachmentOnEveryRung) {
    const Representation r = scene("sample:glucose", Style::spacefill);
    const std::pair<EncodedDepth, int> rungs[] = {{EncodedDepth::r32f, 1},
                                                  {EncodedDepth::rgba16f, 4},
                                                  {EncodedDepth::rg16f, 2},
                                                  {EncodedDepth::a2b10g10r10, 3},
                                                  {EncodedDepth::rgba8, 4}};
    for (const auto& [rung, channels] : rungs) {
        DeviceOptions options{true, "", Visibility::fragdepth, rung};  // the view draws it on any path
        Renderer renderer(options);
        renderer.setScene(r);
        RenderSettings s = settings(r, kSize, Projection::orthographic);
        const LayerPicture layers = renderer.layers(s);
        s.debug = DebugView::encoded;
        const auto shown = toBytes(renderer.render(s));
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const double d = (layers.z[i] + 1) / (2 * (s.view.radius + 1));
            Rgb wanted{};
            for (int c = 0; c < 3; ++c) {
                const double step = channels == 1 ? d : c < channels ? std::clamp(d * channels - c, 0.0, 1.0) : 0.0;
                wanted[static_cast<std::size_t>(c)] = static_cast<int>(std::lround(255 * step));
            }
            if (layers.id[i] == 0) wanted = channels == 2 ? Rgb{255, 255, 0} : kWhite;
            wrong += !near(shown[i], wanted[0], wanted[1], wanted[2], 1.6);
        }
        EXPECT_EQ(wrong, 0u) << channels;
        for (const std::string& message : renderer.validationMessages()) ADD_FAILURE() << message;
    }
}

TEST(DebugView, PatchesAreTheAtlasAndFollowTheView) {
    Representation lone;
    lone.spheres = {{{0, 0, 0}, 1.7f}};
    lone.sphereLooks = {{0xff000000u, 0}};
    lone.radius = 1.7;
    ValidatedRenderer renderer(Visibility::encoded, lone);
    RenderSettings s = settings(lone, kSize, Projection::orthographic);
    s.occlusion.directions = 64;
    s.background = {0, 0, 1, 1};
    const auto count = [&] {
        std::size_t open = 0;
        for (const Rgb& p : show(renderer, s, DebugView::patches)) {
            if (p == Rgb{0, 0, 255}) continue;
            EXPECT_TRUE(p == kWhite || p == Rgb{}) << p[0];  // nothing stands in a lone sphere's light; no patch: 0
            open += p == kWhite;
        }
        return open;
    };
    s.view.pixelsPerAngstrom /= 2;  // all of it is in sight
    const std::size_t whole = count();
    EXPECT_GT(whole, 300u);
    s.view.pixelsPerAngstrom /= 2;
    EXPECT_NEAR(static_cast<double>(count()), static_cast<double>(whole) / 4, 0.05 * static_cast<double>(whole));
}

}  // namespace
}  // namespace nacre::test
