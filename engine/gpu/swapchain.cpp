#include "engine/gpu/swapchain.h"

#include <algorithm>

#include "engine/error.h"

namespace nacre::gpu {
namespace {

constexpr std::uint32_t kImages = 3;

/// Formats that the renderer can write; sRGB first, whose hardware coding equals that of image files.
constexpr vk::Format kPictureFormats[] = {vk::Format::eB8G8R8A8Srgb, vk::Format::eR8G8B8A8Srgb,
                                          vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm};

/// Clockwise quarter turns that a surface's transform asks for; mirrored transforms count as upright.
int countQuarterTurns(vk::SurfaceTransformFlagBitsKHR transform) {
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

}  // namespace

Swapchain::Swapchain(const Device& device, const SurfaceSource& source)
    : device_(device), create_(source.create), display_(device, source.clock) {
    makeSurface();
}

Swapchain::~Swapchain() {
    retire();
    dropFormers(true);
}

void Swapchain::makeSurface() {
    vk::raii::SurfaceKHR surface(device_.instance(), create_(*device_.instance()));
    if (!device_.physical().getSurfaceSupportKHR(device_.queueFamily(), *surface))
        throw Error("cannot open a window", device_.caps().deviceName, "this device does not draw into windows here");
    chooseFormat(*surface);
    surface_ = std::move(surface);
    display_.setSurface(*surface_);
}

void Swapchain::chooseFormat(vk::SurfaceKHR surface) {
    const auto formats = device_.physical().getSurfaceFormatsKHR(surface);
    for (const vk::Format wanted : kPictureFormats)
        for (const vk::SurfaceFormatKHR& f : formats)
            if (f.format == wanted && f.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) {
                format_ = f;
                return;
            }
    throw Error("cannot open a window", device_.caps().deviceName, "its windows have no 8-bit sRGB format");
}

/// Waits until the display has released this image.
void Swapchain::awaitShown(WindowImage& image, std::uint64_t nanoseconds) const {
    if (!image.presented) return;
    if (device_->waitForFences(*image.shown, true, nanoseconds) == vk::Result::eSuccess) image.presented = false;
}

/// Marks the images as replaced: the window no longer shows them.
void Swapchain::retire() {
    if (*swapchain_) formers_.push_back({std::move(swapchain_), std::move(images_), std::move(drawnInto_)});
    images_.clear();
    swapchain_ = nullptr;
    drawnInto_ = std::make_shared<int>();
    whole_ = true;
}

/// Frees retired swapchains that the display has released. @param wait  for all, at most a moment each
void Swapchain::dropFormers(bool wait) {
    constexpr std::uint64_t kMoment = 1'000'000'000;
    std::erase_if(formers_, [&](Former& former) {
        for (WindowImage& image : former.images) try {
                awaitShown(image, wait ? kMoment : 0);
            } catch (const vk::SystemError&) {
                image.presented = false;  // the device is lost, so nothing is in flight
            }
        return wait ||
               (former.drawnInto.use_count() == 1 && std::ranges::none_of(former.images, &WindowImage::presented));
    });
}

void Swapchain::giveBack(std::uint32_t index) {
    device_->releaseSwapchainImagesEXT(vk::ReleaseSwapchainImagesInfoEXT(*swapchain_, 1, &index));
}

void Swapchain::release() {
    retire();
    dropFormers(true);
    surface_ = nullptr;
    stale_ = true;
}

void Swapchain::recreate(graph::Extent wanted) {
    const bool kept = retires();
    vk::SwapchainKHR before = *swapchain_;
    retire();
    stale_ = true;  // until creation has succeeded
    for (int attempt = 0;; ++attempt) {
        try {
            if (!*surface_) makeSurface();
            vk::SurfaceCapabilitiesKHR caps = device_.physical().getSurfaceCapabilitiesKHR(*surface_);
            constexpr std::uint32_t kUpToUs = 0xffffffffu;
            if (caps.currentExtent.width == kUpToUs)
                caps.currentExtent =
                    vk::Extent2D(std::clamp(wanted.width, caps.minImageExtent.width, caps.maxImageExtent.width),
                                 std::clamp(wanted.height, caps.minImageExtent.height, caps.maxImageExtent.height));
            upright_ = {caps.currentExtent.width, caps.currentExtent.height};
            const bool area = upright_.width > 0 && upright_.height > 0;
            if (area) build(caps, before);
            stale_ = !area;
            return dropFormers(!kept || !area);
        } catch (const vk::SurfaceLostKHRError&) {
            if (attempt) throw Error("cannot draw into the window", device_.caps().deviceName, "its surface was lost");
            release();
            before = nullptr;
        } catch (...) {
            dropFormers(true);  // a surface has one swapchain at a time, besides retired ones
            throw;
        }
    }
}

void Swapchain::build(const vk::SurfaceCapabilitiesKHR& caps, vk::SwapchainKHR before) {
    quarterTurns_ = countQuarterTurns(caps.currentTransform);
    extent_ = upright_;
    if (quarterTurns_ % 2) std::swap(extent_.width, extent_.height);
    std::uint32_t count = std::max(kImages, caps.minImageCount);
    if (caps.maxImageCount) count = std::min(count, caps.maxImageCount);
    const auto alpha = caps.supportedCompositeAlpha & vk::CompositeAlphaFlagBitsKHR::eOpaque
                           ? vk::CompositeAlphaFlagBitsKHR::eOpaque
                           : vk::CompositeAlphaFlagBitsKHR::eInherit;
    const vk::SwapchainCreateInfoKHR info(
        display_.swapchainFlags(), *surface_, count, format_.format, format_.colorSpace,
        {extent_.width, extent_.height}, 1, vk::ImageUsageFlagBits::eColorAttachment, vk::SharingMode::eExclusive, {},
        quarterTurns_ ? caps.currentTransform : vk::SurfaceTransformFlagBitsKHR::eIdentity, alpha,
        vk::PresentModeKHR::eFifo, true, before);
    swapchain_ = vk::raii::SwapchainKHR(*device_, info);
    display_.replaced();
    device_.name(*swapchain_, "window images");
    for (const VkImage image : swapchain_.getImages()) images_.push_back(windowImage(image));
}

Swapchain::WindowImage Swapchain::windowImage(vk::Image image) const {
    WindowImage made{
        image,
        vk::raii::ImageView(*device_, vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format_.format, {},
                                                              {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1})),
        vk::raii::Semaphore(*device_, vk::SemaphoreCreateInfo())};
    const std::string name = "window " + std::to_string(images_.size());
    device_.name(image, name);
    device_.name(*made.view, "view of " + name);
    device_.name(*made.drawn, name + " is drawn");
    if (!device_.maintainsSwapchains()) return made;
    made.shown = vk::raii::Fence(*device_, vk::FenceCreateInfo());
    device_.name(*made.shown, name + " is done with");
    return made;
}

ImageRef Swapchain::image(std::uint32_t index) const { return {images_[index].handle, *images_[index].view}; }

void Swapchain::awaitDisplay() {
    if (!ready() || stale_) return;
    switch (display_.beforeFrame(*swapchain_)) {
        case vk::Result::eSuboptimalKHR:
        case vk::Result::eErrorOutOfDateKHR:
        case vk::Result::eErrorSurfaceLostKHR:  // recreate() replaces the surface as well
            stale_ = true;
            break;
        case vk::Result::eErrorDeviceLost:
            throw vk::DeviceLostError("waiting for the display");
        default:  // the wait is no more than a courtesy
            break;
    }
}

std::optional<std::uint32_t> Swapchain::acquire(vk::Semaphore signal) {
    dropFormers(false);
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
    WindowImage& image = images_[index];
    whole_ = false;  // until the display accepts it
    try {
        const vk::SwapchainKHR swapchain = *swapchain_;
        vk::PresentInfoKHR info(*image.drawn, swapchain, index);
        vk::SwapchainPresentFenceInfoEXT shown(*image.shown);
        DisplayWait::Number number;
        if (*image.shown) {
            awaitShown(image, UINT64_MAX);  // the image was returned, so this is done or soon will be
            device_->resetFences(*image.shown);
            info.pNext = &shown;
        }
        info.pNext = display_.begin(number, info.pNext);
        const vk::Result result = device_.queue().presentKHR(info);
        enqueued(image);
        display_.accepted(number);
        if (result == vk::Result::eSuboptimalKHR) stale_ = true;
    } catch (const vk::OutOfDateKHRError&) {
        enqueued(image);
        stale_ = true;
    } catch (const vk::SurfaceLostKHRError&) {
        enqueued(image);
        device_.settle();
        release();
    } catch (...) {
        stale_ = true;  // the image stays acquired and `drawn` signalled: neither can be reused
        throw;
    }
}

}  // namespace nacre::gpu
