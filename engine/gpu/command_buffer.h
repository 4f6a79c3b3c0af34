#pragma once
// A command buffer with its own pool. Resetting the pool frees its memory, which is faster than resetting single
// buffers (VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT; Arm's and Khronos' best practices advise against that
// flag).

#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace nacre::gpu {

/// Commands recorded together. They form one buffer unless split() starts another; all are submitted together, in
/// order.
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
    /// Following commands go into a new buffer.
    void split() {
        end();
        if (++at_ == buffers_.size()) add();
        begin();
        draws = false;
    }
    /// Discards what was recorded. None of it may be in flight.
    void reset() {
        pool_.reset();
        at_ = 0;
        draws = false;
    }

    bool draws = false;  ///< the current buffer contains draws

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
