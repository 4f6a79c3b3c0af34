// GPUs that store vertex outputs get few of them: the fragment stage fetches the rest of a primitive, and draws the
// same as where all of it is passed on, to the last bits of a float.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

std::vector<Visibility> paths() {
    if (std::string_view(std::getenv("NACRE_PHONE")) == "mali") return {Visibility::rasterOrder, Visibility::encoded};
    return {Visibility::encoded, Visibility::fragdepth};
}

/// Frames that count fragments pass records on.
void expectTheSame(const Representation& r, RenderSettings s) {
    s.supersample = 1;
    s.fine = true;
    for (const Visibility path : paths()) {
        SCOPED_TRACE(visibilityName(path));
        ValidatedRenderer renderer(path, r);
        s.tuning.countFragments = false;
        const Picture fetched = renderer->render(s);
        EXPECT_TRUE(renderer->stats().storesVaryings);
        s.tuning.countFragments = true;
        const Picture passed = renderer->render(s);
        ASSERT_EQ(fetched.rgba.size(), passed.rgba.size());
        float furthest = 0;
        for (std::size_t i = 0; i < fetched.rgba.size(); ++i)
            furthest = std::max(furthest, std::abs(fetched.rgba[i] - passed.rgba[i]));
        EXPECT_LT(furthest, 5e-7f);
    }
}

TEST(Fetched, PrimitivesAreThoseThatArePassedOn) {
    for (const Style style : {Style::spacefill, Style::ballAndStick, Style::cartoon})
        for (const std::uint32_t directions : {0u, 4u}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(style) << " " << directions);
            const Representation r = scene(style == Style::cartoon ? "sample:dna" : "sample:glucose", style);
            RenderSettings s = settings(r, 160, directions ? Projection::perspective : Projection::orthographic);
            s.occlusion.directions = directions;
            expectTheSame(r, s);
        }
}

TEST(Fetched, EveryByteOfAColourIsDecodedAlike) {
    Representation r = scene("sample:dna", Style::spacefill);
    for (std::size_t i = 0; i < r.sphereLooks.size(); ++i) {
        const auto byte = static_cast<std::uint32_t>(i & 0xffu);
        r.sphereLooks[i].color = 0xff000000u | byte | (byte ^ 0x55u) << 8 | (255u - byte) << 16;
    }
    RenderSettings s = settings(r, 256, Projection::orthographic);
    s.occlusion.directions = 0;
    expectTheSame(r, s);
}

TEST(Fetched, OtherColoursReachWhatIsFetched) {
    const Representation before = scene("sample:glucose", Style::spacefill);
    Representation after = before;
    for (SphereLook& look : after.sphereLooks) look.color ^= 0xffffffu;
    RenderSettings s = settings(before, 96, Projection::orthographic);
    s.occlusion.directions = 0;
    s.supersample = 1;
    for (const Visibility path : paths()) {
        SCOPED_TRACE(visibilityName(path));
        ValidatedRenderer fresh(path), renderer(path);
        fresh->setScene(after);
        renderer->setScene(before);
        const Picture first = renderer->render(s);
        EXPECT_TRUE(renderer->setScene(after)) << "not colours alone";
        const Picture second = renderer->render(s);
        EXPECT_TRUE(renderer->stats().storesVaryings);
        EXPECT_FALSE(first.rgba == second.rgba);
        EXPECT_TRUE(second.rgba == fresh->render(s).rgba);
    }
}

TEST(Fetched, CopiesTintTheirColours) {
    Molecule m = molecule("sample:glucose");
    addCopies(m, {{9, 0, 0}, {0, 9, 0}});
    RepresentationOptions options{.style = Style::spacefill, .color = ColorScheme::copy, .assembly = "1"};
    const Representation r = represent(m, drawnAtoms(m), options);
    ASSERT_GT(r.copies.colors.size(), 1u);
    expectTheSame(r, settings(r, 128, Projection::orthographic));
}

}  // namespace
}  // namespace nacre::test
