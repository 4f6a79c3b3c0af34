#include "app/files/spare_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <thread>
#include <vector>

namespace nacre::app {
namespace {

double residentMegabytes() {
    std::ifstream in("/proc/self/statm");
    long size = 0, resident = 0;
    in >> size >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / 1e6;
}

TEST(SpareMemory, FreePiecesBetweenUsedOnesAreGivenBack) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
    GTEST_SKIP() << "another allocator";
#endif
    // As a thread that draws leaves its arena: nearly all is free, but the C library keeps it for what lies above.
    std::vector<std::unique_ptr<char[]>> pieces;
    std::thread([&] {
        constexpr std::size_t kBytes = 60'000, kCount = 2500;
        for (std::size_t i = 0; i < kCount; ++i) {
            pieces.emplace_back(new char[kBytes]);
            for (std::size_t at = 0; at < kBytes; at += 1000) pieces.back()[at] = 1;
        }
        for (std::size_t i = 0; i < kCount; ++i)
            if (i % 50 != 49) pieces[i].reset();
    }).join();
    const double before = residentMegabytes();
    for (int i = 0; i < 64; ++i) givePicturesMemoryBack();
    EXPECT_LT(residentMegabytes(), before - 80);
}

}  // namespace
}  // namespace nacre::app
