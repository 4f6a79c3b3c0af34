// Tests of every path take those that the device has: no fewer than it draws by, and all on software devices.

#include "tests/support/device_paths.h"

#include "engine/error.h"
#include "tests/renderer/scenes.h"

namespace nacre::test {
namespace {

TEST(DevicePaths, AreAtLeastFourAndAllOfASoftwareDevice) {
    EXPECT_GE(devicePaths().size(), 4u) << testedDevice().name;
    if (isSoftwareDevice()) {
        EXPECT_TRUE(std::ranges::equal(devicePaths(), kEveryPath)) << testedDevice().name;
    }
}

TEST(DevicePaths, AreThoseThatARendererTakes) {
    for (const Visibility path : kEveryPath) {
        const DeviceOptions options{false, "", path};
        if (isDevicePath(path))
            EXPECT_EQ(Renderer(options).stats().device.name, testedDevice().name) << visibilityName(path);
        else
            EXPECT_THROW(Renderer{options}, Error) << visibilityName(path);
    }
}

}  // namespace
}  // namespace nacre::test
