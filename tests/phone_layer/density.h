#pragma once
// Fragment density maps, which no software driver has: NACRE_PHONE_DENSITY names a file that gets a line for each
// render pass that begins with one: "map 3x3, 2 layers, 2 views". Its neighbour ".made" gets a line for each new map.
// The picture stays the same: each pixel has its fragment. The host reads maps while render passes begin
// (VkRenderPassFragmentDensityMapCreateInfoEXT), so that a map whose contents the device has not been seen to write by
// then ends the program.

#include <vulkan/vulkan.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tests/phone_layer/below.h"
#include "tests/phone_layer/feedback.h"

namespace nacre::phone {

inline bool takesMaps() { return std::getenv("NACRE_PHONE_DENSITY") != nullptr; }

struct MapsOfPass {
    std::uint32_t attachment = VK_ATTACHMENT_UNUSED, views = 0;
};

inline std::mutex mapsMutex;  // of what follows
inline std::map<VkImage, VkImageCreateInfo> mapImages;
inline std::map<VkImageView, VkImageViewCreateInfo> mapViews;
inline std::map<VkRenderPass, MapsOfPass> passesWithMap;
inline std::map<VkFramebuffer, std::vector<VkImageView>> viewsOfFramebuffers;
inline std::set<VkImage> recordedMaps, submittedMaps, writtenMaps;

inline void fill(VkPhysicalDeviceFragmentDensityMapFeaturesEXT& f) {
    f.fragmentDensityMap = f.fragmentDensityMapNonSubsampledImages = takesMaps();
    f.fragmentDensityMapDynamic = false;
}

inline void fill(VkPhysicalDeviceFragmentDensityMapPropertiesEXT& p) {
    p.minFragmentDensityTexelSize = {32, 32};
    p.maxFragmentDensityTexelSize = {1024, 1024};
    p.fragmentDensityInvocations = false;
}

inline void noteMap(VkImage image, const VkImageCreateInfo& info) {
    const std::lock_guard lock(mapsMutex);
    recordedMaps.erase(image), submittedMaps.erase(image), writtenMaps.erase(image);
    mapImages.erase(image);
    if (!(info.usage & VK_IMAGE_USAGE_FRAGMENT_DENSITY_MAP_BIT_EXT)) return;
    mapImages[image] = info;
    if (takesMaps()) std::ofstream(std::string(std::getenv("NACRE_PHONE_DENSITY")) + ".made", std::ios::app) << "map\n";
}

inline void noteMap(VkImageView view, const VkImageViewCreateInfo& info) {
    const std::lock_guard lock(mapsMutex);
    mapViews[view] = info;
}

inline void noteMap(VkFramebuffer made, const VkFramebufferCreateInfo& info) {
    const std::lock_guard lock(mapsMutex);
    viewsOfFramebuffers[made].assign(info.pAttachments, info.pAttachments + info.attachmentCount);
}

inline void noteMap(VkRenderPass made, const VkRenderPassCreateInfo2& info) {
    const std::lock_guard lock(mapsMutex);
    passesWithMap.erase(made);
    const auto* map = chained<VkRenderPassFragmentDensityMapCreateInfoEXT>(
        info.pNext, VK_STRUCTURE_TYPE_RENDER_PASS_FRAGMENT_DENSITY_MAP_CREATE_INFO_EXT);
    if (map) passesWithMap[made] = {map->fragmentDensityMapAttachment.attachment, info.pSubpasses[0].viewMask};
}

inline void beginWithMap(const VkRenderPassBeginInfo& info) {
    const std::lock_guard lock(mapsMutex);
    const auto pass = passesWithMap.find(info.renderPass);
    if (pass == passesWithMap.end() || pass->second.attachment == VK_ATTACHMENT_UNUSED) return;
    const VkImageViewCreateInfo& view = mapViews.at(viewsOfFramebuffers.at(info.framebuffer)[pass->second.attachment]);
    if (!writtenMaps.count(view.image)) {
        std::fprintf(stderr, "phone: the host reads a density map that the device has not written\n");
        std::abort();
    }
    const VkExtent3D extent = mapImages.at(view.image).extent;
    std::ofstream(std::getenv("NACRE_PHONE_DENSITY"), std::ios::app)
        << "map " << extent.width << 'x' << extent.height << ", " << view.subresourceRange.layerCount << " layers from "
        << view.subresourceRange.baseArrayLayer << ", " << std::popcount(pass->second.views) << " views\n";
}

inline VKAPI_ATTR void VKAPI_CALL CmdCopyBufferToImage(VkCommandBuffer commands, VkBuffer buffer, VkImage image,
                                                       VkImageLayout layout, std::uint32_t count,
                                                       const VkBufferImageCopy* regions) {
    nextCmdCopyBufferToImage(commands, buffer, image, layout, count, regions);
    const std::lock_guard lock(mapsMutex);
    if (mapImages.count(image)) recordedMaps.insert(image);
}

/// To be called when what was recorded is submitted.
inline void submitMaps() {
    const std::lock_guard lock(mapsMutex);
    submittedMaps.merge(recordedMaps);
}

inline VKAPI_ATTR VkResult VKAPI_CALL WaitForFences(VkDevice of, std::uint32_t count, const VkFence* fences,
                                                    VkBool32 all, std::uint64_t timeout) {
    const VkResult result = nextWaitForFences(of, count, fences, all, timeout);
    const std::lock_guard lock(mapsMutex);
    if (result == VK_SUCCESS) writtenMaps.merge(submittedMaps);
    return result;
}

}  // namespace nacre::phone
