#include "engine/gpu/device.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>

#include "engine/devices.h"
#include "engine/gpu/dynamic_rendering.h"
#include "engine/gpu/frame_boundary.h"
#include "engine/gpu/instance.h"
#include "engine/gpu/performance_counters.h"
#include "engine/gpu/pipeline_cache.h"
#include "engine/gpu/region_counters.h"
#include "engine/gpu/requirements.h"

namespace nacre::gpu {
namespace {

std::vector<const char*> deviceExtensions(const vk::raii::PhysicalDevice& physical, bool window) {
    const auto& available = listExtensions(physical);
    auto has = [&](std::string_view name) {
        return std::any_of(available.begin(), available.end(),
                           [&](const auto& e) { return name == e.extensionName.data(); });
    };
    std::vector<const char*> wanted(requiredExtensions().begin(), requiredExtensions().end());
    if (window) wanted.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    for (const char* name :
         {"VK_KHR_portability_subset", VK_EXT_LOAD_STORE_OP_NONE_EXTENSION_NAME,
          VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME, VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME,
          VK_ARM_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME})
        if (has(name)) wanted.push_back(name);
    return wanted;
}

std::atomic<bool> heapIsOurs{false};

/// For a driver that allocates heap memory per tile. glibc searches its lists of small free chunks at every large free,
/// so they are disabled. Large chunks are kept. The heap grows in large steps, and the first has huge pages where the
/// kernel leaves that to programs: each small page costs it 2 µs or more. Holds for the whole process.
void tuneHeap() {
#ifdef M_MXFAST
    mallopt(M_MXFAST, 0);
#endif
#if defined(M_MMAP_THRESHOLD) && defined(M_TRIM_THRESHOLD)
    constexpr int kKept = 64 << 20, kStep = 128 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, kStep + kKept);
#endif
#if defined(M_TOP_PAD) && defined(MADV_HUGEPAGE)
    mallopt(M_TOP_PAD, kStep);
    const auto before = reinterpret_cast<std::uintptr_t>(sbrk(0));
    void* volatile more = std::malloc(16 << 20);  // volatile: compilers leave out an unused allocation
    std::free(more);
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)), first = (before + page - 1) / page * page;
    const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
    if (end > first) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace

Device::Device(const DeviceOptions& options, Caching caching) {
    createInstance(options);
    physical_ = options.headset.physical ? vk::raii::PhysicalDevice(instance_, options.headset.physical(*instance_))
                                         : pickDevice(instance_, options.device);
    createDevice(options);
    if (caching == Caching::usual && !graph::has(graph::Quirk::noPipelineCache, driverIdentity(physical_)))
        pipelineCache_ = makePipelineCache(device_, physical_, options.pipelineCache);
    memory_ = std::make_unique<MemoryStore>(device_, physical_);
    nameOwn();
    DeviceOptions wanted = options;
    wanted.capture = capture_.loaded();
    caps_ = queryCaps(physical_, wanted);
    if (heapIsOurs && caps_.has(graph::Quirk::heapPerTile)) tuneHeap();
}

void Device::nameOwn() const {
    // Names neither the instance nor the physical device: RenderDoc 1.24 aborts on both. Nor a surface: lavapipe 22.3
    // crashes.
    name(*device_, "device");
    name(*queue_, "queue");
    if (*pipelineCache_) name(*pipelineCache_, "pipelines");
}

void Device::createInstance(const DeviceOptions& options) {
    InstanceExtensions found;
    capture_.load(options.capture);
    if (options.capture) CaptureHook::checkLayer(context_);
    instance_ = makeInstance(context_, options.validate, found, options.surface.instanceExtensions,
                             options.headset.instance ? &options.headset : nullptr);
    debugUtils_ = found.debugUtils;
    surfaceQueries_ = found.surfaceQueries;
    surfaceMaintenance_ = found.surfaceMaintenance;
    if (options.validate) messenger_ = makeMessenger(instance_, *messages_);
}

