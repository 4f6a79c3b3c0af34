#include "engine/graph/known_drivers.h"

#include <algorithm>
#include <charconv>

namespace nacre::graph {
namespace {

constexpr std::uint32_t kArm = 0x13B5, kQualcomm = 0x5143, kImagination = 0x1010, kBroadcom = 0x14E4, kAnyVendor = 0;
constexpr VkDriverId kAnyDriver{};
constexpr std::uint32_t kAnyNumber = 0xffffu;

constexpr const char* kStreams = "the command streams that Mesa 25.0.7 writes over its no-op kernel drivers (drm-shim)";

constexpr KnownDriver kRows[] = {
    // Mesa's drivers go first: their devices bear the vendors' names, too.
    {kAnyVendor,
     VK_DRIVER_ID_MESA_TURNIP,
     "",
     0,
     kAnyNumber,
     "turnip",
     {"Mesa's Turnip keeps the three subpasses in GMEM, whatever memory it reports", kStreams}},
    {kAnyVendor,
     VK_DRIVER_ID_MESA_V3DV,
     "",
     0,
     kAnyNumber,
     "v3dv",
     {"Mesa's v3dv makes a job of each subpass, which loads and stores what they share", kStreams}},
    {kAnyVendor,
     VK_DRIVER_ID_MESA_PANVK,
     "",
     0,
     kAnyNumber,
     "panvk",
     {"Mesa's PanVK makes a framebuffer of each subpass, and stores what need not be", kStreams}},
    {kQualcomm,
     kAnyDriver,
     "Adreno",
     500,
     599,
     "adreno-no-subpass",
     {"Adreno 540's driver loses depth from subpass to subpass", "github.com/SaschaWillems/Vulkan issue 484"}},
    {kQualcomm,
     kAnyDriver,
     "Adreno",
     600,
     630,
     "adreno-no-subpass",
     {"Flutter's Impeller reads no input attachments up to Adreno 630: they crash",
      "github.com/flutter/flutter issue 161274"}},
    {kQualcomm,
     kAnyDriver,
     "Adreno",
     631,
     650,
     "adreno-no-subpass",
     {"Impeller has given up Vulkan on Adreno 640 and 650: the least that may go wrong there is asked for",
      "github.com/flutter/flutter issue 178833"}},
    {kQualcomm,
     kAnyDriver,
     "",
     0,
     kAnyNumber,
     "adreno",
     {"Qualcomm's driver keeps subpasses in GMEM",
      "Samsung and Qualcomm, 'Introduction to Vulkan Render Passes', developer.samsung.com/game/qualcomm"}},
    {kArm,
     kAnyDriver,
     "Mali-T",
     0,
     kAnyNumber,
     "mali-old",
     {"Midgard: 8 KiB of tile buffer", "Mesa, src/panfrost/lib/pan_props.c"}},
    {kArm,
     kAnyDriver,
     "Mali-G",
     71,
     71,
     "mali-old",
     {"the first Bifrost: 8 KiB of tile buffer", "Mesa, src/panfrost/lib/pan_props.c"}},
    {kArm,
     kAnyDriver,
     "",
     0,
     kAnyNumber,
     "mali",
     {"from G72 on: 16 KiB of tile buffer and more", "Mesa, src/panfrost/lib/pan_props.c"}},
    {kImagination,
     kAnyDriver,
     "",
     0,
     kAnyNumber,
     "powervr",
     {"subpasses map to pixel local storage", "Imagination, 'PowerVR Performance Recommendations', Vulkan"}},
    {kBroadcom,
     kAnyDriver,
     "",
     0,
     kAnyNumber,
     "v3dv",
     {"VideoCore, by a driver that does not tell its name: as Mesa's", kStreams}},
};

/// Whether a device's name has a row's words in it, and behind them a number in its range ("Mali-G610 MC4" of "Mali-G",
/// "Adreno (TM) 540" of "Adreno"). A row of all numbers wants none.
bool named(const KnownDriver& row, std::string_view device) {
    if (row.name.empty()) return true;
    const std::size_t at = device.find(row.name);
    if (at == std::string_view::npos) return false;
    if (row.least == 0 && row.most == kAnyNumber) return true;
    const std::string_view rest = device.substr(at + row.name.size());
    const std::size_t digit = rest.find_first_of("0123456789");
    if (digit == std::string_view::npos) return false;
    std::uint32_t number = 0;
    std::from_chars(rest.data() + digit, rest.data() + rest.size(), number);
    return number >= row.least && number <= row.most;
}

}  // namespace

std::span<const KnownDriver> knownDrivers() { return kRows; }

DeviceClass classOf(const DriverIdentity& identity) {
    // A layer or a processor is what it is, whosever name it bears.
    if (identity.portable) return {&capabilitySet("apple-moltenvk"), DeviceKind::layered, nullptr};
    const auto fits = [&](const KnownDriver& row) {
        return (row.vendor == 0 || row.vendor == identity.vendor) &&
               (row.driver == kAnyDriver || row.driver == identity.driver) && named(row, identity.device);
    };
    const auto row = std::find_if(std::begin(kRows), std::end(kRows), fits);
    if (!identity.software && row != std::end(kRows)) {
        const CapabilitySet& set = capabilitySet(row->set);
        return {&set, set.kind, row};
    }
    const DeviceKind kind = identity.lazyMemory ? DeviceKind::tiler
                            : identity.software ? DeviceKind::software
                                                : DeviceKind::immediate;
    return {&capabilitySet("desktop"), kind, nullptr};
}

}  // namespace nacre::graph
