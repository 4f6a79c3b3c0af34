#include <gtest/gtest.h>

#include "engine/tiles/device_lists.h"

namespace nacre::test {
namespace {

TEST(ListRounds, HoldAllEntries) {
    using passes::planRounds;
    EXPECT_EQ(planRounds(1000, 1000, 1000).count, 1u);
    EXPECT_EQ(planRounds(1001, 501, 1000).count, 0u) << "a list may need more than half of the room";
    EXPECT_EQ(planRounds(100'000, 500, 1000).count, 0u) << "too many rounds";
    const passes::ListRounds rounds = planRounds(5000, 400, 1000);
    EXPECT_GE(std::uint64_t{rounds.count} * rounds.share, 5001u);  // an empty last list begins where all entries end
    EXPECT_LE(rounds.share + 400u, 1000u);
}

}  // namespace
}  // namespace nacre::test
