#include "engine/device_plan.h"

#include "engine/gpu/device.h"

namespace nacre {

DevicePlan planOf(const DeviceOptions& options) {
    const gpu::Device device(options);
    const gpu::Caps& caps = device.caps();
    return {caps.deviceName, caps.plan,   caps.visibility, caps.visibilityReason,
            caps.encoded,    caps.motion, caps.tiles.shade};
}

}  // namespace nacre
