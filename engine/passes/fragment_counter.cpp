#include "engine/passes/fragment_counter.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace nacre::passes {
namespace {

constexpr std::size_t kSlots = 16;
constexpr vk::DeviceSize kStride = 256;  // the floor's storage buffer offset alignment

}  // namespace

FragmentCounter::FragmentCounter(const gpu::Device& device)
    : buffer_(gpu::makeBuffer(device, kSlots * kStride, vk::BufferUsageFlagBits::eStorageBuffer, gpu::Access::readback,
                              "fragment counters")) {
    std::memset(buffer_.mapped, 0, buffer_.size);
    buffer_.flush();
}

vk::DescriptorBufferInfo FragmentCounter::slot(std::string_view pass) {
    auto it = std::find(passes_.begin(), passes_.end(), pass);
    if (it == passes_.end()) {
        if (passes_.size() == kSlots) throw std::logic_error("more passes than fragment counters");
        it = passes_.emplace(passes_.end(), pass);
    }
    return {*buffer_.handle, static_cast<vk::DeviceSize>(it - passes_.begin()) * kStride, sizeof(std::uint32_t)};
}

void FragmentCounter::finish(const vk::raii::CommandBuffer& commands) const {
    const vk::MemoryBarrier barrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eFragmentShader | vk::PipelineStageFlagBits::eComputeShader,
                             vk::PipelineStageFlagBits::eHost, {}, barrier, {}, {});
}

std::vector<PassCount> FragmentCounter::counts() const {
    std::vector<PassCount> counts;
    buffer_.invalidate();
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        std::uint32_t shaded = 0;
        std::memcpy(&shaded, buffer_.mapped + i * kStride, sizeof(shaded));
        counts.push_back({passes_[i], shaded});
    }
    return counts;
}

}  // namespace nacre::passes
