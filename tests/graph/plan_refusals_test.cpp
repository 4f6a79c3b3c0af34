// The words of every refusal of the planner.

#include "tests/graph/plan_rules.h"
#include "tests/support/error_text.h"

namespace nacre::graph {
namespace {

TEST_F(Rules, AReadBeforeItsWriterIsRefused) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("reader").samples(a).color(b, Clear{0.0f});
    g.graphics("writer").color(a, Clear{0.0f});
    g.output(b);
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': sample before pass 'writer', which writes it, is declared");
}
TEST_F(Rules, AReadOfWhatNobodyWritesIsRefused) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("reader").samples(a).color(b, Clear{0.0f});
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': sample of contents that no pass writes");
}
TEST_F(Rules, AnInputOfAnotherExtentIsRefused) {
    Image a = g.image("a", {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}), b = g.image("b", kColor);
    g.graphics("writer").color(a, Clear{0.0f});
    g.graphics("reader").color(b, Clear{0.0f}).input(a);
    EXPECT_EQ(refusal(), "pass 'reader', image 'a': input attachment of 8x8 beside one of 100x50");
}
TEST_F(Rules, AStaleHandleIsRefused) {
    Graph other("other");
    Image stranger = other.image("stranger", kColor);
    test::expectThrows<GraphError>([&] { g.graphics("one").color(stranger); }, "stale image handle");
    EXPECT_THROW(g.output(stranger), GraphError);
    EXPECT_THROW(g.compute("two").reads(Buffer{}), GraphError);
}
TEST_F(Rules, AHandleFromBeforeAWriteIsRefused) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    const Image before = a;
    g.graphics("writer").color(a, Clear{0.0f});
    try {
        g.graphics("reader").samples(before).color(b, Clear{0.0f});
        FAIL();
    } catch (const GraphError& error) {
        const std::string what = error.what();
        for (const char* part : {"pass 'reader'", "image 'a'", "as it was before pass 'writer' wrote it",
                                 "(declared at tests/graph/plan_refusals_test.cpp:"})
            EXPECT_NE(what.find(part), std::string::npos) << what;
    }
    EXPECT_THROW(g.output(before), GraphError);
    Image old = before;
    EXPECT_THROW(g.graphics("second writer").color(old), GraphError);
    EXPECT_NO_THROW(g.graphics("third").samples(a));
}
TEST_F(Rules, ARefusalStatesTheLineThatDeclaresThePass) {
    Image a = g.image("a", kDepth);
    const int line = __LINE__ + 1;
    g.graphics("one").color(a);
    try {
        compile(g, caps);
        FAIL();
    } catch (const GraphError& error) {
        const std::string wanted = " (declared at tests/graph/plan_refusals_test.cpp:" + std::to_string(line) + ")";
        EXPECT_TRUE(std::string(error.what()).ends_with(wanted)) << error.what();
    }
}
TEST_F(Rules, ABudgetThatOnePassExceedsIsRefused) {
    Image a = g.image("a", kWide), b = g.image("b", kWide), c = g.image("c", kColor);
    g.graphics("greedy").color(a).color(b).color(c);
    EXPECT_EQ(refusal(), "pass 'greedy': 20 bytes of colour per pixel exceed the tile budget of 'mali-old' (16)");
    caps.transient = false;  // no tile
    EXPECT_EQ(refusal(), "");
    caps.transient = true;
    caps.tileBytesPerPixel = 20;
    EXPECT_EQ(refusal(), "");
    caps.maxColorAttachments = 2;
    EXPECT_NE(refusal().find("pass 'greedy': 3 colour and 0 input attachments exceed"), std::string::npos);
}
TEST_F(Rules, AnImageUsedTwiceByOnePassIsRefused) {
    Image a = g.importImage("a", kColor, kTexture);
    g.graphics("one").samples(a).color(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': used twice by one pass");
}
TEST_F(Rules, AVerbThatDoesNotGoWithThePassIsRefused) {
    Image a = g.image("a", kColor);
    g.compute("one").color(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': 'write' does not go with this kind of pass");
}
TEST_F(Rules, AFragmentThatStoresIsRefused) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("one").stores(a).color(b);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': 'store' does not go with this kind of pass");
}
TEST_F(Rules, AColourThatIsDepthIsRefused) {
    Image a = g.image("a", kDepth);
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
    Image a = g.image("a", kColor);
    g.graphics("one").ordered(a, Clear{0.0f});
    g.output(a);
    EXPECT_EQ(refusal(), "pass 'one', image 'a': 'mali-old' cannot read an attachment in raster order");
    caps.rasterOrder = RasterOrder::assumed;
    EXPECT_EQ(refusal(), "");
    caps.rasterOrder = RasterOrder::promised;
    EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace nacre::graph
