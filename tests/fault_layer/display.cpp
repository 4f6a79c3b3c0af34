#include "tests/fault_layer/display.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace nacre::faults {
namespace {

struct Shown {
    std::optional<Display> display;
    double now = 0;
    std::vector<Present> presents;
    std::size_t first = 0;  ///< present of this swapchain
    std::uint32_t images = 3;
    bool numbered = true;
};
Shown shown;

[[noreturn]] void end(const char* why) {
    std::fprintf(stderr, "fault layer: %s\n", why);
    std::abort();
}

bool second() { return shown.display && shown.display->version == 2; }

}  // namespace

void setDisplay(const std::optional<Display>& display) {
    if (display && shown.display && display->version == shown.display->version)  // it changes while a window is shown
        shown.display = display;
    else
        shown = {display, 0, {}};
}
double displayTime() { return shown.now; }
void passTime(double seconds) { shown.now += seconds; }
const std::vector<Present>& presents() { return shown.presents; }

bool hasDisplay() { return shown.display.has_value(); }

bool isDisplayExtension(std::string_view name) {
    return hasDisplay() && (name == VK_KHR_PRESENT_ID_EXTENSION_NAME || name == VK_KHR_PRESENT_WAIT_EXTENSION_NAME ||
                            name == VK_KHR_PRESENT_ID_2_EXTENSION_NAME || name == VK_KHR_PRESENT_WAIT_2_EXTENSION_NAME);
}

bool isDisplayFeature(VkStructureType type) {
    if (!hasDisplay()) return false;
    return second() ? type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_2_FEATURES_KHR ||
                          type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_2_FEATURES_KHR
                    : type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_ID_FEATURES_KHR ||
                          type == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRESENT_WAIT_FEATURES_KHR;
}

bool isPresentNumber(VkStructureType type) {
    return hasDisplay() && type == (second() ? VK_STRUCTURE_TYPE_PRESENT_ID_2_KHR : VK_STRUCTURE_TYPE_PRESENT_ID_KHR);
}

void addDisplayExtensions(std::vector<VkExtensionProperties>& extensions) {
    if (!hasDisplay()) return;
    for (const char* name : {second() ? VK_KHR_PRESENT_ID_2_EXTENSION_NAME : VK_KHR_PRESENT_ID_EXTENSION_NAME,
                             second() ? VK_KHR_PRESENT_WAIT_2_EXTENSION_NAME : VK_KHR_PRESENT_WAIT_EXTENSION_NAME}) {
        VkExtensionProperties own{};
        std::strcpy(own.extensionName, name);
        own.specVersion = 1;
        extensions.push_back(own);
    }
}

void tellDisplay(void* chain) {
    for (auto* at = static_cast<VkBaseOutStructure*>(chain); at; at = at->pNext)
        if (at->sType == VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_ID_2_KHR ||
            at->sType == VK_STRUCTURE_TYPE_SURFACE_CAPABILITIES_PRESENT_WAIT_2_KHR)
            reinterpret_cast<VkSurfaceCapabilitiesPresentId2KHR*>(at)->presentId2Supported =
                second() && shown.display->surfaceSupports;
}

VkSwapchainCreateFlagsKHR displayFlags() {
    return VK_SWAPCHAIN_CREATE_PRESENT_ID_2_BIT_KHR | VK_SWAPCHAIN_CREATE_PRESENT_WAIT_2_BIT_KHR;
}

void newSwapchain(VkSwapchainCreateFlagsKHR flags, std::uint32_t images) {
    if (!hasDisplay()) return;
    const bool flagged = (flags & displayFlags()) == displayFlags();
    if (flagged != (second() && shown.display->surfaceSupports)) end("flags of a swapchain that the surface lacks");
    shown.numbered = second() ? flagged : !hides(VK_KHR_PRESENT_WAIT_EXTENSION_NAME);
    shown.first = shown.presents.size();
    shown.images = images;
}

void awaitImage() {
    if (!hasDisplay()) return;
    // All images but one wait to be taken, or are shown until the next one is taken.
    const std::size_t count = shown.presents.size() - shown.first;
    if (count + 1 < shown.images) return;
    const Present& next = shown.presents[shown.presents.size() + 1 - shown.images];
    if (!std::isinf(next.taken)) shown.now = std::max(shown.now, next.taken);
}

void presented(const std::vector<VkBaseOutStructure*>& numbers) {
    if (!hasDisplay()) return;
    if (numbers.size() != (shown.numbered ? 1u : 0u))
        end("a present without its number, or with one that is not asked for");
    const Display& display = *shown.display;
    Present present{0, shown.now, 0, 0};
    if (!numbers.empty()) present.number = *reinterpret_cast<VkPresentIdKHR*>(numbers.front())->pPresentIds;
    const Present* last = shown.presents.empty() ? nullptr : &shown.presents.back();
    if (!numbers.empty() && last && present.number <= last->number) end("the numbers of presents do not rise");
    const double interval = display.interval;
    present.taken = std::floor(shown.now / interval + 1) * interval;
    if (last) present.taken = std::max(present.taken, last->taken + interval);
    present.shown =
        display.shows ? present.taken + display.latency * interval : std::numeric_limits<double>::infinity();
    shown.presents.push_back(present);
}

VkResult awaitDisplay(std::uint64_t number, std::uint64_t nanoseconds) {
    const auto first = shown.presents.begin() + static_cast<std::ptrdiff_t>(shown.first);
    const auto found =
        std::find_if(first, shown.presents.end(), [&](const Present& p) { return p.number == number && number > 0; });
    if (found == shown.presents.end()) end("a wait for a present that this swapchain did not accept");
    const double given_up = shown.now + 1e-9 * static_cast<double>(nanoseconds);
    if (found->shown > given_up) {
        shown.now = given_up;
        return VK_TIMEOUT;
    }
    shown.now = std::max(shown.now, found->shown);
    return VK_SUCCESS;
}

}  // namespace nacre::faults
