// Memory of resources that are made again, as for each picture of a batch.

#include "engine/gpu/memory_store.h"

#include <gtest/gtest.h>

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
    const MemoryStore& store = device.memory();
    const vk::DeviceSize before = store.spareBytes(), each = store.mostSpare() / 8;
    const auto make = [&](std::size_t count, vk::DeviceSize size) {
        std::vector<Buffer> buffers;
        for (std::size_t i = 0; i < count; ++i)
            buffers.push_back(makeBuffer(device, size, kStorage, Access::upload, "one of many"));
        return buffers;
    };
    make(4, each);
    EXPECT_EQ(store.spareBytes(), before + 4 * each);
    make(12, each);
    EXPECT_EQ(store.spareBytes(), store.mostSpare());
    {
        const std::vector<Buffer> again = make(8, each);
        EXPECT_EQ(store.spareBytes(), 0u);
    }
    EXPECT_EQ(store.spareBytes(), store.mostSpare());
    make(1, 4 * each);  // larger than what is kept
    EXPECT_EQ(store.spareBytes(), store.mostSpare());
}

TEST(MemoryStore, KeepsLittleWhereHostAndDeviceShareTheirMemory) {
    vk::PhysicalDeviceMemoryProperties memory;
    memory.memoryHeapCount = 2;
    memory.memoryHeaps[0].flags = vk::MemoryHeapFlagBits::eDeviceLocal;
    EXPECT_EQ(spareMemory(memory), 32u << 20);  // a graphics card
    memory.memoryHeaps[1].flags = vk::MemoryHeapFlagBits::eDeviceLocal;
    EXPECT_EQ(spareMemory(memory), 8u << 20);  // a phone
}

}  // namespace
}  // namespace nacre::gpu
