#pragma once
// A display by a clock of its own (faults.h: Display), which tells when it shows an image: VK_KHR_present_id and
// VK_KHR_present_wait, or their second versions. The layers below know nothing of it.

#include <string_view>
#include <utility>
#include <vector>

#include "engine/gpu/present_wait_2.h"
#include "tests/fault_layer/state.h"

namespace nacre::faults {

/// Structures that are taken out of a chain as long as this lives.
class BentChain {
public:
    BentChain() = default;
    BentChain(const BentChain&) = delete;
    ~BentChain() {
        for (auto at = bent_.rbegin(); at != bent_.rend(); ++at) at->first->pNext = at->second;
    }

    template <typename Head, typename Which>
    void bend(Head* head, const Which& which) {
        for (auto* at = reinterpret_cast<VkBaseOutStructure*>(head); at->pNext;) {
            VkBaseOutStructure* next = at->pNext;
            if (which(next->sType)) {
                bent_.emplace_back(at, next);
                at->pNext = next->pNext;
            } else {
                at = next;
            }
        }
    }
    std::vector<VkBaseOutStructure*> removed() const {
        std::vector<VkBaseOutStructure*> list;
        for (const auto& [before, removed] : bent_) list.push_back(removed);
        return list;
    }

private:
    std::vector<std::pair<VkBaseOutStructure*, VkBaseOutStructure*>> bent_;
};

bool hasDisplay();
bool isDisplayExtension(std::string_view name);
bool isDisplayFeature(VkStructureType type);
bool isPresentNumber(VkStructureType type);
void addDisplayExtensions(std::vector<VkExtensionProperties>& extensions);
/// Fills in the structures of a surface's capabilities.
void tellDisplay(void* chain);

/// Flags of swapchains that the second version needs.
VkSwapchainCreateFlagsKHR displayFlags();
void newSwapchain(VkSwapchainCreateFlagsKHR flags, std::uint32_t images);
/// Time passes until the display is done with an image.
void awaitImage();
void presented(const std::vector<VkBaseOutStructure*>& numbers);
VkResult awaitDisplay(std::uint64_t number, std::uint64_t nanoseconds);

}  // namespace nacre::faults
