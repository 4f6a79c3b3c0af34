#include "engine/passes/fragment_counter.h"

#include <algorithm>
#include <cstring>

namespace nacre::passes {
namespace {

constexpr std::size_t kSlots = 16;
constexpr vk::DeviceSize kStride = 256;  // the floor's storage buffer offset alignment

}  // namespace

FragmentCounter::FragmentCounter(const gpu::Device& device, bool enabled) : enabled_(enabled) {
    if (!enabled) return;
    buffer_ = gpu::makeBuffer(device, kSlots * kStride, vk::BufferUsageFlagBits::eStorageBuffer, gpu::Access::readback,
                              "fragment counters");
    std::memset(buffer_.mapped, 0, buffer_.size);
}

void FragmentCounter::attach(Draw& draw) {
    if (!enabled_) return;
    if (std::find(used_.begin(), used_.end(), draw.writes) == used_.end()) used_.push_back(draw.writes);
    draw.counter = &buffer_;
    draw.counterOffset = static_cast<vk::DeviceSize>(draw.writes) * kStride;
}

void FragmentCounter::finish(const vk::raii::CommandBuffer& commands) const {
    if (!enabled_) return;
    const vk::MemoryBarrier barrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eFragmentShader, vk::PipelineStageFlagBits::eHost, {}, barrier,
                             {}, {});
}

std::vector<PassCount> FragmentCounter::counts() const {
    std::vector<PassCount> counts;
    for (const Writes writes : used_) {
        std::uint32_t shaded = 0;
        std::memcpy(&shaded, buffer_.mapped + static_cast<std::size_t>(writes) * kStride, sizeof(shaded));
        counts.push_back({nameOf(writes), shaded});
    }
    return counts;
}

}  // namespace nacre::passes
