// What a phone's counters say of a frame's traffic, beside its plan. The phone (tests/phone_layer/counters.h) counts by
// the commands that reach it.

#include "engine/counted_traffic.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

#include "engine/gpu/region_counters.h"

namespace nacre::test {
namespace {

bool asMali() { return std::string_view(std::getenv("NACRE_PHONE")) == "mali"; }

struct Counters {
    Counters() { setenv("NACRE_PHONE_COUNTERS", "1", 1); }
    ~Counters() { unsetenv("NACRE_PHONE_COUNTERS"); }
};

/// Counters of regions, without the validation layer: an older one hands on no call that it does not know.
struct Regions {
    Regions() {
        setenv("NACRE_PHONE_REGIONS", "1", 1);
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_phone", 1);
    }
    ~Regions() {
        unsetenv("NACRE_PHONE_REGIONS");
        setenv("VK_INSTANCE_LAYERS", layers.c_str(), 1);
    }
    std::string layers = std::getenv("VK_INSTANCE_LAYERS");
};

CountedTraffic counted(Visibility path, bool validate = true) {
    return countTraffic(DeviceOptions{.validate = validate, .visibility = path});
}

TEST(CountedTraffic, IsWhatThePlanSays) {
    if (!asMali()) GTEST_SKIP() << "the least phone of Arm's in raster order alone";
    const Counters counters;
    for (const Visibility path : {Visibility::rasterOrder, Visibility::encoded, Visibility::fragdepth}) {
        const CountedTraffic traffic = counted(path);
        EXPECT_EQ(traffic.lacks, "");
        EXPECT_EQ(traffic.visibility, visibilityName(path));
        ASSERT_TRUE(traffic.read && traffic.written) << traffic.visibility;
        EXPECT_EQ(*traffic.read, traffic.plannedRead) << traffic.visibility;
        EXPECT_EQ(*traffic.written, traffic.plannedWritten) << traffic.visibility;
        // The colour goes to memory, and some vertex outputs go there and back.
        EXPECT_GT(*traffic.read, 100'000u);
        EXPECT_EQ(*traffic.written - *traffic.read, std::uint64_t{4} * traffic.pixels * traffic.pixels);
        ASSERT_EQ(traffic.counters.size(), 3u);
        EXPECT_EQ(traffic.counters[1].name, "L2 read bytes");
        EXPECT_EQ(traffic.counters[1].bytes, 4096u);
    }
}

// The phone's own values (tests/phone_layer/regions.h).
TEST(CountedTraffic, SumsTheRegionsOfARenderPass) {
    if (!asMali()) GTEST_SKIP() << "the least phone of Arm's in raster order alone";
    const Regions regions;
    constexpr std::uint64_t kCount = std::uint64_t{720 / 48} * (720 / 40);
    const auto sum = [](std::uint64_t counter) { return kCount * 1000 * counter + kCount * (kCount - 1) / 2; };
    for (const Visibility path : {Visibility::rasterOrder, Visibility::encoded, Visibility::fragdepth}) {
        SCOPED_TRACE(visibilityName(path));
        const CountedTraffic traffic = counted(path, false);
        EXPECT_EQ(traffic.lacks, "");
        ASSERT_EQ(traffic.regions.size(), 5u);
        for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(traffic.regions[i].sum, sum(i)) << i;
        EXPECT_EQ(traffic.regions[0].name, "Fragment active cycles");
        EXPECT_EQ(traffic.regions[0].bytes, std::nullopt);
        EXPECT_EQ(traffic.regions[1].bytes, 16 * sum(1));
        EXPECT_EQ(traffic.regions[4].bytes, sum(4));
        // Two ways from memory and one there; the cache is on the chip.
        EXPECT_EQ(traffic.read, 16 * (sum(1) + sum(2)));
        EXPECT_EQ(traffic.written, 16 * sum(3));
        EXPECT_GT(traffic.plannedWritten, 0u);
        EXPECT_TRUE(traffic.counters.empty());
    }
    // Counters of the memory itself take precedence.
    const Counters counters;
    const CountedTraffic both = counted(Visibility::fragdepth, false);
    EXPECT_EQ(both.regions.size(), 5u);
    EXPECT_EQ(both.counters.size(), 3u);
    EXPECT_EQ(both.read, both.plannedRead);
}

TEST(CountedTraffic, RegionsAreLaidOutAsTheSpecificationSays) {
    VkPhysicalDevicePerformanceCountersByRegionPropertiesARM properties{};
    properties.performanceCounterRegionSize = {64, 32};
    properties.regionAlignment = 16;
    properties.rowStrideAlignment = 256;
    // align(ceil(w / rsw) * align(c * 4, ra), rsa) * ceil(h / rsh)
    const gpu::RegionLayout layout = gpu::layOut(properties, {1170, 2532}, 5);
    EXPECT_EQ(layout.columns, 19u);
    EXPECT_EQ(layout.rows, 80u);
    EXPECT_EQ(layout.regionBytes, 32u);
    EXPECT_EQ(layout.rowBytes, 768u);
    EXPECT_EQ(layout.bytes(), 768u * 80);
}

TEST(CountedTraffic, IsToldInWords) {
    CountedTraffic traffic{"", "fragdepth", 720, 3'140'000, {}, 3'000'000, 2'000'000, {}, {}};
    EXPECT_EQ(describe(traffic),
              "fragdepth at 720x720: 3.1 MB read, planned 3.0; nothing counts what is written, "
              "planned 2.0");
    traffic.lacks = "no counters";
    EXPECT_EQ(describe(traffic), "not counted: no counters");
    if (asMali()) {
        EXPECT_EQ(counted(Visibility::fragdepth).lacks,
                  "the driver has neither VK_KHR_performance_query nor VK_ARM_performance_counters_by_region");
    }
}

TEST(CountedTraffic, TakesCountersOfMemoryOutsideTheChip) {
    EXPECT_EQ(trafficWay("ExtBusRdBytes", "External memory", "Bytes read from external memory"), TrafficWay::read);
    EXPECT_EQ(trafficWay("Main memory write bytes", "", ""), TrafficWay::written);
    EXPECT_EQ(trafficWay("VBIF bytes", "", "Bytes that were written"), TrafficWay::written);
    EXPECT_EQ(trafficWay("Memory read and write bytes", "", "Both"), TrafficWay::neither);
    EXPECT_EQ(trafficWay("L2 read bytes", "L2 cache", "Bytes of the memory"), TrafficWay::neither);
    EXPECT_EQ(trafficWay("Tile buffer writes", "Memory", ""), TrafficWay::neither);
    EXPECT_EQ(trafficWay("Vertices read", "Geometry", ""), TrafficWay::neither);
    EXPECT_EQ(trafficWay("Load/store read beats from external memory", "", ""), TrafficWay::read);
    EXPECT_EQ(trafficWay("Load/store write beats to external memory", "", ""), TrafficWay::written);
    EXPECT_EQ(trafficWay("Load/store beats of external memory", "", ""), TrafficWay::neither);
}

}  // namespace
}  // namespace nacre::test
