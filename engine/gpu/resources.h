#pragma once
// Buffers and images with their memory. Each has its own allocation (memory_store.h): the renderer holds a few dozen.

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/graph/graph.h"

namespace nacre::gpu {

/// A resource's device memory, which goes back to the device's store.
class Memory {
public:
    Memory() = default;
    Memory(const Device& device, HeldMemory held) : device_(&device), held_(std::move(held)) {}
    Memory(Memory&& other) noexcept { *this = std::move(other); }
    Memory& operator=(Memory&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(held_, other.held_);
        return *this;
    }
    ~Memory() {
        if (device_) device_->memory().giveBack(std::move(held_));
    }
    const vk::raii::DeviceMemory& operator*() const { return held_.memory; }
    const Device* device() const { return device_; }
    std::uint64_t bytes() const { return held_.used; }
    /// The whole memory as the host sees it.
    std::byte* map() {
        if (!held_.mapped) held_.mapped = static_cast<std::byte*>(held_.memory.mapMemory(0, VK_WHOLE_SIZE));
        return held_.mapped;
    }

private:
    const Device* device_ = nullptr;
    HeldMemory held_;
};

/// A buffer that the host reads and writes through `mapped`; also device-local where memory is shared.
struct Buffer {
    Memory memory;
    vk::raii::Buffer handle{nullptr};
    std::byte* mapped = nullptr;
    vk::DeviceSize size = 0;
    bool coherent = true;  ///< false: flush() and invalidate() are needed

    /// Call before the host reads what the device wrote. The device must be done, with a barrier to the host.
    void invalidate() const;
    /// Call after the host wrote, before the device reads.
    void flush() const;
};

/// The side that reads. Reading uncached memory is slow for the host, particularly on Arm. Memory that the host only
/// writes is best uncached.
enum class Access {
    upload,    ///< device: coherent
    readback,  ///< host too: cached, and coherent where available
};

/// @throws Error if the device allows no buffer this large @param name  of the buffer, for the message
void checkBuffer(const Caps& caps, vk::DeviceSize size, const std::string& name);

/// @throws Error if it is too large for the device, or memory runs out
/// @param size bytes; 0 makes the smallest buffer, so that empty streams can be bound
Buffer makeBuffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, Access access,
                  const std::string& name);

/// A buffer with these contents.
template <typename T>
Buffer makeBuffer(const Device& device, std::span<const T> contents, vk::BufferUsageFlags usage,
                  const std::string& name) {
    Buffer buffer = makeBuffer(device, contents.size_bytes(), usage, Access::upload, name);
    if (!contents.empty()) std::memcpy(buffer.mapped, contents.data(), contents.size_bytes());
    return buffer;
}

/// A buffer's contents as texels. @param buffer  outlives the view, and has a texel buffer's usage
vk::raii::BufferView makeTexelView(const Device& device, const Buffer& buffer, vk::Format format,
                                   const std::string& name);

struct Image {
    Memory memory;
    bool lazy = false;  ///< lazily allocated memory: backed only once it is needed
    vk::raii::Image handle{nullptr};
    vk::raii::ImageView view{nullptr};
    graph::ImageDesc desc;
};

/// Keeps objects that new recordings no longer use until everything in flight is done.
struct Retired {
    std::vector<Image> images;
    std::vector<vk::raii::Framebuffer> framebuffers;
    std::vector<std::shared_ptr<const void>> others;
};

/// An image owned elsewhere.
struct ImageRef {
    vk::Image handle;
    vk::ImageView view;            ///< null if the image is only copied
    std::uint32_t firstLayer = 0;  ///< of the view
    ImageRef() = default;
    ImageRef(vk::Image image, vk::ImageView imageView, std::uint32_t first = 0)
        : handle(image), view(imageView), firstLayer(first) {}
    ImageRef(const Image& image) : handle(*image.handle), view(*image.view) {}
};

/// @param transient ask for lazily allocated memory
Image makeImage(const Device& device, const graph::ImageDesc& desc, vk::ImageUsageFlags usage, bool transient,
                const std::string& name);

vk::raii::Sampler makeSampler(const Device& device, vk::Filter filter, const std::string& name);

}  // namespace nacre::gpu
