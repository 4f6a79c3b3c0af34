#include "engine/graph/known_drivers.h"

#include <algorithm>
#include <charconv>

namespace nacre::graph {
namespace {

constexpr std::uint32_t kArm = 0x13B5, kQualcomm = 0x5143, kImagination = 0x1010, kBroadcom = 0x14E4, kHuawei = 0x19E5,
                        kSamsung = 0x144D;
constexpr std::uint32_t kAnyNumber = 0xffffu;

constexpr const char* kStreams = "the command streams that Mesa 25.0.7 writes over its no-op kernel drivers (drm-shim)";
constexpr const char* kAngle = "ANGLE, vk_renderer.cpp: supportsDynamicRenderingLocalRead";
constexpr const char* kAngleFetch = "ANGLE of 2026-08, vk_renderer.cpp: coherent framebuffer fetch";
constexpr Fact kPixelLocal{"from the C-series on: subpasses map to pixel local storage",
                           "Imagination, 'PowerVR Performance Recommendations', Vulkan"};

// Headers of 1.3.239 have no names for them.
constexpr VkDriverId kHoneykrisp = static_cast<VkDriverId>(26), kKosmicKrisp = static_cast<VkDriverId>(28);
/// Imagination numbers its drivers by build: 25.1 is "25.1@6794074".
constexpr std::uint32_t kImagination251 = 6794074;
constexpr const char* kPixel10 = "github.com/flutter/flutter issue 179812, and driver_info_vk.cc";
constexpr const char* kLateVertices =
    "Arm, 'Arm GPUs built on the 5th Generation architecture': deferred vertex shading";
constexpr const char* kImpeller = "Flutter's Impeller, driver_info_vk.cc: it refuses Vulkan there";

/// For any vendor.
constexpr DriverPattern by(VkDriverId driver) { return {0, driver}; }
constexpr DriverPattern named(std::uint32_t vendor, std::string_view name, std::uint32_t least = 0,
                              std::uint32_t most = kAnyNumber) {
    return {vendor, {}, name, least, most};
}

constexpr KnownDriver kRows[] = {
    // Mesa's drivers go first: their devices also have the vendors' names.
    {by(VK_DRIVER_ID_MESA_TURNIP),
     "turnip",
     {"Mesa's Turnip keeps the three subpasses in GMEM, whatever memory it reports", kStreams}},
    {by(VK_DRIVER_ID_MESA_V3DV),
     "v3dv",
     {"Mesa's v3dv makes a job of each subpass, which loads and stores what they share", kStreams}},
    {by(VK_DRIVER_ID_MESA_PANVK),
     "panvk",
     {"Mesa's PanVK makes a framebuffer of each subpass, and stores what need not be", kStreams}},
    {by(kHoneykrisp),
     "apple-moltenvk",
     {"Mesa's Honeykrisp, on Apple's GPUs without Metal: Mesa's common code begins a rendering for each subpass",
      "Mesa, src/vulkan/runtime/vk_render_pass.c; src/asahi/vulkan has no render passes of its own"}},
    {by(kKosmicKrisp),
     "apple-moltenvk",
     {"Mesa's KosmicKrisp, on Metal without the portability subset: Mesa's common code begins a render encoder for "
      "each "
      "subpass",
      "Mesa, src/vulkan/runtime/vk_render_pass.c and src/kosmickrisp/vulkan/kk_cmd_draw.c"}},
    {named(kQualcomm, "Adreno", 500, 599),
     "adreno-no-subpass",
     {"Adreno 540's driver loses depth from subpass to subpass. Others report that gl_FragDepth is wrong there: the "
      "self-test decides, and a device without a correct path is refused",
      "github.com/SaschaWillems/Vulkan issue 484; github.com/hrydgard/ppsspp issues 10421, 11535 and 11620"}},
    {named(kQualcomm, "Adreno", 600, 630),
     "adreno-no-subpass",
     {"Flutter's Impeller reads no input attachments up to Adreno 630: they crash",
      "github.com/flutter/flutter issue 161274"}},
    {named(kQualcomm, "Adreno", 631, 650),
     "adreno-no-subpass",
     {"Impeller has given up Vulkan on Adreno 640 and 650: the least risky path is taken there",
      "github.com/flutter/flutter issue 178833"}},
    {named(kQualcomm, ""),
     "adreno",
     {"Qualcomm's driver keeps subpasses in GMEM",
      "Samsung and Qualcomm, 'Introduction to Vulkan Render Passes', developer.samsung.com/game/qualcomm"}},
    {named(kArm, "Mali-T"), "mali-old", {"Midgard: 8 KiB of tile buffer", "Mesa, src/panfrost/lib/pan_props.c"}},
    {named(kArm, "Mali-G", 71, 71),
     "mali-old",
     {"the first Bifrost: 8 KiB of tile buffer", "Mesa, src/panfrost/lib/pan_props.c"}},
    {named(kArm, "Mali-G", 620, 625), "mali-late", {"G620 and G625 shade vertices late", kLateVertices}},
    {named(kArm, "Mali-G", 720, 999), "mali-late", {"G720, G725 and G925 shade vertices late", kLateVertices}},
    {named(kArm, "G1-"), "mali-late", {"Mali G1-Ultra, -Premium and -Pro shade vertices late", kLateVertices}},
    {named(kArm, ""), "mali", {"from G72 on: 16 KiB of tile buffer and more", "Mesa, src/panfrost/lib/pan_props.c"}},
    {named(kImagination, "BX"),
     "no-subpass",
     {"B-series: Impeller gave up Vulkan there after reports of wrong pictures",
      "github.com/flutter/flutter pull request 191808"}},
    {{kImagination, {}, "DXT", 0, kAnyNumber, kImagination251},
     "no-subpass",
     {"Pixel 10 with a driver before 25.1", kPixel10}},
    {named(kImagination, "CX"), "powervr", kPixelLocal},
    {named(kImagination, "DX"), "powervr", kPixelLocal},
    {named(kImagination, ""), "no-subpass", {"PowerVR before the B-series", kImpeller}},
    {named(kHuawei, ""), "no-subpass", {"Maleoon", kImpeller}},
    {{kSamsung, {}, "Xclipse", 0, kAnyNumber, 0, VK_API_VERSION_1_3},
     "no-subpass",
     {"Xclipse below Vulkan 1.3", kImpeller}},
    {named(kBroadcom, ""), "v3dv", {"VideoCore, by a driver that does not tell its name: as Mesa's", kStreams}},
};

constexpr KnownQuirk kQuirks[] = {
    {by(VK_DRIVER_ID_MOLTENVK),
     Quirk::noLocalRead,
     {"MoltenVK begins its encoder anew when the number of inputs changes: memoryless depth is lost",
      "MoltenVK 1.4, MVKCommandBuffer.mm and MVKRenderPass.mm"}},
    {by(kKosmicKrisp),
     Quirk::noLocalRead,
     {"KosmicKrisp is drawn in one subpass without inputs", "Mesa, src/kosmickrisp/vulkan/kk_cmd_draw.c"}},
    {by(VK_DRIVER_ID_MESA_TURNIP),
     Quirk::noLocalRead,
     {"Turnip takes masked colour attachments for blending: it gives up its coarse depth test (LRZ) where plates are "
      "drawn beside them, which a subpass of depth alone is not",
      kStreams}},
    {by(VK_DRIVER_ID_GOOGLE_SWIFTSHADER),
     Quirk::noLocalRead,
     {"SwiftShader ends the program with an illegal instruction in steady frames of a window",
      "tests/desktop, by SwiftShader of Debian's Chromium"}},
    {by(VK_DRIVER_ID_SAMSUNG_PROPRIETARY), Quirk::noLocalRead, {"Xclipse", kAngle}},
    {{kArm, VK_DRIVER_ID_ARM_PROPRIETARY, "", 0, kAnyNumber, VK_MAKE_VERSION(52, 0, 0)},
     Quirk::noLocalRead,
     {"Arm's driver before r52", kAngle}},
    {{kQualcomm, VK_DRIVER_ID_QUALCOMM_PROPRIETARY},
     Quirk::noLocalRead,
     {"Qualcomm's driver: wrong before 512.801, and from there on nobody has measured whether it keeps its coarse "
      "depth test (LRZ) where plates are drawn beside masked colour attachments, which Turnip does not",
      "ANGLE, vk_renderer.cpp; crbug.com/415738891; Mesa, src/freedreno/vulkan/tu_lrz.cc"}},
    {{kImagination, VK_DRIVER_ID_IMAGINATION_PROPRIETARY},
     Quirk::noLocalRead,
     {"PowerVR", "ANGLE, vk_renderer.cpp; issuetracker.google.com/372273294"}},
    {{kQualcomm, VK_DRIVER_ID_QUALCOMM_PROPRIETARY, "Adreno", 600, 699, VK_MAKE_VERSION(512, 503, 0)},
     Quirk::dispatchesApart,
     {"a dispatch behind dynamic viewport or scissor state of the same command buffer crashes",
      "github.com/godotengine/godot pull request 91514"}},
    {by(VK_DRIVER_ID_GOOGLE_SWIFTSHADER),
     Quirk::cacheMixesRenderPasses,
     {"SwiftShader keys shaders by the address of the render pass",
      "wrong shaders with a pipeline cache, by SwiftShader of Debian's Chromium"}},
    {{kImagination, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "DXT", 0, kAnyNumber, kImagination251},
     Quirk::noPipelineCache,
     {"vkCreatePipelineCache crashes on Pixel 10", "github.com/godotengine/godot issue 115171"}},
    {{kImagination, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "Rogue"},
     Quirk::oneCompiler,
     {"Rogue's compiler crashes when several threads make pipelines",
      "github.com/godotengine/godot pull request 123614"}},
    {{kImagination, VK_DRIVER_ID_IMAGINATION_PROPRIETARY, "BXM", 8, 8},
     Quirk::oneCompiler,
     {"BXM-8-256's compiler crashes when several threads make pipelines",
      "github.com/godotengine/godot pull request 123614"}},
    {{kArm, VK_DRIVER_ID_ARM_PROPRIETARY},
     Quirk::keepsOrder,
     {"Arm's driver: ANGLE takes framebuffer fetch for coherent there", kAngleFetch}},
    {{kImagination, VK_DRIVER_ID_IMAGINATION_PROPRIETARY},
     Quirk::keepsOrder,
     {"PowerVR: ANGLE takes framebuffer fetch for coherent there", kAngleFetch}},
    {by(VK_DRIVER_ID_MESA_LLVMPIPE),
     Quirk::heapPerTile,
     {"lavapipe calls malloc() and free() for each tile: a tenth of a frame with glibc's defaults",
      "perf record of nacre bench, Mesa 22.3 and 25.0"}},
};

/// Whether a device's name contains a row's text, followed by a number in its range ("Mali-G610 MC4" for "Mali-G",
/// "Adreno (TM) 540" for "Adreno"). A row with the full range needs no number.
bool hasName(const DriverPattern& of, std::string_view device) {
    if (of.name.empty()) return true;
    const std::size_t at = device.find(of.name);
    if (at == std::string_view::npos) return false;
    if (of.least == 0 && of.most == kAnyNumber) return true;
    const std::string_view rest = device.substr(at + of.name.size());
    const std::size_t digit = rest.find_first_of("0123456789");
    if (digit == std::string_view::npos) return false;
    std::uint32_t number = 0;
    std::from_chars(rest.data() + digit, rest.data() + rest.size(), number);
    return number >= of.least && number <= of.most;
}

/// A driver without a name is its vendor's own.
bool fits(const DriverPattern& of, const DriverIdentity& identity) {
    const bool own = identity.driver == VkDriverId{} && of.vendor != 0;
    return (of.vendor == 0 || of.vendor == identity.vendor) &&
           (of.driver == VkDriverId{} || of.driver == identity.driver || own) &&
           (of.before == 0 || identity.version < of.before) &&
           (of.beforeVulkan == 0 || identity.vulkan < of.beforeVulkan) && hasName(of, identity.device);
}

}  // namespace

std::span<const KnownDriver> knownDrivers() { return kRows; }
std::span<const KnownQuirk> knownQuirks() { return kQuirks; }

std::uint32_t findQuirks(const DriverIdentity& identity) {
    std::uint32_t quirks = 0;
    for (const KnownQuirk& row : kQuirks)
        if (fits(row.of, identity)) quirks |= 1u << static_cast<unsigned>(row.quirk);
    return quirks;
}

bool has(Quirk quirk, const DriverIdentity& identity) {
    return (findQuirks(identity) >> static_cast<unsigned>(quirk) & 1) != 0;
}

DeviceClass classifyDriver(const DriverIdentity& identity) {
    // Layered and software drivers are recognised whatever their vendor name.
    if (identity.portable) return {&capabilitySet("apple-moltenvk"), DeviceKind::layered, nullptr};
    const auto row = std::ranges::find_if(kRows, [&](const KnownDriver& r) { return fits(r.of, identity); });
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
