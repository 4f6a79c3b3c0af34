#include "engine/gpu/frame_ring.h"

#include "engine/error.h"

namespace nacre::gpu {

FrameRing::FrameRing(const Device& device) : device_(device), slots_{FrameSlot(device), FrameSlot(device)} {
    for (std::size_t i = 0; i < kInFlight; ++i) {
        slots_[i].commands = CommandBuffer(*device, device.queueFamily());
        device.name(slots_[i].commands.pool(), "frame " + std::to_string(i));
        slots_[i].done = vk::raii::Fence(*device, vk::FenceCreateInfo());
        device.name(*slots_[i].done, "frame " + std::to_string(i) + " is done");
    }
}

FrameRing::~FrameRing() { device_.settle(); }

FrameSlot& FrameRing::next() {
    FrameSlot& slot = slots_[at_];
    if (slot.submitted && device_->waitForFences(*slot.done, true, UINT64_MAX) != vk::Result::eSuccess)
        throw Error("the device stopped", device_.caps().deviceName, "waiting for a frame failed");
    if (slot.submitted && slot.timed) milliseconds_ = slot.timer.milliseconds().value_or(0);
    slot.submitted = false;
    slot.retired = {};
    slot.descriptors.reset();
    if (!*slot.acquired) {
        slot.acquired = vk::raii::Semaphore(*device_, vk::SemaphoreCreateInfo());
        device_.name(*slot.acquired, "frame " + std::to_string(at_) + " has a window image");
    }
    return slot;
}

void FrameRing::submit(FrameSlot& slot, std::span<const vk::CommandBuffer> commands,
                       std::span<const vk::Semaphore> waits, std::span<const vk::Semaphore> signals) {
    // A fence that was reset and not submitted is never signalled: do not wait for it.
    slot.submitted = false;
    device_->resetFences(*slot.done);
    const vk::PipelineStageFlags stage = vk::PipelineStageFlagBits::eColorAttachmentOutput;
    vk::SubmitInfo info({}, {}, commands, signals);
    info.setWaitSemaphores(waits).setPWaitDstStageMask(&stage);
    device_.submit(info, *slot.done);
    slot.submitted = true;
    slot.image.reset();
    at_ = (at_ + 1) % kInFlight;
}

void FrameRing::submit(FrameSlot& slot, vk::Semaphore drawn) {
    slot.drawn = slot.image;
    const vk::Semaphore acquired = *slot.acquired;
    submit(slot, slot.commands.handles(), {&acquired, 1}, {&drawn, 1});
}

void FrameRing::submit(FrameSlot& slot) { submit(slot, slot.commands.handles(), {}, {}); }

std::optional<std::uint32_t> FrameRing::skipImage() {
    FrameSlot& slot = slots_[at_];
    const std::optional<std::uint32_t> image = slot.image;
    if (!image) return image;
    slot.drawn.reset();
    const vk::Semaphore acquired = *slot.acquired;
    submit(slot, {}, {&acquired, 1}, {});  // a signalled semaphore must be waited for before it is signalled again
    for (const FrameSlot& other : slots_)
        if (other.submitted && other.drawn == image &&
            device_->waitForFences(*other.done, true, UINT64_MAX) != vk::Result::eSuccess)
            throw Error("the device stopped", device_.caps().deviceName, "waiting for a frame failed");
    return image;
}

void FrameRing::dropImage() noexcept {
    FrameSlot& slot = slots_[at_];
    device_.settle();
    if (!slot.image) return;
    slot.acquired = nullptr;  // signalled, and nothing will wait for it
    slot.image.reset();
}

}  // namespace nacre::gpu
