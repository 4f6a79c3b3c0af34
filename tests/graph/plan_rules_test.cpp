// Every rule of the planner, with a graph that it takes and one that it does not, and the words of every refusal.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "tests/graph/plan_checker.h"

namespace nacre::graph {
namespace {

constexpr Extent kExtent{100, 50};
constexpr ImageDesc kColor{VK_FORMAT_R8G8B8A8_UNORM, kExtent};
constexpr ImageDesc kWide{VK_FORMAT_R16G16B16A16_SFLOAT, kExtent};
constexpr ImageDesc kDepth{VK_FORMAT_D32_SFLOAT, kExtent};
constexpr State kTexture{VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

struct Rules : testing::Test {
    PlanCaps caps = capabilitySet("mali-old").plan;  // 16 bytes a pixel
    Graph g{"test"};
    const Plan plan() const { return compile(g, caps); }
    std::size_t subpasses(std::size_t step = 0) const { return plan().steps.at(step).renderPass.subpasses.size(); }
    std::size_t steps() const { return plan().steps.size(); }
    std::string refusal() const {
        try {
            compile(g, caps);
        } catch (const GraphError& error) {
            return error.what();
        }
        return "";
    }
};

// Two passes that share a depth image and each have their own colour.
struct TwoPasses : Rules {
    Image depth = g.image("depth", kDepth);
    void declare(const ImageDesc& first = kColor, const ImageDesc& second = kColor) {
        const Image a = g.image("a", first), b = g.image("b", second);
        g.graphics("one").depth(depth, Clear{1.0f}).color(a, Clear{0.0f});
        g.graphics("two").depthTest(depth).color(b, Clear{0.0f});
        g.output(a);
        g.output(b);
    }
};

TEST_F(TwoPasses, JoinWhenTheyShareAnAttachment) {
    declare();
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(subpasses(), 2u);  // written, then tested under another colour
}
TEST_F(TwoPasses, StayApartWithoutMerging) {
    declare();
    caps.merge = false;
    EXPECT_EQ(steps(), 2u);
}
TEST_F(TwoPasses, StayApartOverTheTileBudget) {
    declare(kWide, kWide);
    EXPECT_EQ(steps(), 1u);
    caps.tileBytesPerPixel = 15;
    EXPECT_EQ(steps(), 2u);
}
TEST_F(TwoPasses, ShareNoSubpassThatLeavesTheTile) {
    declare();
    caps.tileSubpasses = false;
    EXPECT_EQ(steps(), 2u);  // two colours, neither of which is the other's
}

TEST_F(Rules, APassWithoutAnythingInCommonStaysApart) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("one").color(a, Clear{0.0f});
    g.graphics("two").color(b, Clear{0.0f});
    g.output(a);
    g.output(b);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, AnotherDepthImageStaysApart) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth), e = g.image("e", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("two").depth(e, Clear{1.0f}).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, SamePassesShareASubpassWhenTheyUseEverythingAlike) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("two").depth(d).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(subpasses(), 1u);
}

TEST_F(Rules, TestedThenWrittenDepthStartsASubpass) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("zero").depth(d, Clear{1.0f});
    g.graphics("one").depthTest(d).color(a, Clear{0.0f});
    g.graphics("two").depth(d).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(subpasses(), 3u);
    caps.tileSubpasses = false;  // where that would leave the tile, all of it is one
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(subpasses(), 1u);
}

TEST_F(Rules, ColoursInAnotherOrderStartASubpass) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("one").color(a, Clear{0.0f}).color(b, Clear{0.0f});
    g.graphics("two").color(b).color(a);
    g.output(a);
    EXPECT_EQ(subpasses(), 2u);
}

TEST_F(Rules, AClearInTheMiddleStartsARenderPass) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("two").depth(d, Clear{1.0f}).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 2u);
}