void Device::createDevice(const DeviceOptions& options) {
    checkRequirements(physical_, static_cast<bool>(options.surface.create));
    queueFamily_ = graphicsAndCompute(physical_);
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, queueFamily_, 1, &priority);
    auto extensions = deviceExtensions(physical_, static_cast<bool>(options.surface.create));
    vk::PhysicalDeviceFeatures features;
    // Only the counting shaders write storage from fragments.
    features.fragmentStoresAndAtomics = physical_.getFeatures().fragmentStoresAndAtomics;
    vk::DeviceCreateInfo info({}, queue, {}, extensions, &features);
    vk::PhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT order(true);
    if (readsInRasterOrder(physical_)) info.pNext = &order;
    const auto add = [&](auto& feature, const char* extension) {
        extensions.push_back(extension);
        feature.pNext = const_cast<void*>(info.pNext);
        info.pNext = &feature;
    };
    vk::PhysicalDeviceMultiviewFeatures views(true);
    if (viewsAtOnce(physical_) > 1) {
        views.pNext = const_cast<void*>(info.pNext);
        info.pNext = &views;
    }
    vk::PhysicalDeviceFragmentDensityMapFeaturesEXT density(true, false, true);
    if (options.headset.device && queryDensityMaps(physical_).texel > 0)
        add(density, VK_EXT_FRAGMENT_DENSITY_MAP_EXTENSION_NAME);
    vk::PhysicalDeviceFaultFeaturesEXT fault(true);
    tellsOfFaults_ = tellsOfFaults(physical_);
    if (tellsOfFaults_) add(fault, VK_EXT_DEVICE_FAULT_EXTENSION_NAME);
    vk::PhysicalDeviceSubpassMergeFeedbackFeaturesEXT merges(true);
    if (tellsOfMerges(physical_)) add(merges, VK_EXT_SUBPASS_MERGE_FEEDBACK_EXTENSION_NAME);
    vk::PhysicalDeviceDynamicRenderingFeatures dynamic(true);
    VkPhysicalDeviceDynamicRenderingLocalReadFeaturesKHR localRead{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_LOCAL_READ_FEATURES_KHR, nullptr, true};
    const bool readsHere = readsLocally(physical_, options.validate);
    if (readsHere) {
        add(dynamic, VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME);
        add(localRead, VK_KHR_DYNAMIC_RENDERING_LOCAL_READ_EXTENSION_NAME);
        extensions.push_back(VK_KHR_DEPTH_STENCIL_RESOLVE_EXTENSION_NAME);
        features.independentBlend = true;
    }
    VkPhysicalDeviceFrameBoundaryFeaturesEXT boundary{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAME_BOUNDARY_FEATURES_EXT,
                                                      nullptr, true};
    marksFrames_ = !options.surface.create && marksFrames(physical_, options.validate);
    if (marksFrames_) add(boundary, VK_EXT_FRAME_BOUNDARY_EXTENSION_NAME);
    vk::PhysicalDeviceSwapchainMaintenance1FeaturesEXT swapchains(true);
    maintainsSwapchains_ = surfaceMaintenance_ && options.surface.create && gpu::maintainsSwapchains(physical_);
    if (maintainsSwapchains_) add(swapchains, VK_EXT_SWAPCHAIN_MAINTENANCE_1_EXTENSION_NAME);
    if (options.surface.create) presentWait_ = queryPresentWait(physical_, surfaceQueries_, options.validate);
    PresentWaitFeatures presents(presentWait_);
    presents.add(extensions, info);
    vk::PhysicalDevicePerformanceQueryFeaturesKHR counters(true);
    if (!options.surface.create && hasPerformanceCounters(physical_))
        add(counters, VK_KHR_PERFORMANCE_QUERY_EXTENSION_NAME);
    vk::PhysicalDeviceBufferDeviceAddressFeatures addresses(true);
    VkPhysicalDevicePerformanceCountersByRegionFeaturesARM regions{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PERFORMANCE_COUNTERS_BY_REGION_FEATURES_ARM, nullptr, true};
    if (!options.surface.create && hasRegionCounters(physical_, options.validate)) {
        add(addresses, VK_KHR_BUFFER_DEVICE_ADDRESS_EXTENSION_NAME);
        add(regions, VK_ARM_PERFORMANCE_COUNTERS_BY_REGION_EXTENSION_NAME);
    }
    info.setPEnabledExtensionNames(extensions);
    device_ = options.headset.device
                  ? vk::raii::Device(physical_, options.headset.device(*physical_, info, entryPoint(context_)))
                  : vk::raii::Device(physical_, info);
    if (readsHere) localReadCalls_ = loadLocalReadCalls(device_);
    queue_ = device_.getQueue(queueFamily_, 0);
}

HeldMemory Device::allocate(const vk::MemoryRequirements& requirements,
                            std::initializer_list<vk::MemoryPropertyFlags> choices, const std::string& what) const {
    std::optional<HeldMemory> held = memory_->take(requirements, choices);
    if (!held) throw Error("out of device memory", what, std::to_string(requirements.size) + " bytes were asked for");
    name(*held->memory, "memory of " + what);
    return std::move(*held);
}

