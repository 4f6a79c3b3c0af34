#include "engine/gpu/frame_buffers.h"

#include <algorithm>

namespace nacre::gpu {

std::shared_ptr<const Buffer> FrameBuffers::upload(std::span<const std::byte> contents) {
    auto free = std::find_if(buffers_.begin(), buffers_.end(), [](const auto& b) { return b.use_count() == 1; });
    if (free == buffers_.end()) free = buffers_.insert(free, std::make_shared<Buffer>());
    Buffer& buffer = **free;
    if (buffer.size < contents.size() || !buffer.mapped) {
        buffer = {};
        buffer = makeBuffer(device_, contents.size(), usage_, Access::upload, name_);
    }
    std::copy(contents.begin(), contents.end(), buffer.mapped);
    return *free;
}

}  // namespace nacre::gpu
