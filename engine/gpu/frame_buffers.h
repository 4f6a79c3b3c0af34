#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/resources.h"

namespace nacre::gpu {

/// What frames upload anew, each into a buffer of its own while it is in flight. One that no frame holds any more is
/// used again, so that steady frames make none.
class FrameBuffers {
public:
    FrameBuffers(const Device& device, vk::BufferUsageFlags usage, std::string name)
        : device_(device), usage_(usage), name_(std::move(name)) {}

    /// A buffer with contents. It is whoever's holds it until nobody does.
    std::shared_ptr<const Buffer> upload(std::span<const std::byte> contents);

private:
    const Device& device_;
    vk::BufferUsageFlags usage_;
    std::string name_;
    std::vector<std::shared_ptr<Buffer>> buffers_;
};

}  // namespace nacre::gpu
