#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "engine/device_options.h"
#include "engine/error.h"
#include "engine/gpu/caps.h"
#include "engine/gpu/capture_hook.h"
#include "engine/gpu/command_buffer.h"
#include "engine/gpu/context.h"
#include "engine/gpu/device_loss.h"
#include "engine/gpu/local_read.h"
#include "engine/gpu/memory_store.h"
#include "engine/gpu/present_wait.h"
#include "engine/gpu/validation_log.h"

namespace nacre::gpu {

/// Whether pipelines are kept in the driver's cache. Quirks of a driver may still forbid it.
enum class Caching { usual, none };

/// Instance, device and its single queue (graphics and compute). Renderers of several threads may share one.
class Device {
public:
    /// @throws Error without a loader, driver or device that meets the requirements, or if validation is not installed
    explicit Device(const DeviceOptions& options, Caching caching = Caching::usual);
    Device(const Device&) = delete;

    const vk::raii::Device& operator*() const { return device_; }
    const vk::raii::Device* operator->() const { return &device_; }
    const vk::raii::Instance& instance() const { return instance_; }
    const vk::raii::PhysicalDevice& physical() const { return physical_; }
    /// Null where the driver has no working cache.
    const vk::raii::PipelineCache* pipelineCache() const { return *pipelineCache_ ? &pipelineCache_ : nullptr; }
    /// For presenting. Submit by submit().
    const vk::raii::Queue& queue() const { return queue_; }
    /// Submits while no other thread does.
    void submit(const vk::SubmitInfo& work, vk::Fence done) const;
    /// Waits until nothing is in flight, that of other threads included.
    void waitIdle() const;
    std::uint32_t queueFamily() const { return queueFamily_; }
    const Caps& caps() const { return caps_; }
    const LocalReadCalls& localReadCalls() const { return localReadCalls_; }
    CaptureHook& capture() { return capture_; }
    /// Notes the path that a self-test found. Call before anything is drawn.
    void choose(graph::TestedPath path) { caps_.tested = std::move(path); }

    /// Memory of the first type that has all properties of the first choice, else of the next one.
    /// @throws Error if no type has the properties of any choice, or memory runs out
    HeldMemory allocate(const vk::MemoryRequirements& requirements,
                        std::initializer_list<vk::MemoryPropertyFlags> choices, const std::string& what) const;
    MemoryStore& memory() const { return *memory_; }

    /// Names an object for capture tools and validation messages.
    void name(vk::ObjectType type, std::uint64_t handle, std::string_view name) const;
    template <typename Handle>
    void name(const Handle& handle, std::string_view text) const {
        name(Handle::objectType, reinterpret_cast<std::uint64_t>(static_cast<typename Handle::NativeType>(handle)),
             text);
    }
    /// Whether per-frame names are used: by the validation layer or RenderDoc.
    bool watched() const { return *messenger_ || capture_.loaded(); }
    void beginLabel(const vk::raii::CommandBuffer& commands, const std::string& name) const;
    void endLabel(const vk::raii::CommandBuffer& commands) const;

    /// Messages of the validation layer so far. Must be empty after every frame.
    std::vector<std::string> validationMessages() const { return messages_->messages(); }

    /// Log of submissions, to explain a device loss. Filled while commands are recorded.
    SubmissionLog& log() const { return *log_; }
    /// A Vulkan failure as an error message: what ran out, or what is known of a loss. Ends with the call's name.
    Error makeError(const vk::SystemError& failure) const;
    /// Waits until nothing is in flight, or the device is lost.
    void settle() const noexcept;
    /// Waits until all submitted work is done, or the time is over. @returns whether it is done
    bool awaitSubmitted(double seconds) const;

    /// The swapchain reports when a presented image is free, and takes back images that were not presented.
    bool maintainsSwapchains() const { return maintainsSwapchains_; }
    /// Whether waiting for the display of a present is enabled.
    PresentWait presentWait() const { return presentWait_; }

    /// End marker of a submission: nothing, or a frame that is not presented, for capture tools (if supported).
    enum class Ends { nothing, frame };
    /// Records a command buffer by the given function, submits it and waits for it. The function takes a CommandBuffer
    /// if it may split it, else a vk::raii::CommandBuffer. After a failure, none of it is in flight.
    template <typename RecordCommands>
    void submitAndWait(RecordCommands&& record, Ends ends = Ends::nothing) const {
        Single single = begin();
        if constexpr (std::is_invocable_v<RecordCommands&, CommandBuffer&>)
            record(single.commands);
        else
            record(*single.commands);
        finish(single, ends);
    }

private:
    /// Commands that the host waits for. They are kept for reuse.
    struct Single {
        CommandBuffer commands;
        vk::raii::Fence done{nullptr};
    };
    /// State that several threads change, under its locks.
    struct Shared {
        std::mutex queue, singles;
        std::vector<Single> kept;
        std::uint64_t frame = 0;  ///< number of the next one that is marked; under `queue`
    };
    Single begin() const;
    void finish(Single& single, Ends ends) const;
    void createInstance(const DeviceOptions& options);
    void createDevice(const DeviceOptions& options);
    void nameOwn() const;

    vk::raii::Context context_ = makeContext();
    vk::raii::Instance instance_{nullptr};
    std::unique_ptr<ValidationLog> messages_ = std::make_unique<ValidationLog>();
    vk::raii::DebugUtilsMessengerEXT messenger_{nullptr};
    vk::raii::PhysicalDevice physical_{nullptr};
    vk::raii::Device device_{nullptr};
    vk::raii::Queue queue_{nullptr};
    std::unique_ptr<MemoryStore> memory_;
    std::unique_ptr<Shared> shared_ = std::make_unique<Shared>();
    std::unique_ptr<vk::raii::Fence> drained_ = std::make_unique<vk::raii::Fence>(nullptr);
    vk::raii::PipelineCache pipelineCache_{nullptr};
    std::uint32_t queueFamily_ = 0;
    bool debugUtils_ = false, tellsOfFaults_ = false;
    bool marksFrames_ = false, surfaceQueries_ = false, surfaceMaintenance_ = false, maintainsSwapchains_ = false;
    PresentWait presentWait_ = PresentWait::none;
    Caps caps_;
    LocalReadCalls localReadCalls_;
    CaptureHook capture_;
    std::unique_ptr<SubmissionLog> log_ = std::make_unique<SubmissionLog>();
};

}  // namespace nacre::gpu
