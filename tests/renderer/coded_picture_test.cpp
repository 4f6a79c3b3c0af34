// A picture coded at once has the bytes of one that is coded afterwards.

#include "engine/coded_picture.h"

#include "engine/error.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

struct CodedCase {
    const char* name;
    std::array<float, 4> background;
    std::uint32_t supersample = RenderSettings::kEdges;
    double halos = 0;
    int quarterTurns = 0;
    bool fine = false;
};
void PrintTo(const CodedCase& c, std::ostream* out) { *out << c.name; }

class CodedAtOnce : public SharedRenderers<CodedCase> {};

TEST_P(CodedAtOnce, HasTheBytesOfThePicture) {
    const CodedCase& c = GetParam();
    const Representation r = scene("sample:dna", Style::spacefill);
    RenderSettings s = settings(r, 120, Projection::perspective);
    s.view.height = 80;
    s.view.quarterTurns = c.quarterTurns;
    s.background = c.background;
    s.supersample = c.supersample;
    s.effects.halos.width = c.halos;
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        SCOPED_TRACE(static_cast<int>(path));
        ValidatedRenderer& renderer = sharedRenderer(path, r);
        const Picture picture = renderer->render(s);
        const std::uint64_t covered = renderer->stats().coveredPixels;
        s.fine = c.fine;  // which 8 bits do not hold
        for (const bool alpha : {true, false}) {
            const CodedPicture codes = renderer->renderCoded(s, alpha), wanted = coded(picture, alpha);
            EXPECT_EQ(codes.width, picture.width);
            EXPECT_EQ(codes.height, picture.height);
            EXPECT_EQ(codes.alpha, alpha);
            EXPECT_EQ(renderer->stats().coveredPixels, covered);
            ASSERT_EQ(codes.bytes.size(), std::size_t{picture.width} * picture.height * (alpha ? 4 : 3));
            EXPECT_TRUE(codes.bytes == wanted.bytes);
        }
        s.fine = false;
    }
}

INSTANTIATE_TEST_SUITE_P(Pictures, CodedAtOnce,
                         testing::Values(CodedCase{"opaque", {0.2f, 0.3f, 0.9f, 1.0f}},
                                         CodedCase{"half_open", {0.2f, 0.3f, 0.9f, 0.5f}},
                                         CodedCase{"open", {1, 1, 1, 0}, RenderSettings::kEdges, 0, 1},
                                         CodedCase{"single_samples", {1, 1, 1, 0}, 1, 0, 0, true},
                                         CodedCase{"four_samples", {1, 1, 1, 0.7f}, 2},
                                         CodedCase{"halos", {1, 1, 1, 1}, RenderSettings::kEdges, 5}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(PicturesInFlight, AreThoseOfOneAfterTheOther) {
    const Representation r = scene("sample:dna", Style::spacefill),
                         other = scene("sample:glucose", Style::ballAndStick);
    for (const Visibility path : {Visibility::tiles, Visibility::encoded}) {
        SCOPED_TRACE(static_cast<int>(path));
        ValidatedRenderer renderer(path);
        std::vector<RenderSettings> all;
        for (int i = 0; i < 9; ++i) {
            RenderSettings s = settings(r, 90 + 6 * static_cast<std::uint32_t>(i), Projection::perspective);
            s.occlusion.directions = i < 3 ? 4 : i < 6 ? 8 : 0;  // the bake changes beneath pictures in flight
            s.occlusion.detail = 8;
            s.effects.halos.width = i == 4 ? 5 : 0;  // takes more than one frame
            s.supersample = i == 7 ? 2 : i == 8 ? 1 : RenderSettings::kEdges;
            all.push_back(s);
        }
        const auto pickScene = [&](std::size_t i) -> const Representation& { return i == 5 ? other : r; };
        std::vector<CodedPicture> wanted, drawn;
        for (std::size_t i = 0; i < all.size(); ++i) {
            renderer->setScene(pickScene(i));
            wanted.push_back(renderer->renderCoded(all[i], true));
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i == 0 || &pickScene(i) != &pickScene(i - 1)) renderer->setScene(pickScene(i));
            renderer->startCoded(all[i], true);
            if (renderer->started() > 2) drawn.push_back(renderer->finishCoded());
        }
        EXPECT_EQ(renderer->started(), 2u);
        while (renderer->started() > 0) drawn.push_back(renderer->finishCoded());
        ASSERT_EQ(drawn.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_TRUE(drawn[i].bytes == wanted[i].bytes) << i;
    }
}

TEST(PicturesInFlight, AFailureGivesThemUp) {
    const Representation r = scene("sample:dna", Style::spacefill);
    ValidatedRenderer renderer(Visibility::tiles, r);
    RenderSettings s = settings(r, 64, Projection::orthographic);
    EXPECT_THROW(renderer->finishCoded(), Error) << "none is started";
    renderer->startCoded(s, true);
    s.view.width = renderer->maxSize() + 1;
    EXPECT_THROW(renderer->startCoded(s, true), Error);
    EXPECT_EQ(renderer->started(), 0u);
    s.view.width = 64;
    renderer->startCoded(s, true);
    EXPECT_TRUE(renderer->finishCoded().bytes == renderer->renderCoded(s, true).bytes);
}

}  // namespace
}  // namespace nacre::test
