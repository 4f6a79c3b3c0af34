// What a phone's counters say of a frame's traffic, beside its plan. The phone (tests/phone_layer/counters.h) counts by
// the commands that reach it.

#include "engine/counted_traffic.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

namespace nacre::test {
namespace {

bool asMali() { return std::string_view(std::getenv("NACRE_PHONE")) == "mali"; }

struct Counters {
    Counters() { setenv("NACRE_PHONE_COUNTERS", "1", 1); }
    ~Counters() { unsetenv("NACRE_PHONE_COUNTERS"); }
};

CountedTraffic counted(Visibility path) {
    DeviceOptions options;
    options.validate = true;
    options.visibility = path;
    return countTraffic(options);
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

TEST(CountedTraffic, IsToldInWords) {
    CountedTraffic traffic{"", "fragdepth", 720, 3'140'000, {}, 3'000'000, 2'000'000, {}};
    EXPECT_EQ(describe(traffic),
              "fragdepth at 720x720: 3.1 MB read, planned 3.0; nothing counts what is written, "
              "planned 2.0");
    traffic.lacks = "no counters";
    EXPECT_EQ(describe(traffic), "not counted: no counters");
    if (asMali()) {
        EXPECT_EQ(counted(Visibility::fragdepth).lacks, "the driver has no VK_KHR_performance_query");
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
}

}  // namespace
}  // namespace nacre::test
