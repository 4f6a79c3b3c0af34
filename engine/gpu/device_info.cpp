#include "engine/gpu/device_info.h"

#include "engine/devices.h"
#include "engine/error.h"
#include "engine/gpu/capture_hook.h"
#include "engine/gpu/context.h"
#include "engine/gpu/device_loss.h"
#include "engine/gpu/instance.h"

namespace nacre {
namespace {

/// "4.1"
std::string megabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes * 10 + 500'000) / 1'000'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

DeviceInfo gpu::infoOf(const Caps& caps) {
    DeviceInfo info;
    info.name = caps.deviceName;
    info.driver = caps.driverName;
    info.type = caps.type;
    info.apiVersion = std::to_string(VK_API_VERSION_MAJOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_MINOR(caps.apiVersion)) + "." +
                      std::to_string(VK_API_VERSION_PATCH(caps.apiVersion));
    info.visibility = visibilityName(caps.visibility);
    info.why = caps.visibilityReason;
    info.encodedFormat = graph::formatName(caps.encoded.format) + (caps.encoded.ordered ? " in raster order" : "");
    info.lazyMemory = caps.plan.transient;
    info.timestamps = caps.timestampBits > 0;
    info.rasterOrder = caps.plan.rasterOrder;
    info.localRead = caps.localRead;
    info.mergeFeedback = caps.mergeFeedback;
    info.driverKey = caps.driverKey;
    info.capabilitySet = caps.capabilitySet;
    if (caps.knownAs.what) info.knownAs = caps.knownAs.what, info.knownBy = caps.knownAs.source;
    return info;
}

std::string describe(const DriverFeedback& feedback) {
    std::string text;
    const auto line = [&](const std::string& words) { text += (text.empty() ? "" : "\n") + words; };
    for (const MergedSubpasses& m : feedback.merges)
        line(m.name + ": " + std::to_string(m.planned) + " subpasses as " + std::to_string(m.carried) +
             (m.why.empty() ? "" : " (" + m.why + ")"));
    for (const TransientImage& image : feedback.transients)
        line(image.name + ": " + megabytes(image.committedBytes) + " of " + megabytes(image.bytes) + " MB committed");
    return text;
}

bool capturesBuilt() { return gpu::CaptureHook::built(); }

std::vector<DeviceInfo> listDevices() {
    try {
        const vk::raii::Context context = gpu::makeContext();
        gpu::InstanceExtensions found;
        const vk::raii::Instance instance = gpu::makeInstance(context, false, found);
        std::vector<DeviceInfo> devices;
        for (const auto& physical : vk::raii::PhysicalDevices(instance))
            devices.push_back(gpu::infoOf(gpu::capsOf(physical)));
        return devices;
    } catch (const vk::SystemError& failure) {
        throw Error("cannot list devices", "", gpu::inOneLine(failure.what()));
    }
}

}  // namespace nacre