struct InputRead : Rules {
    Image first = g.image("first", kWide), picture = g.image("picture", kColor);
    void declare(bool between) {
        g.graphics("write").color(first, Clear{0.0f});
        if (between) g.transfer("between").copiesFrom(first).copiesTo(g.importBuffer("bytes", 40000));
        g.graphics("read").input(first).color(picture, Clear{0.0f});
        g.output(picture);
    }
};
TEST_F(InputRead, StaysOnTheTile) {
    declare(false);
    const Plan p = plan();
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(p.steps[0].renderPass.subpasses[1].inputs.size(), 1u);
    EXPECT_TRUE(p.images[0].transient);
    EXPECT_EQ(p.total.loaded, 0u);
    EXPECT_EQ(p.total.stored, 100u * 50 * 4);
}
TEST_F(InputRead, BecomesATextureReadWhereSubpassesLeaveTheTile) {
    declare(false);
    caps.tileSubpasses = false;
    const Plan p = plan();
    EXPECT_EQ(steps(), 2u);
    EXPECT_TRUE(p.inputIsSampled[1]);
    EXPECT_EQ(p.steps[1].renderPass.subpasses[0].inputs.size(), 0u);
    EXPECT_EQ(p.total.loaded, 100u * 50 * 8);
    EXPECT_TRUE(p.images[0].usage & VK_IMAGE_USAGE_SAMPLED_BIT);
}
TEST_F(InputRead, BecomesATextureReadAfterAnotherKindOfPass) {
    declare(true);
    EXPECT_EQ(steps(), 3u);
    EXPECT_TRUE(plan().inputIsSampled[2]);
}
TEST_F(InputRead, OfSeveralSamplesCannotBecomeATextureRead) {
    caps.tileBytesPerPixel = 32;
    const Image many = g.image("many", {VK_FORMAT_R8G8B8A8_UNORM, kExtent, 4});
    const Image result = g.image("result", {VK_FORMAT_R8G8B8A8_UNORM, kExtent, 4});
    g.graphics("draw").color(many, Clear{0.0f});
    g.graphics("read").input(many).color(result, Clear{0.0f});
    g.output(result);
    EXPECT_EQ(refusal(), "");
    caps.merge = false;
    EXPECT_NE(refusal().find("pass 'read', image 'many': input of several samples"), std::string::npos) << refusal();
}

// Colour of four samples, which the pass resolves, and what another pass draws over it.
struct Resolve : Rules {
    static constexpr ImageDesc kFour{VK_FORMAT_R8G8B8A8_UNORM, kExtent, 4};
    Image depth = g.image("depth", {VK_FORMAT_D32_SFLOAT, kExtent, 4});
    Image samples = g.image("samples", kFour), picture = g.image("picture", kColor);
    void draw() { g.graphics("draw").depth(depth, Clear{1.0f}).color(samples, Clear{0.0f}).resolve(picture); }
};

TEST_F(Resolve, HappensInTheRenderPassAndStoresThePictureAlone) {
    draw();
    g.graphics("over").color(samples).resolve(picture);
    g.output(picture);
    const Plan p = plan();
    ASSERT_EQ(p.steps.size(), 1u);
    const RenderPassPlan& pass = p.steps[0].renderPass;
    ASSERT_EQ(pass.subpasses.size(), 1u);
    EXPECT_EQ(pass.samples, 4u);
    EXPECT_EQ(pass.tileBytesPerPixel, 16u);
    for (const Attachment& a : pass.attachments) {
        const bool resolved = a.image == picture.index;
        EXPECT_EQ(a.samples, resolved ? 1u : 4u);
        EXPECT_EQ(a.load, resolved ? Load::dontCare : Load::clear);
        EXPECT_EQ(a.store, resolved ? Store::store : Store::dontCare);
        EXPECT_EQ(a.transient, !resolved);
    }
    EXPECT_EQ(p.total, (Traffic{0, 100 * 50 * 4}));
    EXPECT_EQ(test::checkPlan(g, p, caps), std::vector<std::string>{});
}
TEST_F(Resolve, IsSeenByLaterPasses) {
    draw();
    const Image copy = g.image("copy", kColor);
    g.graphics("read").samples(picture).color(copy, Clear{0.0f});
    g.output(copy);
    EXPECT_EQ(steps(), 2u);
    EXPECT_EQ(test::checkPlan(g, plan(), caps), std::vector<std::string>{});
}
TEST_F(Resolve, OfOnePassIsNotThatOfAnother) {
    draw();
    const Image other = g.image("other", kColor);
    g.graphics("over").color(samples).resolve(other);
    g.output(picture);
    g.output(other);
    EXPECT_EQ(subpasses(), 2u);
    EXPECT_EQ(test::checkPlan(g, plan(), caps), std::vector<std::string>{});
    caps.tileSubpasses = false;
    EXPECT_EQ(steps(), 2u);
}
TEST_F(Resolve, CountsAllSamplesOnTheTile) {
    draw();
    g.output(picture);
    EXPECT_EQ(refusal(), "");
    caps.tileBytesPerPixel = 15;
    EXPECT_EQ(refusal(), "pass 'draw': 16 bytes of colour per pixel exceed the tile budget of 'mali-old' (15)");
}
TEST_F(Resolve, TakesWhatItsColourIsMadeOf) {
    const Image wide = g.image("wide", kWide);
    g.graphics("draw").color(samples, Clear{0.0f}).resolve(wide);
    g.output(wide);
    EXPECT_EQ(refusal(),
              "pass 'draw', image 'wide': RGBA16F of 100x50 cannot take the mean of RGBA8 of 100x50, 4 samples");
}
TEST_F(Rules, NothingIsResolvedThatHasOneSample) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("draw").color(a, Clear{0.0f}).resolve(b);
    g.output(b);
    EXPECT_EQ(refusal(), "pass 'draw', image 'b': nothing of several samples stands before it");
}

