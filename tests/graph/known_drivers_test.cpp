#include "engine/graph/known_drivers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace nacre::graph {
namespace {

constexpr std::uint32_t kQualcommId = 0x5143, kArmId = 0x13B5;

DriverIdentity identity(std::uint32_t vendor, VkDriverId driver, std::string_view device) {
    DriverIdentity of;
    of.vendor = vendor;
    of.driver = driver;
    of.device = device;
    return of;
}

struct Told {
    std::uint32_t vendor;
    VkDriverId driver;
    const char* device;
    const char* set;
    Visibility visibility;
};

// As the drivers name their devices.
constexpr Told kTold[] = {
    {kQualcommId, VK_DRIVER_ID_MESA_TURNIP, "Turnip Adreno (TM) 740", "turnip", Visibility::encoded},
    {kQualcommId, VK_DRIVER_ID_MESA_TURNIP, "Turnip Adreno (TM) 618", "turnip", Visibility::encoded},
    {0x14E4, VK_DRIVER_ID_MESA_V3DV, "V3D 7.1.7.0", "v3dv", Visibility::fragdepth},
    {0x14E4, VkDriverId{}, "V3D 4.2", "v3dv", Visibility::fragdepth},
    {kArmId, VK_DRIVER_ID_MESA_PANVK, "Mali-G610 MC4", "panvk", Visibility::fragdepth},
    {kQualcommId, VK_DRIVER_ID_QUALCOMM_PROPRIETARY, "Adreno (TM) 540", "adreno-no-subpass", Visibility::fragdepth},
    {kQualcommId, VK_DRIVER_ID_QUALCOMM_PROPRIETARY, "Adreno (TM) 630", "adreno-no-subpass", Visibility::fragdepth},
    {kQualcommId, VkDriverId{}, "Adreno (TM) 650", "adreno-no-subpass", Visibility::fragdepth},
    {kQualcommId, VK_DRIVER_ID_QUALCOMM_PROPRIETARY, "Adreno (TM) 660", "adreno", Visibility::encoded},
    {kQualcommId, VK_DRIVER_ID_QUALCOMM_PROPRIETARY, "Adreno (TM) 750", "adreno", Visibility::encoded},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-T880", "mali-old", Visibility::encoded},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G71", "mali-old", Visibility::encoded},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G710", "mali", Visibility::encoded},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G72", "mali", Visibility::encoded},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Immortalis-G715", "mali", Visibility::encoded},
    {0x1010, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "PowerVR Rogue GE8320", "powervr", Visibility::encoded},
};

TEST(KnownDrivers, TellTilersByVendorDriverAndDevice) {
    std::set<const KnownDriver*> met;
    for (const Told& told : kTold) {
        SCOPED_TRACE(told.device);
        const DeviceClass found = classOf(identity(told.vendor, told.driver, told.device));
        EXPECT_EQ(found.set->plan.name, told.set);
        EXPECT_EQ(found.kind, DeviceKind::tiler);  // without lazily allocated memory
        EXPECT_EQ(chooseVisibility(found.kind, found.set->plan).visibility, told.visibility);
        met.insert(found.row);
    }
    // Each row has a device here, and a source.
    EXPECT_EQ(met.size(), knownDrivers().size());
    for (const KnownDriver& row : knownDrivers()) {
        EXPECT_NO_THROW(capabilitySet(row.set));
        EXPECT_GT(std::string(row.fact.source).size(), 10u) << row.fact.what;
    }
}

TEST(KnownDrivers, WhatNobodyKnowsGoesByItsMemory) {
    DriverIdentity of = identity(0x10DE, VK_DRIVER_ID_NVIDIA_PROPRIETARY, "NVIDIA H200");
    EXPECT_EQ(classOf(of).kind, DeviceKind::immediate);
    EXPECT_EQ(classOf(of).row, nullptr);
    of.lazyMemory = true;
    EXPECT_EQ(classOf(of).kind, DeviceKind::tiler);
    EXPECT_EQ(classOf(of).set->plan.name, "desktop");
}

TEST(KnownDrivers, SoftwareAndLayersAreWhatTheyAre) {
    DriverIdentity of = identity(kArmId, VK_DRIVER_ID_MESA_LLVMPIPE, "llvmpipe (LLVM 15.0.6, 256 bits)");
    of.software = true;
    EXPECT_EQ(classOf(of).kind, DeviceKind::software);
    of.lazyMemory = true;  // a phone that is played
    EXPECT_EQ(classOf(of).kind, DeviceKind::tiler);
    DriverIdentity apple = identity(0x106B, VK_DRIVER_ID_MOLTENVK, "Apple M2");
    apple.portable = apple.lazyMemory = true;
    EXPECT_EQ(classOf(apple).kind, DeviceKind::layered);
    EXPECT_EQ(classOf(apple).set->plan.name, "apple-moltenvk");
}

}  // namespace
}  // namespace nacre::graph
