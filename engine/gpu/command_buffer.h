#pragma once
// A command buffer with a pool of its own: what it took is given back by resetting the pool, which drivers answer
// faster than the reset of one buffer among others (VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, which Arm's and
// Khronos' best practices advise against).

#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

class CommandBuffer {
public:
    CommandBuffer() = default;
    CommandBuffer(const vk::raii::Device& device, std::uint32_t queueFamily)
        : pool_(device, {vk::CommandPoolCreateFlagBits::eTransient, queueFamily}) {
        vk::raii::CommandBuffers buffers(device, {*pool_, vk::CommandBufferLevel::ePrimary, 1});
        buffer_ = std::move(buffers[0]);
    }

    explicit operator bool() const { return static_cast<bool>(*buffer_); }
    const vk::raii::CommandBuffer& operator*() const { return buffer_; }
    const vk::raii::CommandBuffer* operator->() const { return &buffer_; }
    vk::CommandPool pool() const { return *pool_; }
    /// Forgets what was recorded, none of which may be in flight.
    void reset() const { pool_.reset(); }

private:
    vk::raii::CommandPool pool_{nullptr};  // outlives the buffer
    vk::raii::CommandBuffer buffer_{nullptr};
};

}  // namespace nacre::gpu
