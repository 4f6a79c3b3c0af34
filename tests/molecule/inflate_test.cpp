#include "engine/molecule/formats/inflate.h"

#include <gtest/gtest.h>

#include "tests/molecule/expect_error.h"
#include "tests/molecule/gzip_bytes.h"

namespace nacre {
namespace {

const std::string kWater = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";

TEST(Inflate, GivesBackWhatWasPacked) {
    const std::string packed = test::gzipBytes(kWater);
    ASSERT_TRUE(isGzip(packed));
    EXPECT_EQ(inflateGzip("x", packed, 1000), kWater);
    EXPECT_EQ(readMolecule("water.xyz.gz", packed).atoms.size(), 3u);
}

TEST(Inflate, PutsMembersTogether) {
    EXPECT_EQ(inflateGzip("x", test::gzipBytes(kWater) + test::gzipBytes("tail"), 1000), kWater + "tail");
    EXPECT_EQ(inflateGzip("x", test::gzipBytes(kWater) + std::string(512, '\0'), 1000), kWater);
}

TEST(Inflate, EveryTruncationIsAnError) {
    const std::string packed = test::gzipBytes(kWater);
    for (std::size_t length = 2; length < packed.size(); ++length)
        test::expectError("water.xyz.gz", packed.substr(0, length), {"water.xyz.gz", "truncated"});
}

TEST(Inflate, AWrongChecksumIsAnError) {
    std::string packed = test::gzipBytes(kWater);
    packed[packed.size() - 8] ^= 1;
    test::expectError("water.xyz.gz", packed, {"wrong checksum"});
}

TEST(Inflate, ABombIsRefusedEarly) {
    const std::string member = test::gzipBytes(std::string(std::size_t{1} << 20, '\0'), 64);
    std::string bomb;
    for (int i = 0; i < 32; ++i) bomb += member;  // 2 GiB when inflated
    ASSERT_LT(bomb.size(), std::size_t{4} << 20);
    ReadOptions small;
    small.maxBytes = 100'000;
    test::expectError("bomb.pdb.gz", bomb, {"limit of 100000 bytes"}, small);
    test::expectError("bomb.pdb.gz", bomb, {"100-fold"});
    test::expectError("bomb.pdb.gz", test::gzipBytes(std::string(std::size_t{1} << 20, '\0'), 256), {"100-fold"});
}

TEST(Inflate, TheLimitHoldsForPlainTextToo) {
    ReadOptions options;
    options.maxBytes = kWater.size();
    EXPECT_EQ(readMolecule("water.xyz", kWater, options).atoms.size(), 3u);
    EXPECT_EQ(readMolecule("water.xyz.gz", test::gzipBytes(kWater), options).atoms.size(), 3u);
    options.maxBytes -= 1;
    test::expectError("water.xyz", kWater, {"larger than the limit"}, options);
    test::expectError("water.xyz.gz", test::gzipBytes(kWater), {"limit"}, options);
}

TEST(Inflate, WhatIsNamedGzButIsTextReads) { EXPECT_EQ(readMolecule("water.xyz.gz", kWater).atoms.size(), 3u); }

TEST(Inflate, GzipInsideGzipIsNamed) {
    test::expectError("water.xyz.gz", test::gzipBytes(test::gzipBytes(kWater)), {"gzip inside gzip"});
}

}  // namespace
}  // namespace nacre
