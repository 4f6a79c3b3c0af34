#pragma once
// The device under test, which the environment's drivers have, and the paths that it draws by.

#include <algorithm>
#include <vector>

#include "engine/devices.h"
#include "engine/frame/choose.h"

namespace nacre::test {

inline constexpr Visibility kEveryPath[] = {Visibility::encoded, Visibility::fragdepth, Visibility::deferred,
                                            Visibility::rasterOrder, Visibility::tiles};

inline const DeviceInfo& testedDevice() {
    static const DeviceInfo device = deviceInfo(DeviceOptions{});
    return device;
}

/// Whether the device is a CPU. Its frames have other passes: squares, and depth tests behind shaders that write depth.
inline bool isSoftwareDevice() { return testedDevice().type == "software"; }

/// Those of kEveryPath that the device has. Desktop GPUs lack raster order.
inline const std::vector<Visibility>& devicePaths() {
    static const std::vector<Visibility> paths = [] {
        std::vector<Visibility> some;
        for (const Visibility path : kEveryPath)
            if (hasPath(path, testedDevice().rasterOrder)) some.push_back(path);
        return some;
    }();
    return paths;
}

inline bool isDevicePath(Visibility path) { return std::ranges::count(devicePaths(), path) > 0; }

}  // namespace nacre::test