void Device::name(vk::ObjectType type, std::uint64_t handle, std::string_view name) const {
    if (!debugUtils_) return;
    std::array<char, 512> text;  // fixed size, cuts longer names: a string would allocate in every frame
    text[name.copy(text.data(), text.size() - 1)] = '\0';
    try {
        device_.setDebugUtilsObjectNameEXT({type, handle, text.data()});
    } catch (const vk::SystemError&) {
        // a name is optional
    }
}

void Device::beginLabel(const vk::raii::CommandBuffer& commands, const std::string& name) const {
    if (debugUtils_) commands.beginDebugUtilsLabelEXT(vk::DebugUtilsLabelEXT(name.c_str()));
}

void Device::endLabel(const vk::raii::CommandBuffer& commands) const {
    if (debugUtils_) commands.endDebugUtilsLabelEXT();
}

Device::Single Device::begin() const {
    Single single;
    {
        const std::lock_guard lock(shared_->singles);
        if (!shared_->kept.empty()) {
            single = std::move(shared_->kept.back());
            shared_->kept.pop_back();
        }
    }
    if (!single.commands) {
        single.commands = CommandBuffer(device_, queueFamily_);
        name(single.commands.pool(), "single commands");
        single.done = vk::raii::Fence(device_, vk::FenceCreateInfo());
        name(*single.done, "single commands are done");
    }
    single.commands.begin();
    log_->begin();
    return single;
}

void Device::finish(Single& single, Ends ends) const {
    single.commands.end();
    const auto handles = single.commands.handles();
    vk::SubmitInfo info({}, {}, handles);
    VkFrameBoundaryEXT boundary{};
    boundary.sType = VK_STRUCTURE_TYPE_FRAME_BOUNDARY_EXT;
    if (ends == Ends::frame) boundary.flags = VK_FRAME_BOUNDARY_FRAME_END_BIT_EXT;
    try {
        if (marksFrames_) {
            const std::lock_guard lock(shared_->queue);
            boundary.frameID = ends == Ends::frame ? shared_->frame++ : shared_->frame;
            info.pNext = &boundary;
        }
        submit(info, *single.done);
        if (device_.waitForFences(*single.done, true, UINT64_MAX) != vk::Result::eSuccess)
            throw Error("the device stopped", caps_.deviceName, "waiting for a submission failed");
    } catch (...) {
        settle();
        throw;
    }
    single.commands.reset();  // releases their resources
    device_.resetFences(*single.done);
    const std::lock_guard lock(shared_->singles);
    shared_->kept.push_back(std::move(single));
}

void Device::submit(const vk::SubmitInfo& work, vk::Fence done) const {
    log_->submitted();
    const std::lock_guard lock(shared_->queue);
    queue_.submit(work, done);
}

void Device::waitIdle() const {
    const std::lock_guard lock(shared_->queue);
    device_.waitIdle();
}

bool Device::awaitSubmitted(double seconds) const {
    // An empty submission's fence signals after all earlier ones. A fence that timed out may still be pending.
    if (**drained_ && device_.waitForFences(**drained_, true, 0) != vk::Result::eSuccess) return false;
    if (!**drained_) *drained_ = vk::raii::Fence(device_, vk::FenceCreateInfo());
    device_.resetFences(**drained_);
    {
        const std::lock_guard lock(shared_->queue);
        queue_.submit({}, **drained_);
    }
    const auto nanoseconds = static_cast<std::uint64_t>(1e9 * seconds);
    return device_.waitForFences(**drained_, true, nanoseconds) == vk::Result::eSuccess;
}

void Device::settle() const noexcept {
    for (int attempt = 0; attempt < 2; ++attempt) {
        try {
            waitIdle();
            return;
        } catch (const vk::DeviceLostError&) {
            return;
        } catch (const std::exception&) {
            // The allocation may succeed later.
        }
    }
}

Error Device::makeError(const vk::SystemError& failure) const {
    const std::string call = "in " + inOneLine(failure.what());
    const auto is = [&](vk::Result result) { return failure.code() == vk::make_error_code(result); };
    if (is(vk::Result::eErrorOutOfHostMemory)) return {"out of memory", caps_.deviceName, call};
    if (is(vk::Result::eErrorOutOfDeviceMemory)) return {"out of device memory", caps_.deviceName, call};
    if (!is(vk::Result::eErrorDeviceLost)) return {"the device failed", caps_.deviceName, call};
    std::string why = call;
    if (const std::string work = log_->text(); !work.empty()) why += "; last submitted: " + work;
    const std::string fault = tellsOfFaults_ ? faultText(device_) : "";
    why += fault.empty() ? "; the driver tells no more" : "; the driver tells: " + fault;
    return {"the device was lost", caps_.deviceName, why};
}

}  // namespace nacre::gpu

namespace nacre {

void letDriversTuneHeap() { gpu::heapIsOurs = true; }

}  // namespace nacre
