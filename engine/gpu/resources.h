#pragma once
// Buffers and images with their memory. One allocation each: the renderer holds a few dozen.

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/graph/graph.h"

namespace nacre::gpu {

/// Counts device memory from allocation to the end of its life.
class Memory {
public:
    Memory() = default;
    Memory(const Device& device, vk::raii::DeviceMemory memory, std::uint64_t bytes)
        : device_(&device), memory_(std::move(memory)), bytes_(bytes) {}
    Memory(Memory&& other) noexcept { *this = std::move(other); }
    Memory& operator=(Memory&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(memory_, other.memory_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }
    ~Memory() {
        if (device_) device_->release(bytes_);
    }
    const vk::raii::DeviceMemory& operator*() const { return memory_; }
    const Device* device() const { return device_; }
    std::uint64_t bytes() const { return bytes_; }

private:
    const Device* device_ = nullptr;
    vk::raii::DeviceMemory memory_{nullptr};
    std::uint64_t bytes_ = 0;
};

/// A buffer that the host can write and read through `mapped`. Device-local too where memory is shared.
struct Buffer {
    Memory memory;
    vk::raii::Buffer handle{nullptr};
    std::byte* mapped = nullptr;
    vk::DeviceSize size = 0;
    bool coherent = true;  ///< else what one side writes is the other's to see by flush() and invalidate() alone

    /// The host is about to read what the device wrote, and is done with. Behind a barrier to the host.
    void invalidate() const;
    /// The host wrote what the device is about to read.
    void flush() const;
};

/// Who reads. Memory that the host caches not is slow to read from, on Arm's phones by far; what it only writes is
/// best kept where caches do not get in the way.
enum class Access {
    upload,    ///< the device: coherent
    readback,  ///< the host, too: cached, and coherent where there is such memory
};

/// @throws Error if no buffer of a device is so large @param name  what it would be
void checkBuffer(const Caps& caps, vk::DeviceSize size, const std::string& name);

/// @throws Error if it is too large for the device, or there is no memory
/// @param size bytes; 0 makes a buffer of the smallest size, so that empty streams can be bound
Buffer makeBuffer(const Device& device, vk::DeviceSize size, vk::BufferUsageFlags usage, Access access,
                  const std::string& name);

/// A buffer with contents.
template <typename T>
Buffer makeBuffer(const Device& device, std::span<const T> contents, vk::BufferUsageFlags usage,
                  const std::string& name) {
    Buffer buffer = makeBuffer(device, contents.size_bytes(), usage, Access::upload, name);
    if (!contents.empty()) std::memcpy(buffer.mapped, contents.data(), contents.size_bytes());
    return buffer;
}

/// A buffer's contents as texels. @param buffer  outlives it, and has a texel buffer's usage
vk::raii::BufferView makeTexelView(const Device& device, const Buffer& buffer, vk::Format format,
                                   const std::string& name);

struct Image {
    Memory memory;
    bool lazy = false;  ///< its memory is lazily allocated: bytes of it are there only once something needs them
    vk::raii::Image handle{nullptr};
    vk::raii::ImageView view{nullptr};
    graph::ImageDesc desc;
};

/// What nothing that is recorded from now on uses, and what is in flight still may: lives until that is done.
struct Retired {
    std::vector<Image> images;
    std::vector<vk::raii::Framebuffer> framebuffers;
    std::vector<std::shared_ptr<const void>> others;
};

/// An image that someone else owns.
struct ImageRef {
    vk::Image handle;
    vk::ImageView view;  ///< null if the image is only copied
    ImageRef() = default;
    ImageRef(vk::Image image, vk::ImageView imageView) : handle(image), view(imageView) {}
    ImageRef(const Image& image) : handle(*image.handle), view(*image.view) {}
};

/// @param transient ask for lazily allocated memory
Image makeImage(const Device& device, const graph::ImageDesc& desc, vk::ImageUsageFlags usage, bool transient,
                const std::string& name);

vk::raii::Sampler makeSampler(const Device& device, vk::Filter filter, const std::string& name);

}  // namespace nacre::gpu
