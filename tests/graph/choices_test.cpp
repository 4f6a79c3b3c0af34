// What is chosen for a device: path, samples, and the facts behind it.

#include <gtest/gtest.h>

#include "engine/graph/capability_sets.h"
#include "engine/graph/visibility.h"

namespace nacre::graph {
namespace {

TEST(Multisamples, AreTakenWhereTheyStayOnTheTile) {
    const auto choose = [](const char* name, Visibility path) {
        const CapabilitySet& set = capabilitySet(name);
        return chooseSamples(set.kind, path, set.plan);
    };
    EXPECT_EQ(choose("apple-moltenvk", Visibility::fragdepth).samples, 4u);
    EXPECT_EQ(choose("adreno-no-subpass", Visibility::fragdepth).samples, 4u);
    // Samples read in raster order are unverified: there they are asked for.
    EXPECT_EQ(choose("mali", Visibility::rasterOrder).samples, 1u);
    EXPECT_EQ(lacksMultisampling(Visibility::rasterOrder, capabilitySet("mali").plan), "");
    // No memory that is lazily allocated; no tile; encoded depth of one sample.
    EXPECT_EQ(choose("v3dv", Visibility::fragdepth).samples, 1u);
    EXPECT_EQ(choose("desktop", Visibility::fragdepth).samples, 1u);
    for (const CapabilitySet& set : capabilitySets())
        for (const Visibility path : {Visibility::encoded, Visibility::deferred, Visibility::tiles})
            EXPECT_EQ(chooseSamples(set.kind, path, set.plan).samples, 1u) << set.plan.name;
    PlanCaps caps = capabilitySet("mali").plan;
    caps.tileBytesPerPixel = 31;
    EXPECT_EQ(lacksMultisampling(Visibility::rasterOrder, caps),
              "its samples take 32 bytes per pixel of the tile, which holds 31");
    EXPECT_EQ(lacksMultisampling(Visibility::fragdepth, caps), "");
    caps.placesSamples = false;
    EXPECT_NE(lacksMultisampling(Visibility::fragdepth, caps), "");
    EXPECT_EQ(chooseSamples(DeviceKind::software, Visibility::fragdepth, capabilitySet("mali").plan).samples, 1u);
}

TEST(VisibilityChoice, OfASoftwareDeviceIsTilesWhereComputeCanDrawThem) {
    PlanCaps caps = capabilitySet("desktop").plan;
    EXPECT_EQ(chooseVisibility(DeviceKind::software, caps).visibility, Visibility::encoded);
    caps.tiles = true;
    EXPECT_EQ(chooseVisibility(DeviceKind::software, caps).visibility, Visibility::tiles);
    EXPECT_EQ(chooseVisibility(DeviceKind::immediate, caps).visibility, Visibility::fragdepth);
    EXPECT_EQ(chooseVisibility(DeviceKind::tiler, caps).visibility, Visibility::encoded);
}

TEST(CapabilitySets, AllHaveFactsWithSources) {
    EXPECT_EQ(capabilitySets().size(), 11u);
    for (const CapabilitySet& set : capabilitySets()) {
        EXPECT_FALSE(set.facts.empty()) << set.plan.name;
        for (const Fact& fact : set.facts) EXPECT_GT(std::string(fact.source).size(), 10u) << fact.what;
        const VisibilityChoice choice = chooseVisibility(set.kind, set.plan);
        EXPECT_NE(choice.visibility, Visibility::automatic);
        EXPECT_NE(choice.why, std::string());
        EXPECT_GE(set.plan.tileBytesPerPixel, 16u);
    }
    EXPECT_THROW(capabilitySet("voodoo"), std::exception);
}

}  // namespace
}  // namespace nacre::graph
