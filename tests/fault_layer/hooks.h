#pragma once
// Calls on their way down: asked about first, done, counted.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string_view>
#include <tuple>

#include "tests/fault_layer/state.h"

namespace nacre::faults {

/// How a call may fail.
enum class Fails { runsOut, runsOutOrLost, lost, other };

/// One hook for each function; Tag keeps those of one type apart.
template <typename Tag, typename Function>
struct Hook;

template <typename Tag, typename... Arguments>
struct Hook<Tag, VkResult(VKAPI_PTR*)(Arguments...)> {
    using Function = VkResult(VKAPI_PTR*)(Arguments...);
    static inline Function next = nullptr;

    static VKAPI_ATTR VkResult VKAPI_CALL run(Arguments... arguments) {
        const auto told = verdict(Tag::name, Tag::fails == Fails::runsOut || Tag::fails == Fails::runsOutOrLost,
                                  Tag::fails == Fails::runsOutOrLost || Tag::fails == Fails::lost);
        if (told && *told < 0) return *told;
        const VkResult result = next(arguments...);
        if (result >= 0 && Tag::kind) made(Tag::kind, countObjects(arguments...));
        return result == VK_SUCCESS && told ? *told : result;
    }

private:
    /// The second argument of calls that make several pipelines counts them; all others make one object.
    static std::int64_t countObjects(Arguments... arguments) {
        if constexpr (std::string_view(Tag::name).ends_with("Pipelines"))
            return static_cast<std::int64_t>(std::get<2>(std::tuple(arguments...)));
        else
            return 1;
    }
};

/// Calls that destroy: device, handle, allocator.
template <typename Tag, typename Parent, typename Handle>
struct Hook<Tag, void(VKAPI_PTR*)(Parent, Handle, const VkAllocationCallbacks*)> {
    using Function = void(VKAPI_PTR*)(Parent, Handle, const VkAllocationCallbacks*);
    static inline Function next = nullptr;

    static VKAPI_ATTR void VKAPI_CALL run(Parent parent, Handle handle, const VkAllocationCallbacks* allocator) {
        if (handle != Handle{}) made(Tag::kind, -1);
        next(parent, handle, allocator);
    }
};

// name, how it may fail, kind of what it makes or destroys
#define NACRE_DEVICE_CALLS(X)                                    \
    X(AllocateMemory, runsOut, "DeviceMemory")                   \
    X(FreeMemory, other, "DeviceMemory")                         \
    X(MapMemory, runsOut, nullptr)                               \
    X(BindBufferMemory, runsOut, nullptr)                        \
    X(BindImageMemory, runsOut, nullptr)                         \
    X(CreateBuffer, runsOut, "Buffer")                           \
    X(DestroyBuffer, other, "Buffer")                            \
    X(CreateImage, runsOut, "Image")                             \
    X(DestroyImage, other, "Image")                              \
    X(CreateImageView, runsOut, "ImageView")                     \
    X(DestroyImageView, other, "ImageView")                      \
    X(CreateSampler, runsOut, "Sampler")                         \
    X(DestroySampler, other, "Sampler")                          \
    X(CreateShaderModule, runsOut, "ShaderModule")               \
    X(DestroyShaderModule, other, "ShaderModule")                \
    X(CreatePipelineCache, runsOut, "PipelineCache")             \
    X(DestroyPipelineCache, other, "PipelineCache")              \
    X(GetPipelineCacheData, runsOut, nullptr)                    \
    X(CreatePipelineLayout, runsOut, "PipelineLayout")           \
    X(DestroyPipelineLayout, other, "PipelineLayout")            \
    X(CreateDescriptorSetLayout, runsOut, "DescriptorSetLayout") \
    X(DestroyDescriptorSetLayout, other, "DescriptorSetLayout")  \
    X(CreateDescriptorPool, runsOut, "DescriptorPool")           \
    X(DestroyDescriptorPool, other, "DescriptorPool")            \
    X(AllocateDescriptorSets, runsOut, nullptr)                  \
    X(CreateGraphicsPipelines, runsOut, "Pipeline")              \
    X(CreateComputePipelines, runsOut, "Pipeline")               \
    X(DestroyPipeline, other, "Pipeline")                        \
    X(CreateRenderPass2KHR, runsOut, "RenderPass")               \
    X(DestroyRenderPass, other, "RenderPass")                    \
    X(CreateFramebuffer, runsOut, "Framebuffer")                 \
    X(DestroyFramebuffer, other, "Framebuffer")                  \
    X(CreateCommandPool, runsOut, "CommandPool")                 \
    X(DestroyCommandPool, other, "CommandPool")                  \
    X(AllocateCommandBuffers, runsOut, nullptr)                  \
    X(BeginCommandBuffer, runsOut, nullptr)                      \
    X(EndCommandBuffer, runsOut, nullptr)                        \
    X(ResetCommandBuffer, runsOut, nullptr)                      \
    X(CreateQueryPool, runsOut, "QueryPool")                     \
    X(DestroyQueryPool, other, "QueryPool")                      \
    X(CreateFence, runsOut, "Fence")                             \
    X(DestroyFence, other, "Fence")                              \
    X(ResetFences, runsOut, nullptr)                             \
    X(WaitForFences, runsOutOrLost, nullptr)                     \
    X(GetFenceStatus, lost, nullptr)                             \
    X(CreateSemaphore, runsOut, "Semaphore")                     \
    X(DestroySemaphore, other, "Semaphore")                      \
    X(QueueSubmit, runsOutOrLost, nullptr)                       \
    X(QueueWaitIdle, runsOutOrLost, nullptr)                     \
    X(DeviceWaitIdle, runsOutOrLost, nullptr)                    \
    X(CreateSwapchainKHR, runsOutOrLost, "SwapchainKHR")         \
    X(DestroySwapchainKHR, other, "SwapchainKHR")                \
    X(GetSwapchainImagesKHR, runsOut, nullptr)                   \
    X(AcquireNextImageKHR, runsOutOrLost, nullptr)               \
    X(QueuePresentKHR, runsOutOrLost, nullptr)                   \
    X(ReleaseSwapchainImagesEXT, runsOut, nullptr)               \
    X(SetDebugUtilsObjectNameEXT, runsOut, nullptr)

#define NACRE_INSTANCE_CALLS(X)                                        \
    X(EnumeratePhysicalDevices, runsOut, nullptr)                      \
    X(CreateDebugUtilsMessengerEXT, runsOut, "DebugUtilsMessengerEXT") \
    X(DestroyDebugUtilsMessengerEXT, other, "DebugUtilsMessengerEXT")  \
    X(CreateHeadlessSurfaceEXT, runsOut, "SurfaceKHR")                 \
    X(CreateXcbSurfaceKHR, runsOut, "SurfaceKHR")                      \
    X(CreateXlibSurfaceKHR, runsOut, "SurfaceKHR")                     \
    X(DestroySurfaceKHR, other, "SurfaceKHR")                          \
    X(GetPhysicalDeviceSurfaceSupportKHR, runsOut, nullptr)            \
    X(GetPhysicalDeviceSurfaceFormatsKHR, runsOut, nullptr)            \
    X(GetPhysicalDeviceSurfaceCapabilitiesKHR, runsOut, nullptr)

}  // namespace nacre::faults