TEST_F(Rules, ATextureReadCrossesPixels) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth), b = g.image("b", kColor);
    g.graphics("write").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("read").depthTest(d).samples(a).color(b, Clear{0.0f});
    g.output(b);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, AnImageIsNotTestedAndSampledInOneRenderPass) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("depth").depth(d, Clear{1.0f});
    g.transfer("apart").copiesFrom(g.importBuffer("from", 4)).copiesTo(g.importBuffer("to", 4));
    g.graphics("test").depthTest(d).color(a, Clear{0.0f});
    g.graphics("sample").samples(d).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 4u);
}

TEST_F(Rules, WhatReachesNoOutputIsCulled) {
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("unseen").color(b, Clear{0.0f});
    g.graphics("overwritten").color(a, Clear{0.0f});
    g.graphics("kept for its effect").color(b, Clear{0.5f}).sideEffect();
    g.graphics("seen").color(a, Clear{0.0f});
    g.output(a);
    EXPECT_EQ(plan().culled, (std::vector<bool>{true, true, false, false}));
}

TEST_F(Rules, OnlyWhatIsReadLaterIsStored) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.output(a);
    const Plan p = plan();
    EXPECT_EQ(p.steps[0].renderPass.attachments[0].store, Store::dontCare);
    EXPECT_EQ(p.steps[0].renderPass.attachments[1].store, Store::store);
    EXPECT_TRUE(p.images[1].transient);
    EXPECT_FALSE(p.images[0].transient);
    caps.storeAll = true;
    EXPECT_EQ(plan().steps[0].renderPass.attachments[0].store, Store::store);
    EXPECT_FALSE(plan().images[1].transient);
    caps.storeAll = false;
    caps.transient = false;
    EXPECT_FALSE(plan().images[1].transient);
}

TEST_F(Rules, ATestedDepthBufferIsStoredAgainOnlyWithoutStoreNone) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("one").depth(d, Clear{1.0f});
    g.graphics("two").depthTest(d).color(a, Clear{0.0f});
    g.graphics("three").depthTest(d).color(a);
    g.output(a);
    caps.merge = false;
    EXPECT_EQ(plan().steps[1].renderPass.attachments[0].store, Store::store);
    caps.storeNone = true;
    EXPECT_EQ(plan().steps[1].renderPass.attachments[0].store, Store::none);
    EXPECT_EQ(plan().steps[1].renderPass.attachments[0].load, Load::load);
}

TEST_F(Rules, AnImportedImageIsLoadedUnlessItIsUndefined) {
    const Image full = g.importImage("full", kColor, kTexture), empty = g.importImage("empty", kColor, kTexture, true);
    g.graphics("one").color(full);
    g.graphics("two").color(empty);
    EXPECT_EQ(plan().steps[0].renderPass.attachments[0].load, Load::load);
    EXPECT_EQ(plan().steps[1].renderPass.attachments[0].load, Load::dontCare);
    EXPECT_EQ(plan().after.size(), 2u);  // both go back to the texture's layout
}

TEST_F(Rules, ADependencyFromOutsideGoesToTheFirstSubpassThatUsesAnAttachment) {
    const Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("depth").depth(d, Clear{1.0f});
    g.graphics("colour").depthTest(d).color(a, Clear{0.0f});
    g.output(a);
    bool found = false;
    const Plan made = plan();
    for (const Dependency& x : made.steps[0].renderPass.dependencies)
        found = found || (x.from == VK_SUBPASS_EXTERNAL && x.to == 1);
    EXPECT_TRUE(found);
}

// Refusals.
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

TEST_F(Rules, ABufferCountsAsTrafficWhereOnePassHandsItToOthers) {
    const Buffer handed = g.importBuffer("handed", 1000), given = g.importBuffer("given", 70);
    const Buffer made = g.importBuffer("made", 5);
    const Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.compute("one").reads(given).writes(handed);
    g.graphics("two").reads(handed).color(a);
    g.graphics("three").reads(handed).color(b);
    g.compute("four").writes(made);
    g.output(a);
    g.output(b);
    g.output(made);
    const Plan plan = compile(g, caps);
    EXPECT_EQ(plan.bufferTraffic, (std::vector<Traffic>{{2000, 1000}, {0, 0}, {0, 5}}));
}

}  // namespace
}  // namespace nacre::graph
