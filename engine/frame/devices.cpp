#include "engine/frame/devices.h"

#include "engine/device_caps.h"
#include "engine/devices.h"
#include "engine/error.h"
#include "engine/frame/choose.h"
#include "engine/gpu/context.h"
#include "engine/gpu/device.h"
#include "engine/gpu/device_info.h"
#include "engine/gpu/device_loss.h"
#include "engine/gpu/instance.h"

namespace nacre {

void addChoices(DeviceInfo& info, const graph::FrameCaps& device) {
    const graph::TestedPath path = choosePath(device);
    info.visibility = visibilityName(path.visibility);
    info.why = path.why;
    const MotionSamples motion = chooseMotionSamples(device);
    info.motionSamples = motion.count;
    info.motionWhy = motion.why;
}

graph::FrameCaps deviceCaps(const DeviceOptions& options) { return gpu::Device(options).caps(); }

DeviceInfo deviceInfo(const DeviceOptions& options) {
    const gpu::Device device(options);
    DeviceInfo info = gpu::describeDevice(device.caps(), device.physical());
    addChoices(info, device.caps());
    return info;
}

std::vector<DeviceInfo> listDevices() {
    try {
        const vk::raii::Context context = gpu::makeContext();
        gpu::InstanceExtensions found;
        const vk::raii::Instance instance = gpu::makeInstance(context, false, found);
        std::vector<DeviceInfo> devices;
        for (const auto& physical : vk::raii::PhysicalDevices(instance)) {
            const gpu::Caps caps = gpu::queryCaps(physical);
            devices.push_back(gpu::describeDevice(caps, physical));
            addChoices(devices.back(), caps);
        }
        return devices;
    } catch (const vk::SystemError& failure) {
        throw Error("cannot list devices", "", gpu::inOneLine(failure.what()));
    }
}

}  // namespace nacre
