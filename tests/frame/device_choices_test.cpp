// What is chosen for a device: path, samples, and the facts behind it.

#include <gtest/gtest.h>

#include "engine/error.h"
#include "engine/frame/choose.h"
#include "engine/graph/capability_sets.h"

namespace nacre::graph {
namespace {

FrameCaps withPath(const char* name, Visibility path) {
    FrameCaps caps = capabilitySet(name);
    caps.visibility = path;
    return caps;
}

// Where MIN is shader code, one pass in raster order costs least by counts (docs/tilers.md). Without a promise of that
// order it is encoded depth by MIN, and raster order if a self-test found it right and faster by far.
TEST(Path, IsTheCheapestRightOneWhereBlendingIsShaderCode) {
    for (const char* name : {"mali", "mali-late", "mali-old", "powervr"}) {
        SCOPED_TRACE(name);
        FrameCaps caps = capabilitySet(name);
        EXPECT_TRUE(caps.plan.blendsByShader);
        for (const auto& [order, path] :
             {std::pair(RasterOrder::none, Visibility::encoded), std::pair(RasterOrder::assumed, Visibility::encoded),
              std::pair(RasterOrder::promised, Visibility::rasterOrder)}) {
            caps.plan.rasterOrder = order;
            EXPECT_EQ(choosePath(caps).visibility, path);
        }
        caps.visibility = Visibility::rasterOrder;
        caps.plan.rasterOrder = RasterOrder::assumed;
        EXPECT_EQ(choosePath(caps).visibility, Visibility::rasterOrder);  // asked for
        caps.plan.rasterOrder = RasterOrder::none;
        EXPECT_THROW(choosePath(caps), Error);
        caps.visibility = Visibility::automatic;
        caps.plan.rasterOrder = RasterOrder::assumed;
        caps.tested = {Visibility::rasterOrder, "the fastest here"};
        EXPECT_EQ(choosePath(caps).visibility, Visibility::rasterOrder);
    }
    // Elsewhere MIN is the blender's, and costs no instruction.
    FrameCaps turnip = capabilitySet("turnip");
    turnip.plan.rasterOrder = RasterOrder::promised;
    EXPECT_EQ(choosePath(turnip).visibility, Visibility::encoded);
}

TEST(MotionSamples, AreSeveralWhereTheyStayOnTheTile) {
    const auto count = [](const FrameCaps& caps) { return chooseMotionSamples(caps).count; };
    EXPECT_EQ(count(withPath("apple-moltenvk", Visibility::fragdepth)), 4u);
    EXPECT_EQ(count(withPath("adreno-no-subpass", Visibility::fragdepth)), 4u);
    // Samples read in raster order are unverified: there they are asked for.
    FrameCaps mali = withPath("mali", Visibility::rasterOrder);
    EXPECT_EQ(count(mali), 1u);
    mali.multisampling = Multisampling::four;
    EXPECT_EQ(count(mali), 4u);
    mali.visibility = Visibility::encoded;
    EXPECT_THROW(chooseMotionSamples(mali), Error);
    // No memory that is lazily allocated; no tile; encoded depth of one sample.
    EXPECT_EQ(count(withPath("v3dv", Visibility::fragdepth)), 1u);
    EXPECT_EQ(count(withPath("desktop", Visibility::fragdepth)), 1u);
    for (const CapabilitySet& set : capabilitySets())
        for (const Visibility path : {Visibility::encoded, Visibility::deferred, Visibility::tiles})
            EXPECT_EQ(count(withPath(set.plan.name.c_str(), path)), 1u) << set.plan.name;
    PlanCaps plan = capabilitySet("mali").plan;
    plan.tileBytesPerPixel = 31;
    EXPECT_EQ(lacksMultisampling(Visibility::rasterOrder, plan),
              "its samples take 32 bytes per pixel of the tile, which holds 31");
    EXPECT_EQ(lacksMultisampling(Visibility::fragdepth, plan), "");
    plan.placesSamples = false;
    EXPECT_NE(lacksMultisampling(Visibility::fragdepth, plan), "");
    FrameCaps software = withPath("mali", Visibility::fragdepth);
    software.kind = DeviceKind::software;
    EXPECT_EQ(count(software), 1u);
}

TEST(PathChoice, FollowsTheUserThenTheTestThenTheDevice) {
    FrameCaps caps = capabilitySet("desktop");
    EXPECT_EQ(choosePath(caps).visibility, Visibility::fragdepth);
    caps.tested = {Visibility::deferred, "the fastest here"};
    EXPECT_EQ(choosePath(caps).visibility, Visibility::deferred);
    EXPECT_EQ(choosePath(caps).why, "the fastest here");
    caps.visibility = Visibility::encoded;
    EXPECT_EQ(choosePath(caps).visibility, Visibility::encoded);
    EXPECT_EQ(choosePath(caps).why, "asked for");
    caps.visibility = Visibility::rasterOrder;
    EXPECT_THROW(choosePath(caps), Error);
}

TEST(PathChoice, OfASoftwareDeviceIsTiles) {
    FrameCaps caps = capabilitySet("desktop");
    caps.kind = DeviceKind::software;
    EXPECT_EQ(choosePath(caps).visibility, Visibility::tiles);
    EXPECT_EQ(chooseOcclusionMaps(caps), OcclusionMaps::tiles);
}

TEST(GeometryChoice, FetchesByNumberOnlyWhereVertexOutputsGoThroughMemory) {
    RenderSettings settings;
    settings.view.width = settings.view.height = 640;
    settings.supersample = 1;
    SceneFacts facts;
    facts.spheres = 1000;
    const auto geometry = [&](const char* set) {
        return choose({settings, Part::whole, Ending::readBack}, facts, capabilitySet(set)).geometry;
    };
    EXPECT_EQ(geometry("mali"), Geometry::fetched);
    EXPECT_EQ(geometry("mali-late"), Geometry::instanced);
    EXPECT_EQ(geometry("powervr"), Geometry::fetched);
    EXPECT_EQ(geometry("adreno"), Geometry::instanced);
}

TEST(CapabilitySets, AllHaveFactsWithSources) {
    EXPECT_EQ(capabilitySets().size(), 12u);
    for (const CapabilitySet& set : capabilitySets()) {
        EXPECT_FALSE(set.facts.empty()) << set.plan.name;
        for (const Fact& fact : set.facts) EXPECT_GT(std::string(fact.source).size(), 10u) << fact.what;
        const TestedPath choice = choosePath(set);
        EXPECT_NE(choice.visibility, Visibility::automatic);
        EXPECT_NE(choice.why, std::string());
        EXPECT_GE(set.plan.tileBytesPerPixel, 16u);
    }
    EXPECT_THROW(capabilitySet("voodoo"), std::exception);
}

}  // namespace
}  // namespace nacre::graph
