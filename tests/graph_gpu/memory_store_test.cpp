// Memory of resources that are made again, as for each picture of a batch.

#include "engine/gpu/memory_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/gpu/resources.h"

namespace nacre::gpu {
namespace {

constexpr auto kStorage = vk::BufferUsageFlagBits::eStorageBuffer;

vk::DeviceMemory memoryOf(const Buffer& buffer) { return **buffer.memory; }

TEST(MemoryStore, GivesFreedMemoryToResourcesOfAboutTheSameSize) {
    const Device device{DeviceOptions{}};
    Buffer first = makeBuffer(device, 70'000, kStorage, Access::upload, "first");
    const vk::DeviceMemory memory = memoryOf(first);
    std::byte* const mapped = first.mapped;
    first = {};
    EXPECT_EQ(device.memory().bytes(), 0u);
    const Buffer larger = makeBuffer(device, 100'000, kStorage, Access::upload, "larger");
    EXPECT_NE(memoryOf(larger), memory);
    const Buffer again = makeBuffer(device, 72'000, kStorage, Access::upload, "again");
    EXPECT_EQ(memoryOf(again), memory);
    EXPECT_EQ(again.mapped, mapped);
    const Buffer beside = makeBuffer(device, 72'000, kStorage, Access::upload, "beside");
    EXPECT_NE(memoryOf(beside), memory);
}

TEST(MemoryStore, CountsWhatResourcesHold) {
    const Device device{DeviceOptions{}};
    {
        const Buffer one = makeBuffer(device, 1'000'000, kStorage, Access::readback, "one");
        const Buffer other = makeBuffer(device, 50'000'000, kStorage, Access::readback, "other");
        EXPECT_GE(device.memory().bytes(), 51'000'000u);
        EXPECT_LT(device.memory().bytes(), 51'100'000u);
    }
    EXPECT_EQ(device.memory().bytes(), 0u);
    EXPECT_GE(device.memory().peakBytes(), 51'000'000u);
}

TEST(MemoryStore, KeepsNoMoreThanItsShare) {
    const Device device{DeviceOptions{}};
    const auto memories = [&](std::size_t count) {
        constexpr vk::DeviceSize kEach = MemoryStore::kMostSpare / 8;
        std::vector<Buffer> buffers;
        for (std::size_t i = 0; i < count; ++i)
            buffers.push_back(makeBuffer(device, kEach, kStorage, Access::upload, "one of many"));
        std::vector<vk::DeviceMemory> all;
        for (const Buffer& buffer : buffers) all.push_back(memoryOf(buffer));
        return all;
    };
    const std::vector<vk::DeviceMemory> first = memories(12), second = memories(8);
    for (const vk::DeviceMemory memory : second)  // the newest 8 of 12 were kept
        EXPECT_NE(std::find(first.begin(), first.end(), memory), first.end());
}

}  // namespace
}  // namespace nacre::gpu
