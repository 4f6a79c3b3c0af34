#pragma once
// A command buffer with a pool of its own: what it took is given back by resetting the pool, which drivers answer
// faster than the reset of one buffer among others (VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, which Arm's and
// Khronos' best practices advise against).

#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Commands that are recorded in one go. They are one buffer, unless split() goes on in another: all of them are
/// submitted together, in their order.
class CommandBuffer {
public:
    CommandBuffer() = default;
    CommandBuffer(const vk::raii::Device& device, std::uint32_t queueFamily)
        : device_(&device), pool_(device, {vk::CommandPoolCreateFlagBits::eTransient, queueFamily}) {
        add();
    }

    explicit operator bool() const { return !buffers_.empty(); }
    /// The buffer that is being recorded.
    const vk::raii::CommandBuffer& operator*() const { return buffers_[at_]; }
    const vk::raii::CommandBuffer* operator->() const { return &buffers_[at_]; }
    vk::CommandPool pool() const { return *pool_; }
    std::span<const vk::CommandBuffer> handles() const { return {handles_.data(), at_ + 1}; }

    void begin() { buffers_[at_].begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit}); }
    void end() { buffers_[at_].end(); }
    /// What follows goes into a buffer of its own.
    void split() {
        end();
        if (++at_ == buffers_.size()) add();
        begin();
        draws = false;
    }
    /// Forgets what was recorded, none of which may be in flight.
    void reset() {
        pool_.reset();
        at_ = 0;
        draws = false;
    }

    bool draws = false;  ///< the buffer that is being recorded has draws

private:
    void add() {
        vk::raii::CommandBuffers made(*device_, {*pool_, vk::CommandBufferLevel::ePrimary, 1});
        buffers_.push_back(std::move(made[0]));
        handles_.push_back(*buffers_.back());
    }

    const vk::raii::Device* device_ = nullptr;
    vk::raii::CommandPool pool_{nullptr};  // outlives the buffers
    std::vector<vk::raii::CommandBuffer> buffers_;
    std::vector<vk::CommandBuffer> handles_;
    std::size_t at_ = 0;
};

}  // namespace nacre::gpu
