// Every rule of the planner, with a graph that it takes and one that it does not.

#include "tests/graph/plan_rules.h"

namespace nacre::graph {
namespace {

// Two passes that share a depth image and each have their own colour.
struct TwoPasses : Rules {
    Image depth = g.image("depth", kDepth);
    void declare(const ImageDesc& first = kColor, const ImageDesc& second = kColor) {
        Image a = g.image("a", first), b = g.image("b", second);
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
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("one").color(a, Clear{0.0f});
    g.graphics("two").color(b, Clear{0.0f});
    g.output(a);
    g.output(b);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, AnotherDepthImageStaysApart) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth), e = g.image("e", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("two").depth(e, Clear{1.0f}).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, SamePassesShareASubpassWhenTheyUseEverythingAlike) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("one").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("two").depth(d).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 1u);
    EXPECT_EQ(subpasses(), 1u);
}

TEST_F(Rules, TestedThenWrittenDepthStartsASubpass) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
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
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("one").color(a, Clear{0.0f}).color(b, Clear{0.0f});
    g.graphics("two").color(b).color(a);
    g.output(a);
    EXPECT_EQ(subpasses(), 2u);
}

TEST_F(Rules, AClearInTheMiddleStartsARenderPass) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
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
    Image many = g.image("many", {VK_FORMAT_R8G8B8A8_UNORM, kExtent, 4});
    Image result = g.image("result", {VK_FORMAT_R8G8B8A8_UNORM, kExtent, 4});
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
    Image copy = g.image("copy", kColor);
    g.graphics("read").samples(picture).color(copy, Clear{0.0f});
    g.output(copy);
    EXPECT_EQ(steps(), 2u);
    EXPECT_EQ(test::checkPlan(g, plan(), caps), std::vector<std::string>{});
}
TEST_F(Resolve, OfOnePassIsNotThatOfAnother) {
    draw();
    Image other = g.image("other", kColor);
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
    Image wide = g.image("wide", kWide);
    g.graphics("draw").color(samples, Clear{0.0f}).resolve(wide);
    g.output(wide);
    EXPECT_EQ(refusal(),
              "pass 'draw', image 'wide': RGBA16F of 100x50 cannot take the mean of RGBA8 of 100x50, 4 samples");
}
TEST_F(Rules, NothingIsResolvedThatHasOneSample) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("draw").color(a, Clear{0.0f}).resolve(b);
    g.output(b);
    EXPECT_EQ(refusal(), "pass 'draw', image 'b': nothing of several samples stands before it");
}

TEST_F(Rules, ATextureReadCrossesPixels) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth), b = g.image("b", kColor);
    g.graphics("write").depth(d, Clear{1.0f}).color(a, Clear{0.0f});
    g.graphics("read").depthTest(d).samples(a).color(b, Clear{0.0f});
    g.output(b);
    EXPECT_EQ(steps(), 2u);
}

TEST_F(Rules, AnImageThatComputeStoresIsSampledLater) {
    Image a = g.image("a", {VK_FORMAT_R32_UINT, kExtent}), b = g.image("b", kColor);
    g.compute("first part").stores(a);
    g.compute("second part").stores(a);
    g.graphics("read").samples(a).color(b, Clear{0.0f});
    g.output(b);
    const Plan p = plan();
    EXPECT_EQ(p.images[0].usage, VkImageUsageFlags{VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
    EXPECT_FALSE(p.images[0].transient);
    EXPECT_EQ(p.traffic[0].stored, 4u * 100 * 50);  // once: each pixel has one writer
    EXPECT_EQ(p.traffic[0].loaded, 4u * 100 * 50);
    std::vector<std::pair<VkImageLayout, VkImageLayout>> layouts;
    for (const Step& step : p.steps)
        for (const Barrier& barrier : step.before)
            if (barrier.isImage && barrier.resource == 0) layouts.emplace_back(barrier.from.layout, barrier.to.layout);
    EXPECT_EQ(layouts, (std::vector<std::pair<VkImageLayout, VkImageLayout>>{
                           {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL},
                           {VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL},
                           {VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}}));
}

TEST_F(Rules, AnImageIsNotTestedAndSampledInOneRenderPass) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("depth").depth(d, Clear{1.0f});
    g.transfer("apart").copiesFrom(g.importBuffer("from", 4)).copiesTo(g.importBuffer("to", 4));
    g.graphics("test").depthTest(d).color(a, Clear{0.0f});
    g.graphics("sample").samples(d).color(a);
    g.output(a);
    EXPECT_EQ(steps(), 4u);
}

TEST_F(Rules, WhatReachesNoOutputIsCulled) {
    Image a = g.image("a", kColor), b = g.image("b", kColor);
    g.graphics("unseen").color(b, Clear{0.0f});
    g.graphics("overwritten").color(a, Clear{0.0f});
    g.graphics("kept for its effect").color(b, Clear{0.5f}).sideEffect();
    g.graphics("seen").color(a, Clear{0.0f});
    g.output(a);
    EXPECT_EQ(plan().culled, (std::vector<bool>{true, true, false, false}));
}

TEST_F(Rules, OnlyWhatIsReadLaterIsStored) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
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
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
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
    Image full = g.importImage("full", kColor, kTexture), empty = g.importImage("empty", kColor, kTexture, true);
    g.graphics("one").color(full);
    g.graphics("two").color(empty);
    EXPECT_EQ(plan().steps[0].renderPass.attachments[0].load, Load::load);
    EXPECT_EQ(plan().steps[1].renderPass.attachments[0].load, Load::dontCare);
    EXPECT_EQ(plan().after.size(), 2u);  // both go back to the texture's layout
}

TEST_F(Rules, ADependencyFromOutsideGoesToTheFirstSubpassThatUsesAnAttachment) {
    Image a = g.image("a", kColor), d = g.image("d", kDepth);
    g.graphics("depth").depth(d, Clear{1.0f});
    g.graphics("colour").depthTest(d).color(a, Clear{0.0f});
    g.output(a);
    bool found = false;
    const Plan made = plan();
    for (const Dependency& x : made.steps[0].renderPass.dependencies)
        found = found || (x.from == VK_SUBPASS_EXTERNAL && x.to == 1);
    EXPECT_TRUE(found);
}

TEST_F(Rules, ABufferCountsAsTrafficWhereOnePassHandsItToOthers) {
    const Buffer handed = g.importBuffer("handed", 1000), given = g.importBuffer("given", 70);
    const Buffer made = g.importBuffer("made", 5);
    Image a = g.image("a", kColor), b = g.image("b", kColor);
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
