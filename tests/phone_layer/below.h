#pragma once
// The calls of what lies below the layer: the driver's, or another layer's.

#include <vulkan/vulkan.h>

#include <cstdlib>
#include <string_view>

namespace nacre::phone {

/// Which phone it is: NACRE_PHONE.
inline bool isPhone(std::string_view name) {
    const char* phone = std::getenv("NACRE_PHONE");
    return phone && name == phone;
}
inline bool molten() { return isPhone("moltenvk"); }
inline bool adreno() { return isPhone("adreno"); }
inline bool mali() { return isPhone("mali"); }
inline bool arm() { return mali() || isPhone("android"); }
/// Whether it names its driver, which then keeps an order that it does not promise.
inline bool armsDriver() { return arm() && std::getenv("NACRE_PHONE_ARMS_DRIVER"); }
inline bool powervr() { return isPhone("powervr"); }
/// A fault of the driver: NACRE_PHONE_WRONG.
inline bool isWrong(std::string_view how) {
    const char* wrong = std::getenv("NACRE_PHONE_WRONG");
    return wrong && how == wrong;
}

// What lies below. Looked up in time: later the loader would give this layer's own.
#define NACRE_BELOW(X)                         \
    X(DestroyInstance)                         \
    X(EnumerateDeviceExtensionProperties)      \
    X(GetPhysicalDeviceProperties)             \
    X(GetPhysicalDeviceProperties2)            \
    X(GetPhysicalDeviceFeatures)               \
    X(GetPhysicalDeviceFeatures2)              \
    X(GetPhysicalDeviceFormatProperties)       \
    X(GetPhysicalDeviceFormatProperties2)      \
    X(GetPhysicalDeviceMemoryProperties)       \
    X(GetPhysicalDeviceQueueFamilyProperties)  \
    X(GetPhysicalDeviceImageFormatProperties2) \
    X(GetPhysicalDeviceMemoryProperties2)
#define NACRE_DEVICE_BELOW(X)       \
    X(AllocateMemory)               \
    X(BeginCommandBuffer)           \
    X(CmdBeginRenderPass2KHR)       \
    X(CmdNextSubpass2KHR)           \
    X(CmdBeginRenderingKHR)         \
    X(CmdCopyBufferToImage)         \
    X(CmdSetViewport)               \
    X(CmdSetScissor)                \
    X(CreateFramebuffer)            \
    X(CreateImage)                  \
    X(CreateImageView)              \
    X(CreateRenderPass2KHR)         \
    X(GetDeviceMemoryCommitment)    \
    X(QueueSubmit)                  \
    X(WaitForFences)                \
    X(CmdBindPipeline)              \
    X(CmdDraw)                      \
    X(CmdDrawIndexed)               \
    X(CmdDispatch)                  \
    X(CmdWriteTimestamp)            \
    X(GetQueryPoolResults)          \
    X(CreateShaderModule)           \
    X(CreateGraphicsPipelines)      \
    X(CreateComputePipelines)       \
    X(CreatePipelineCache)          \
    X(CreateQueryPool)              \
    X(CmdBeginQuery)                \
    X(CmdEndQuery)                  \
    X(QueuePresentKHR)              \
    X(GetImageMemoryRequirements)   \
    X(GetImageMemoryRequirements2)  \
    X(GetBufferMemoryRequirements)  \
    X(BindBufferMemory)             \
    X(MapMemory)                    \
    X(FreeMemory)                   \
    X(FlushMappedMemoryRanges)      \
    X(InvalidateMappedMemoryRanges) \
    X(CmdPipelineBarrier)           \
    X(CreateBuffer)

#define NACRE_DECLARE(name) inline PFN_vk##name next##name = nullptr;
NACRE_BELOW(NACRE_DECLARE)
NACRE_DEVICE_BELOW(NACRE_DECLARE)
inline PFN_vkCmdClearAttachments nextCmdClearAttachments = nullptr;
inline PFN_vkGetBufferDeviceAddressKHR nextGetBufferDeviceAddressKHR = nullptr;
inline PFN_vkCmdUpdateBuffer nextCmdUpdateBuffer = nullptr;
#undef NACRE_DECLARE

}  // namespace nacre::phone
