#include "engine/graph/known_drivers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "engine/frame/choose.h"

namespace nacre::graph {
namespace {

constexpr std::uint32_t kQualcommId = 0x5143, kArmId = 0x13B5, kImagination = 0x1010;
constexpr auto kOfImagination = VK_DRIVER_ID_IMAGINATION_PROPRIETARY;

DriverIdentity identity(std::uint32_t vendor, VkDriverId driver, std::string_view device) {
    return {.vendor = vendor, .driver = driver, .device = std::string(device)};
}

Visibility pickPath(const DeviceClass& device) {
    FrameCaps caps = *device.set;
    caps.kind = device.kind;
    return choosePath(caps).visibility;
}

struct Told {
    std::uint32_t vendor;
    VkDriverId driver;
    const char* device;
    const char* set;
    Visibility visibility;
    std::uint32_t vulkan = VK_API_VERSION_1_1;
    std::uint32_t version = 0;
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
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G710", "mali", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G72", "mali", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Immortalis-G715", "mali", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G615 MC2", "mali", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G620 MC4", "mali-late", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G720-Immortalis MC12", "mali-late", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G925-Immortalis MC12", "mali-late", Visibility::rasterOrder},
    {kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G1-Ultra MC12", "mali-late", Visibility::rasterOrder},
    {kImagination, kOfImagination, "PowerVR B-Series BXM-8-256", "no-subpass", Visibility::fragdepth},
    {kImagination, kOfImagination, "PowerVR CXTP-48-1536", "powervr", Visibility::encoded},
    {kImagination, kOfImagination, "PowerVR D-Series DXT-48-1536 MC1", "no-subpass", Visibility::fragdepth,
     VK_API_VERSION_1_3, 6660496},  // 24.3
    {kImagination, kOfImagination, "PowerVR D-Series DXT-48-1536 MC1", "powervr", Visibility::encoded,
     VK_API_VERSION_1_3, 6794074},  // 25.1
    {0x1010, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "PowerVR Rogue GE8320", "no-subpass", Visibility::fragdepth},
    {0x19E5, VkDriverId{}, "Maleoon 910", "no-subpass", Visibility::fragdepth},
    {0x144D, VK_DRIVER_ID_SAMSUNG_PROPRIETARY, "Samsung Xclipse 920", "no-subpass", Visibility::fragdepth},
};

TEST(KnownDrivers, TellTilersByVendorDriverAndDevice) {
    std::set<const KnownDriver*> met;
    for (const Told& told : kTold) {
        SCOPED_TRACE(told.device);
        DriverIdentity of = identity(told.vendor, told.driver, told.device);
        of.vulkan = told.vulkan;
        of.version = told.version;
        const DeviceClass found = classifyDriver(of);
        EXPECT_EQ(found.set->plan.name, told.set);
        EXPECT_EQ(found.kind, DeviceKind::tiler);  // without lazily allocated memory
        EXPECT_EQ(pickPath(found), told.visibility);
        met.insert(found.row);
    }
    for (const int driver : {26, 28}) {  // Honeykrisp, KosmicKrisp
        const DeviceClass apple = classifyDriver(identity(0x106B, static_cast<VkDriverId>(driver), "Apple M2"));
        EXPECT_EQ(apple.kind, DeviceKind::layered);
        EXPECT_EQ(pickPath(apple), Visibility::fragdepth);
        met.insert(apple.row);
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
    EXPECT_EQ(classifyDriver(of).kind, DeviceKind::immediate);
    EXPECT_EQ(classifyDriver(of).row, nullptr);
    of.lazyMemory = true;
    EXPECT_EQ(classifyDriver(of).kind, DeviceKind::tiler);
    EXPECT_EQ(classifyDriver(of).set->plan.name, "desktop");
}

TEST(KnownDrivers, AVersionIsPartOfAnIdentity) {
    DriverIdentity xclipse = identity(0x144D, VK_DRIVER_ID_SAMSUNG_PROPRIETARY, "Samsung Xclipse 940");
    xclipse.vulkan = VK_API_VERSION_1_3;
    EXPECT_EQ(classifyDriver(xclipse).row, nullptr);

    const auto told = [](Quirk quirk, std::uint32_t vendor, VkDriverId driver, const char* device, std::uint32_t major,
                         std::uint32_t minor) {
        DriverIdentity of = identity(vendor, driver, device);
        of.version = VK_MAKE_VERSION(major, minor, 0);
        return has(quirk, of);
    };
    constexpr auto kOwn = VK_DRIVER_ID_QUALCOMM_PROPRIETARY, kTurnip = VK_DRIVER_ID_MESA_TURNIP;
    constexpr auto kApart = Quirk::dispatchesApart, kNoLocalRead = Quirk::noLocalRead;
    EXPECT_TRUE(told(kApart, kQualcommId, kOwn, "Adreno (TM) 660", 512, 502));
    EXPECT_TRUE(told(kApart, kQualcommId, VkDriverId{}, "Adreno (TM) 618", 64, 17));
    EXPECT_FALSE(told(kApart, kQualcommId, kOwn, "Adreno (TM) 660", 512, 503));
    EXPECT_FALSE(told(kApart, kQualcommId, kOwn, "Adreno (TM) 730", 512, 502));
    EXPECT_FALSE(told(kApart, kQualcommId, kTurnip, "Turnip Adreno (TM) 660", 25, 0));
    EXPECT_TRUE(told(kNoLocalRead, kQualcommId, kOwn, "Adreno (TM) 740", 512, 800));
    EXPECT_TRUE(told(kNoLocalRead, kQualcommId, kOwn, "Adreno (TM) 830", 512, 801));
    EXPECT_TRUE(told(kNoLocalRead, kQualcommId, kTurnip, "Turnip Adreno (TM) 740", 25, 0));
    EXPECT_TRUE(told(kNoLocalRead, kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G710", 51, 0));
    EXPECT_FALSE(told(kNoLocalRead, kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-G710", 52, 0));
    EXPECT_TRUE(told(kNoLocalRead, 0x1010, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "PowerVR DXT", 25, 1));
    EXPECT_TRUE(told(kNoLocalRead, 0x144D, VK_DRIVER_ID_SAMSUNG_PROPRIETARY, "Samsung Xclipse 940", 25, 1));
    EXPECT_TRUE(told(kNoLocalRead, 0x106B, VK_DRIVER_ID_MOLTENVK, "Apple M2", 0, 2));
    EXPECT_TRUE(told(kNoLocalRead, 0x106B, static_cast<VkDriverId>(28), "Apple M2", 26, 0));
    EXPECT_TRUE(told(kNoLocalRead, 0x1AE0, VK_DRIVER_ID_GOOGLE_SWIFTSHADER, "SwiftShader Device", 5, 0));
    EXPECT_FALSE(told(kNoLocalRead, 0x10DE, VK_DRIVER_ID_NVIDIA_PROPRIETARY, "NVIDIA H200", 550, 0));
    EXPECT_FALSE(told(kNoLocalRead, 0x10005, VK_DRIVER_ID_MESA_LLVMPIPE, "llvmpipe", 25, 0));
    EXPECT_TRUE(
        told(Quirk::heapPerTile, 0x10005, VK_DRIVER_ID_MESA_LLVMPIPE, "llvmpipe (LLVM 15.0.6, 256 bits)", 0, 0));
    EXPECT_FALSE(told(Quirk::heapPerTile, 0x1AE0, VK_DRIVER_ID_GOOGLE_SWIFTSHADER, "SwiftShader Device", 5, 0));
    EXPECT_TRUE(
        told(Quirk::cacheMixesRenderPasses, 0x1AE0, VK_DRIVER_ID_GOOGLE_SWIFTSHADER, "SwiftShader Device", 5, 0));
    EXPECT_FALSE(told(Quirk::cacheMixesRenderPasses, 0x10005, VK_DRIVER_ID_MESA_LLVMPIPE, "llvmpipe", 25, 0));
    constexpr const char* kPixel10 = "PowerVR D-Series DXT-48-1536 MC1";
    const auto imagination = [](Quirk quirk, const char* device, std::uint32_t build) {
        DriverIdentity of = identity(kImagination, kOfImagination, device);
        of.version = build;
        return has(quirk, of);
    };
    EXPECT_TRUE(imagination(Quirk::noPipelineCache, kPixel10, 6660496));
    EXPECT_FALSE(imagination(Quirk::noPipelineCache, kPixel10, 6794074));
    EXPECT_FALSE(imagination(Quirk::noPipelineCache, "PowerVR Rogue GE8320", 5000000));
    EXPECT_TRUE(imagination(Quirk::oneCompiler, "PowerVR Rogue GE8320", 5000000));
    EXPECT_TRUE(imagination(Quirk::oneCompiler, "PowerVR B-Series BXM-8-256", 6000000));
    EXPECT_FALSE(imagination(Quirk::oneCompiler, "PowerVR B-Series BXM-4-64", 6000000));
    EXPECT_FALSE(imagination(Quirk::oneCompiler, kPixel10, 6660496));
    // Order that no extension promises: of both vendors' own drivers.
    EXPECT_TRUE(told(Quirk::keepsOrder, kArmId, VK_DRIVER_ID_ARM_PROPRIETARY, "Mali-T880", 20, 0));
    EXPECT_TRUE(imagination(Quirk::keepsOrder, "PowerVR CXTP-48-1536", 6794074));
    EXPECT_FALSE(told(Quirk::keepsOrder, kArmId, VK_DRIVER_ID_MESA_PANVK, "Mali-G610 MC4", 25, 0));
    EXPECT_FALSE(told(Quirk::keepsOrder, kQualcommId, kOwn, "Adreno (TM) 740", 512, 800));
    for (const KnownQuirk& row : knownQuirks()) EXPECT_GT(std::string(row.fact.source).size(), 10u) << row.fact.what;
}

TEST(KnownDrivers, SoftwareAndLayersAreWhatTheyAre) {
    DriverIdentity of = identity(kArmId, VK_DRIVER_ID_MESA_LLVMPIPE, "llvmpipe (LLVM 15.0.6, 256 bits)");
    of.software = true;
    EXPECT_EQ(classifyDriver(of).kind, DeviceKind::software);
    of.lazyMemory = true;  // a phone that is played
    EXPECT_EQ(classifyDriver(of).kind, DeviceKind::tiler);
    DriverIdentity apple = identity(0x106B, VK_DRIVER_ID_MOLTENVK, "Apple M2");
    apple.portable = apple.lazyMemory = true;
    EXPECT_EQ(classifyDriver(apple).kind, DeviceKind::layered);
    EXPECT_EQ(classifyDriver(apple).set->plan.name, "apple-moltenvk");
}

}  // namespace
}  // namespace nacre::graph
