#include "engine/molecule/formats/decompress.h"

#include <bzlib.h>
#include <gtest/gtest.h>
#include <lzma.h>
#include <zstd.h>

#include <memory>

#include "tests/molecule/expect_error.h"
#include "tests/molecule/gzip_bytes.h"

namespace nacre {
namespace {

const std::string kUnpacked = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n";

TEST(Decompress, GivesBackWhatWasPacked) {
    const std::string packed = test::gzipBytes(kUnpacked);
    ASSERT_EQ(detectCompression(packed), "gzip");
    EXPECT_EQ(decompress("x", packed, 1000), kUnpacked);
    EXPECT_EQ(readMolecule("water.xyz.gz", packed).atoms.size(), 3u);
}

TEST(Decompress, PutsMembersTogether) {
    EXPECT_EQ(decompress("x", test::gzipBytes(kUnpacked) + test::gzipBytes("tail"), 1000), kUnpacked + "tail");
    EXPECT_EQ(decompress("x", test::gzipBytes(kUnpacked) + std::string(512, '\0'), 1000), kUnpacked);
}

TEST(Decompress, EveryTruncationIsAnError) {
    const std::string packed = test::gzipBytes(kUnpacked);
    for (std::size_t length = 2; length < packed.size(); ++length)
        test::expectError("water.xyz.gz", packed.substr(0, length), {"water.xyz.gz", "truncated"});
}

TEST(Decompress, AWrongChecksumIsAnError) {
    std::string packed = test::gzipBytes(kUnpacked);
    packed[packed.size() - 8] ^= 1;
    test::expectError("water.xyz.gz", packed, {"wrong checksum"});
}

TEST(Decompress, ABombIsRefusedEarly) {
    const std::string member = test::gzipBytes(std::string(std::size_t{1} << 20, '\0'), 64);
    std::string bomb;
    for (int i = 0; i < 32; ++i) bomb += member;  // 2 GiB when inflated
    ASSERT_LT(bomb.size(), std::size_t{4} << 20);
    test::expectError("bomb.pdb.gz", bomb, {"limit of 100000 bytes"}, {.maxBytes = 100'000});
    test::expectError("bomb.pdb.gz", bomb, {"100-fold"});
    test::expectError("bomb.pdb.gz", test::gzipBytes(std::string(std::size_t{1} << 20, '\0'), 256), {"100-fold"});
}

TEST(Decompress, TheLimitHoldsForPlainTextToo) {
    ReadOptions options{.maxBytes = kUnpacked.size()};
    EXPECT_EQ(readMolecule("water.xyz", kUnpacked, options).atoms.size(), 3u);
    EXPECT_EQ(readMolecule("water.xyz.gz", test::gzipBytes(kUnpacked), options).atoms.size(), 3u);
    options.maxBytes -= 1;
    test::expectError("water.xyz", kUnpacked, {"larger than the limit"}, options);
    test::expectError("water.xyz.gz", test::gzipBytes(kUnpacked), {"limit"}, options);
}

TEST(Decompress, WhatIsNamedGzButIsTextReads) { EXPECT_EQ(readMolecule("water.xyz.gz", kUnpacked).atoms.size(), 3u); }

struct Packer {
    const char* compression;
    const char* ending;
    std::string (*pack)(const std::string&);
};
class EachCompression : public testing::TestWithParam<Packer> {};

TEST_P(EachCompression, GivesBackWhatWasPacked) {
    const std::string packed = GetParam().pack(kUnpacked), name = std::string("water.xyz") + GetParam().ending;
    ASSERT_EQ(detectCompression(packed), GetParam().compression);
    EXPECT_EQ(decompress("x", packed, 1000), kUnpacked);
    EXPECT_EQ(decompress("x", packed + GetParam().pack("tail"), 1000), kUnpacked + "tail");
    EXPECT_EQ(decompress("x", packed + std::string(512, '\0'), 1000), kUnpacked);
    EXPECT_EQ(readMolecule(name, packed).atoms.size(), 3u);
    test::expectError(name, GetParam().pack(packed), {"compressed twice"});
}

TEST_P(EachCompression, WhatIsDamagedIsAnError) {
    const std::string packed = GetParam().pack(kUnpacked), name = std::string("water.xyz") + GetParam().ending;
    for (std::size_t length = 6; length < packed.size(); ++length)
        test::expectError(name, packed.substr(0, length), {name.c_str(), "truncated"});
    std::size_t refused = 0;
    for (std::size_t i = 6; i < packed.size(); ++i) {
        std::string damaged = packed;
        damaged[i] ^= 0x10;
        try {
            readMolecule(name, damaged);  // a header has bits that mean nothing
        } catch (const Error& error) {
            test::expectCleanMessage(error.what());
            ++refused;
        }
    }
    EXPECT_GT(refused, packed.size() / 2);
}

TEST_P(EachCompression, ABombIsRefusedEarly) {
    const std::string bomb = GetParam().pack(std::string(std::size_t{65} << 20, '\0'));
    test::expectError("bomb.pdb", bomb, {"limit of 100000 bytes"}, {.maxBytes = 100'000});
    test::expectError("bomb.pdb", bomb, {"100-fold"});
}

std::string packGzip(const std::string& bytes) { return test::gzipBytes(bytes); }

std::string packXz(const std::string& bytes) {
    std::string out(lzma_stream_buffer_bound(bytes.size()), '\0');
    std::size_t size = 0;
    lzma_easy_buffer_encode(6, LZMA_CHECK_CRC64, nullptr, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                            bytes.size(), reinterpret_cast<std::uint8_t*>(out.data()), &size, out.size());
    out.resize(size);
    return out;
}

std::string packBzip2(const std::string& bytes) {
    std::string out(bytes.size() + bytes.size() / 100 + 600, '\0');
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(bytes.data()), static_cast<unsigned>(bytes.size()), 9,
                             0, 0);
    out.resize(size);
    return out;
}

std::string packZstd(const std::string& bytes) {
    const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::string out(ZSTD_compressBound(bytes.size()), '\0');
    out.resize(ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size()));
    return out;
}

INSTANTIATE_TEST_SUITE_P(Decompress, EachCompression,
                         testing::Values(Packer{"gzip", ".gz", packGzip}, Packer{"xz", ".xz", packXz},
                                         Packer{"bzip2", ".bz2", packBzip2}, Packer{"zstd", ".zst", packZstd}),
                         [](const auto& param) { return std::string(param.param.compression); });

TEST(Decompress, CompressedTwiceIsNamed) {
    test::expectError("water.xyz.gz", test::gzipBytes(test::gzipBytes(kUnpacked)), {"compressed twice"});
}

}  // namespace
}  // namespace nacre
