#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "engine/gpu/pool.h"
#include "engine/gpu/resources.h"

namespace nacre::gpu {

/// Buffers for data that frames upload anew: one per upload while it is in flight.
class FrameBuffers {
public:
    FrameBuffers(const Device& device, vk::BufferUsageFlags usage, std::string name)
        : device_(device), usage_(usage), name_(std::move(name)) {}

    /// A buffer with these contents. It is free for reuse when its last holder releases it.
    std::shared_ptr<const Buffer> upload(std::span<const std::byte> contents) {
        const std::shared_ptr<Buffer>& buffer = buffers_.free();
        if (buffer->size < contents.size() || !buffer->mapped) {
            *buffer = {};
            *buffer = makeBuffer(device_, contents.size(), usage_, Access::upload, name_);
        }
        std::copy(contents.begin(), contents.end(), buffer->mapped);
        return buffer;
    }

private:
    const Device& device_;
    vk::BufferUsageFlags usage_;
    std::string name_;
    Pool<Buffer> buffers_;
};

}  // namespace nacre::gpu
