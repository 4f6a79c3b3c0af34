#include "engine/gpu/swapchain.h"

#include <algorithm>

#include "engine/error.h"

namespace nacre::gpu {
namespace {

constexpr std::uint32_t kImages = 3;

/// What the renderer can write; sRGB first, whose hardware codes colour as picture files have it.
constexpr vk::Format kFormats[] = {vk::Format::eB8G8R8A8Srgb, vk::Format::eR8G8B8A8Srgb, vk::Format::eB8G8R8A8Unorm,
                                   vk::Format::eR8G8B8A8Unorm};

}  // namespace

int quarterTurnsOf(vk::SurfaceTransformFlagBitsKHR transform) {
    switch (transform) {
        case vk::SurfaceTransformFlagBitsKHR::eRotate90:
            return 1;
        case vk::SurfaceTransformFlagBitsKHR::eRotate180:
            return 2;
        case vk::SurfaceTransformFlagBitsKHR::eRotate270:
            return 3;
        default:
            return 0;
    }
}

Swapchain::Swapchain(const Device& device, std::function<VkSurfaceKHR(VkInstance)> create)
    : device_(device), create_(std::move(create)) {
    makeSurface();
}

Swapchain::~Swapchain() = default;

void Swapchain::makeSurface() {
    vk::raii::SurfaceKHR surface(device_.instance(), create_(*device_.instance()));
    if (!device_.physical().getSurfaceSupportKHR(device_.queueFamily(), *surface))
        throw Error("cannot open a window", device_.caps().deviceName, "this device does not draw into windows here");
    chooseFormat(*surface);
    surface_ = std::move(surface);
}

void Swapchain::chooseFormat(vk::SurfaceKHR surface) {
    const auto formats = device_.physical().getSurfaceFormatsKHR(surface);
    for (const vk::Format wanted : kFormats)
        for (const vk::SurfaceFormatKHR& f : formats)
            if (f.format == wanted && f.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) {
                format_ = f;
                return;
            }
    throw Error("cannot open a window", device_.caps().deviceName, "its windows have no 8-bit sRGB format");
}

void Swapchain::release() {
    images_.clear();
    swapchain_ = nullptr;
    surface_ = nullptr;
    stale_ = true;
}

void Swapchain::recreate(graph::Extent wanted) {
    images_.clear();
    stale_ = true;  // until all of it is there
    for (int attempt = 0;; ++attempt) {
        if (!*surface_) makeSurface();
        try {
            vk::SurfaceCapabilitiesKHR caps = device_.physical().getSurfaceCapabilitiesKHR(*surface_);
            constexpr std::uint32_t kUpToUs = 0xffffffffu;
            if (caps.currentExtent.width == kUpToUs)
                caps.currentExtent =
                    vk::Extent2D(std::clamp(wanted.width, caps.minImageExtent.width, caps.maxImageExtent.width),
                                 std::clamp(wanted.height, caps.minImageExtent.height, caps.maxImageExtent.height));
            upright_ = {caps.currentExtent.width, caps.currentExtent.height};
            if (upright_.width == 0 || upright_.height == 0) {
                swapchain_ = nullptr;
                return;
            }
            build(caps);
            stale_ = false;
            return;
        } catch (const vk::SurfaceLostKHRError&) {
            if (attempt) throw Error("cannot draw into the window", device_.caps().deviceName, "its surface was lost");
            release();
        }
    }
}

void Swapchain::build(const vk::SurfaceCapabilitiesKHR& caps) {
    quarterTurns_ = quarterTurnsOf(caps.currentTransform);
    extent_ = upright_;
    if (quarterTurns_ % 2) std::swap(extent_.width, extent_.height);
    std::uint32_t count = std::max(kImages, caps.minImageCount);
    if (caps.maxImageCount) count = std::min(count, caps.maxImageCount);
    const auto alpha = caps.supportedCompositeAlpha & vk::CompositeAlphaFlagBitsKHR::eOpaque
                           ? vk::CompositeAlphaFlagBitsKHR::eOpaque
                           : vk::CompositeAlphaFlagBitsKHR::eInherit;
    const vk::raii::SwapchainKHR old = std::move(swapchain_);
    const vk::SwapchainCreateInfoKHR info(
        {}, *surface_, count, format_.format, format_.colorSpace, {extent_.width, extent_.height}, 1,
        vk::ImageUsageFlagBits::eColorAttachment, vk::SharingMode::eExclusive, {},
        quarterTurns_ ? caps.currentTransform : vk::SurfaceTransformFlagBitsKHR::eIdentity, alpha,
        vk::PresentModeKHR::eFifo, true, *old);
    swapchain_ = vk::raii::SwapchainKHR(*device_, info);
    device_.name(*swapchain_, "window images");
    for (const VkImage image : swapchain_.getImages()) {
        vk::raii::ImageView view(*device_, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format_.format,
                                                                   {}, {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
        vk::raii::Semaphore drawn(*device_, vk::SemaphoreCreateInfo());
        const std::string name = "window " + std::to_string(images_.size());
        device_.name(vk::Image(image), name);
        device_.name(*view, "view of " + name);
        device_.name(*drawn, name + " is drawn");
        images_.push_back({image, std::move(view), std::move(drawn)});
    }
}

ImageRef Swapchain::image(std::uint32_t index) const { return {images_[index].handle, *images_[index].view}; }

std::optional<std::uint32_t> Swapchain::acquire(vk::Semaphore signal) {
    try {
        const auto [result, index] = swapchain_.acquireNextImage(UINT64_MAX, signal, {});
        if (result == vk::Result::eSuboptimalKHR) stale_ = true;
        return index;
    } catch (const vk::OutOfDateKHRError&) {
        stale_ = true;
    } catch (const vk::SurfaceLostKHRError&) {
        device_.settle();
        release();
    }
    return std::nullopt;
}

void Swapchain::present(std::uint32_t index) {
    try {
        const vk::Semaphore drawnHere = drawn(index);
        const vk::SwapchainKHR swapchain = *swapchain_;
        if (device_.queue().presentKHR(vk::PresentInfoKHR(drawnHere, swapchain, index)) == vk::Result::eSuboptimalKHR)
            stale_ = true;
    } catch (const vk::OutOfDateKHRError&) {
        stale_ = true;
    } catch (const vk::SurfaceLostKHRError&) {
        device_.settle();
        release();
    } catch (...) {
        stale_ = true;  // the image stays acquired, and `drawn` signalled: neither can be used again
        throw;
    }
}

}  // namespace nacre::gpu
