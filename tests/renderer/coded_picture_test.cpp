// A picture coded at once has the bytes of one that is coded afterwards.

#include "engine/coded_picture.h"

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
        ValidatedRenderer& renderer = rendererOf(path);
        renderer->setScene(r);
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

}  // namespace
}  // namespace nacre::test
