#pragma once
// Frames that the host records while the device still draws the one before: at most two in flight.

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
    bool submitted = false;                 ///< and `done` tells when it is done
    vk::raii::Semaphore acquired{nullptr};  ///< the window's image may be drawn into
    DescriptorPool descriptors;
    Timer timer;                         ///< of the commands, where it was begun
    bool timed = false;                  ///< it was
    Buffer vertices, indices;            ///< of what is drawn over the picture
    std::shared_ptr<const void> held;    ///< what the commands use, until they are done
    Retired retired;                     ///< what earlier ones used
    std::optional<std::uint32_t> image;  ///< of the window, acquired for commands that were not submitted since
    std::optional<std::uint32_t> drawn;  ///< the one that the commands draw into
    explicit FrameSlot(const Device& device) : descriptors(device), timer(device) {}
};

class FrameRing {
public:
    static constexpr std::size_t kInFlight = 2;

    explicit FrameRing(const Device& device);
    ~FrameRing();

    /// The slot of the next frame, free of what the frame before last left in it. Waits until that one is done.
    FrameSlot& next();
    /// What the device took for the last timed frame that is known to be done; 0: nobody knows.
    double milliseconds() const { return milliseconds_; }
    /// Submits the slot's commands: they wait for `acquired` where colour is written, and signal `drawn`. If that
    /// fails, the slot is what next() gives again, and may try again with the image that it has.
    void submit(FrameSlot& slot, vk::Semaphore drawn);
    /// Gives up the window's image that was acquired and not drawn into, if there is one. Waits for a frame that was
    /// drawn into it before, and for nothing else. @returns which, for whoever takes it back
    std::optional<std::uint32_t> skipImage();
    /// The window's images are about to go: waits for everything, and forgets the one that was acquired and not drawn
    /// into.
    void dropImage() noexcept;

private:
    void submit(FrameSlot& slot, std::span<const vk::CommandBuffer> commands, std::span<const vk::Semaphore> signals);

    const Device& device_;
    std::array<FrameSlot, kInFlight> slots_;
    std::size_t at_ = 0;
    double milliseconds_ = 0;
};

}  // namespace nacre::gpu
