// The words of every refusal of the planner.

#include "tests/graph/plan_rules.h"

namespace nacre::graph {
namespace {

TEST_F(Rules, AReadBeforeItsWriterIsRefused) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("reader").samples(a).color(b, Clear{0.0f});
    g.graphics("writer").color(a, Clear{0.0f});
    g.output(b);
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': sample before pass 'writer', which writes it, is declared");
}
TEST_F(Rules, AReadOfWhatNobodyWritesIsRefused) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("reader").samples(a).color(b, Clear{0.0f});
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': sample of contents that no pass writes");
}
TEST_F(Rules, AnInputOfAnotherExtentIsRefused) {
    const Image a = g.image("a", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}), b = g.image("b", kColor);
    g.graphics("writer").color(a, Clear{0.0f});
    g.graphics("reader").color(b, Clear{0.0f}).input(a);
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': input attachment of 8x8 beside one of 100x50");
}
TEST_F(Rules, AStaleHandleIsRefused) {
    Graph other("other");
    const Image stranger = other.image("stranger", kColor);
    try {
        g.graphics("one").color(stranger);
        FAIL();
    } catch (const GraphError& error) {
        EXPECT_NE(std::string(error.what()).find("graph 'test', pass 'one': stale image handle"), std::string::npos);
    }
    EXPECT_THROW(g.output(stranger), GraphError);
    EXPECT_THROW(g.compute("two").reads(Buffer{}), GraphError);
}
TEST_F(Rules, ABudgetThatOnePassExceedsIsRefused) {
    const Image a = g.image("a", kWide), b = g.image("b", kWide), c = g.image("c", kColor);
    g.graphics("greedy").color(a).color(b).color(c);
    EXPECT_EQ(refusal(), "pass 'greedy': 20 bytes of colour per pixel exceed the tile budget of 'mali-old' (16)");
    caps.tileBytesPerPixel = 20;
    EXPECT_EQ(refusal(), "");
    caps.maxColorAttachments = 2;
    EXPECT_NE(refusal().find("pass 'greedy': 3 colour and 0 input attachments exceed"), std::string::npos);
}
TEST_F(Rules, AnImageUsedTwiceByOnePassIsRefused) {
    const Image a = g.importImage("a", kColor, kTexture);
    g.graphics("one").samples(a).color(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': used twice by one pass");
}
TEST_F(Rules, AVerbThatDoesNotGoWithThePassIsRefused) {
    const Image a = g.image("a", kColor);
    g.compute("one").color(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': 'write' does not go with this kind of pass");
}
TEST_F(Rules, AColourThatIsDepthIsRefused) {
    const Image a = g.image("a", kDepth);
    g.graphics("one").color(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': D32F cannot be a write attachment");
}
TEST_F(Rules, TwoImagesOfOneNameAreRefused) {
    g.image("a", kColor);
    g.image("a", kDepth);
    EXPECT_EQ(refusal(), "graph 'test', image 'a': two images of this name");
}
TEST_F(Rules, AnImageWithoutPixelsIsRefused) {
    g.image("a", {VK_FORMAT_R8G8B8A8_UNORM, {0, 5}});
    EXPECT_EQ(refusal(), "graph 'test', image 'a': no pixels (0x5)");
}
TEST_F(Rules, AGraphicsPassWithoutAttachmentsIsRefused) {
    g.graphics("one").writes(g.importBuffer("b", 4));
    EXPECT_EQ(refusal(), "pass 'one': a graphics pass needs an attachment");
}
TEST_F(Rules, RasterOrderIsRefusedWhereItIsMissing) {
    const Image a = g.image("a", kColor);
    g.graphics("one").ordered(a, Clear{0.0f});
    g.output(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': 'mali-old' cannot read an attachment in raster order");
    caps.rasterOrder = true;
    EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace nacre::graph
