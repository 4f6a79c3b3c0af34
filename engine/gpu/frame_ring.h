#pragma once
// Frames that the host records while the device draws the previous one: at most two in flight.

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/resources.h"
#include "engine/gpu/timer.h"

namespace nacre::gpu {

struct FrameSlot {
    CommandBuffer commands;
    vk::raii::Fence done{nullptr};
    bool submitted = false;                 ///< `done` is signalled when it completes
    vk::raii::Semaphore acquired{nullptr};  ///< signalled when the window's image can be drawn into
    DescriptorPool descriptors;
    Timer timer;                                      ///< of the commands
    bool timed = false;                               ///< the timer was used
    Buffer vertices, indices;                         ///< of the overlay over the picture
    std::array<std::shared_ptr<const void>, 2> held;  ///< resources in use by the commands
    Retired retired;                                  ///< resources of earlier commands
    std::optional<std::uint32_t> image;               ///< acquired window image, not yet submitted
    std::optional<std::uint32_t> drawn;               ///< window image that the commands draw into
    explicit FrameSlot(const Device& device) : descriptors(device), timer(device) {}
};

class FrameRing {
public:
    static constexpr std::size_t kInFlight = 2;

    explicit FrameRing(const Device& device);
    ~FrameRing();

    /// The next frame's slot. Waits until the frame before last, which used it, is done.
    FrameSlot& next();
    /// GPU time of the last timed frame that is done; 0: unknown.
    double milliseconds() const { return milliseconds_; }
    /// Submits the slot's commands: they wait for `acquired` where colour is written, and signal `drawn`. After a
    /// failure next() returns the same slot with its image, for another try.
    void submit(FrameSlot& slot, vk::Semaphore drawn);
    /// As above without a window's image: no semaphores.
    void submit(FrameSlot& slot);
    /// Gives up an acquired window image that was not drawn into. Waits only for an earlier frame that drew into it.
    /// @returns its index, to be given back to the swapchain
    std::optional<std::uint32_t> skipImage();
    /// Call before the window's images are destroyed: waits for everything and drops an acquired image that was not
    /// drawn into.
    void dropImage() noexcept;

private:
    void submit(FrameSlot& slot, std::span<const vk::CommandBuffer> commands, std::span<const vk::Semaphore> waits,
                std::span<const vk::Semaphore> signals);

    const Device& device_;
    std::array<FrameSlot, kInFlight> slots_;
    std::size_t at_ = 0;
    double milliseconds_ = 0;
};

}  // namespace nacre::gpu
