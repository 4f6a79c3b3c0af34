#include "engine/gpu/frame_ring.h"

#include "engine/error.h"

namespace nacre::gpu {

FrameRing::FrameRing(const Device& device)
    : device_(device),
      pool_(*device, vk::CommandPoolCreateInfo(
                         vk::CommandPoolCreateFlagBits::eResetCommandBuffer | vk::CommandPoolCreateFlagBits::eTransient,
                         device.queueFamily())),
      slots_{FrameSlot(device), FrameSlot(device)} {
    device.name(*pool_, "frames");
    vk::raii::CommandBuffers buffers(*device, {*pool_, vk::CommandBufferLevel::ePrimary, kInFlight});
    for (std::size_t i = 0; i < kInFlight; ++i) {
        slots_[i].commands = std::move(buffers[i]);
        slots_[i].done = vk::raii::Fence(*device, vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled));
        slots_[i].acquired = vk::raii::Semaphore(*device, vk::SemaphoreCreateInfo());
        const std::string frame = "frame " + std::to_string(i);
        device.name(*slots_[i].done, frame + " is done");
        device.name(*slots_[i].acquired, frame + " has a window image");
    }
}

FrameRing::~FrameRing() {
    try {
        device_->waitIdle();
    } catch (const vk::SystemError&) {
        // A device that is lost has nothing in flight any more.
    }
}

FrameSlot& FrameRing::next() {
    FrameSlot& slot = slots_[at_];
    if (device_->waitForFences(*slot.done, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error("the device stopped", device_.caps().deviceName, "waiting for a frame failed");
    slot.descriptors.reset();
    return slot;
}

void FrameRing::submit(FrameSlot& slot, vk::Semaphore drawn) {
    device_->resetFences(*slot.done);
    const vk::Semaphore acquired = *slot.acquired;
    const vk::CommandBuffer commands = *slot.commands;
    const vk::PipelineStageFlags stage = vk::PipelineStageFlagBits::eColorAttachmentOutput;
    device_.queue().submit(vk::SubmitInfo(acquired, stage, commands, drawn), *slot.done);
    at_ = (at_ + 1) % kInFlight;
}

}  // namespace nacre::gpu
