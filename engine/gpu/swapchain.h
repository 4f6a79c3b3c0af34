#pragma once
// The images of a window, presented in order (FIFO).

#include <functional>
#include <memory>
#include <optional>

#include "engine/gpu/present_wait.h"
#include "engine/gpu/resources.h"

namespace nacre::gpu {

class Swapchain {
public:
    /// @throws Error if this device cannot present to the window
    Swapchain(const Device& device, const SurfaceSource& source);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;

    /// Makes new images for the window's current size; none while it has no area. Nothing may be in flight, unless the
    /// images retire(). @param wanted pixels of the upright picture, for surfaces that leave their size to the
    /// swapchain
    void recreate(graph::Extent wanted);
    /// Replaced images live until the display is done with them (VK_EXT_swapchain_maintenance1).
    bool retires() const { return device_.maintainsSwapchains() && whole_; }
    /// If images retire: hold this while drawing into the current ones.
    std::shared_ptr<const void> drawnInto() const { return drawnInto_; }
    /// Gives back an image that was acquired and never drawn into, before recreate(). Only if images retire.
    void giveBack(std::uint32_t index);
    /// Releases the surface, as an app must when its window goes; recreate() asks for another.
    void release();

    bool ready() const { return static_cast<bool>(*swapchain_); }
    /// recreate() must be called before the next image.
    bool stale() const { return stale_; }

    graph::Extent extent() const { return extent_; }    ///< in image pixels
    graph::Extent upright() const { return upright_; }  ///< of the picture as seen
    int quarterTurns() const { return quarterTurns_; }
    VkFormat format() const { return static_cast<VkFormat>(format_.format); }

    /// A frame starts: waits for the display where that leaves the rate as it is. The swapchain may become stale.
    void awaitDisplay();
    WindowPace pace() const { return display_.pace(); }
    /// Index of the next image, or nothing if the swapchain has become stale.
    std::optional<std::uint32_t> acquire(vk::Semaphore signal);
    ImageRef image(std::uint32_t index) const;
    /// Signalled by the submission that draws an image; present() waits for it.
    vk::Semaphore drawn(std::uint32_t index) const { return *images_[index].drawn; }
    void present(std::uint32_t index);

private:
    struct WindowImage {
        vk::Image handle;
        vk::raii::ImageView view;
        vk::raii::Semaphore drawn;
        vk::raii::Fence shown{nullptr};  ///< signalled when the display has released the image, where reported
        bool presented = false;          ///< `shown` is signalled or will be
    };
    struct Former {
        vk::raii::SwapchainKHR swapchain;
        std::vector<WindowImage> images;
        std::shared_ptr<const void> drawnInto;
    };
    void makeSurface();
    void chooseFormat(vk::SurfaceKHR surface);
    void build(const vk::SurfaceCapabilitiesKHR& caps, vk::SwapchainKHR before);
    WindowImage windowImage(vk::Image image) const;
    void retire();
    void dropFormers(bool wait);
    void awaitShown(WindowImage& image, std::uint64_t nanoseconds) const;
    /// Call when the image was queued, even if it is never shown.
    void enqueued(WindowImage& image) {
        image.presented = static_cast<bool>(*image.shown);
        whole_ = true;
    }

    const Device& device_;
    std::function<VkSurfaceKHR(VkInstance)> create_;
    DisplayWait display_;
    vk::raii::SurfaceKHR surface_{nullptr};
    vk::SurfaceFormatKHR format_;
    vk::raii::SwapchainKHR swapchain_{nullptr};
    std::vector<WindowImage> images_;
    std::shared_ptr<const void> drawnInto_ = std::make_shared<int>();
    std::vector<Former> formers_;
    bool whole_ = true;  ///< every acquired image was presented
    graph::Extent extent_, upright_;
    int quarterTurns_ = 0;
    bool stale_ = true;
};

}  // namespace nacre::gpu
