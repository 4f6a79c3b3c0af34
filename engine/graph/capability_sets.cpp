#include "engine/graph/capability_sets.h"

#include "engine/error.h"

namespace nacre::graph {
namespace {

constexpr const char* kBlendTable =
    "Vulkan specification, 'Required Format Support': COLOR_ATTACHMENT_BLEND is mandatory for R16G16B16A16_SFLOAT and "
    "not for R32_SFLOAT";
constexpr const char* kMesaTiles =
    "Mesa, src/panfrost/lib/pan_props.c: tile buffer of 8 KiB up to T880 and G71, 16 KiB from G72 on; a tile has 16x16 "
    "pixels, and half the buffer is left to the next tile";

constexpr const char* kArmVertices =
    "Arm, 'Mali GPU Best Practices', index-driven vertex shading: positions and varyings are written to memory, and "
    "read "
    "from there by fragments";
constexpr const char* kStoredVaryings =
    "positions and varyings go through memory: shapes of few corners until spheres are large";
constexpr const char* kMostVertices =
    "a render pass of more than 180 MB of vertex outputs loses the device: none gets more than 150 MB";
constexpr const char* kArmMemory = "Vulkan samples, docs/memory_limits.adoc: Memory limits with Vulkan, Mali GPUs";
constexpr Fact kMali[] = {
    {kStoredVaryings, kArmVertices},
    {kMostVertices, kArmMemory},
    {"256 bits per pixel on the tile, hardware depth beside them", kMesaTiles},
    {"subpasses that read each other's pixel alone run on one tile",
     "Arm, 'Vulkan best practice for mobile developers', render subpasses tutorial"},
    {"MIN is a blend shader, and R32F does not blend: encoded depth is R32F that is written in raster order",
     "Mesa, src/panfrost/lib/pan_blend.c: can_fixed_function_equation; VK_ARM_rasterization_order_attachment_access, "
     "contributed by Arm, promoted to EXT"},
    {"a tested depth buffer need not be stored again", "VK_EXT_load_store_op_none, vulkan.gpuinfo.org, Arm drivers"},
};
constexpr Fact kMaliLate[] = {
    {"positions alone go through memory: varyings are made when a tile is drawn, so that thresholds are those of GPUs "
     "that keep them on the chip",
     "Arm, 'Arm GPUs built on the 5th Generation architecture': deferred vertex shading"},
    {"256 bits per pixel on the tile, hardware depth beside them", kMesaTiles},
    {"MIN is a blend shader, and R32F does not blend: encoded depth is R32F that is written in raster order",
     "Mesa, src/panfrost/lib/pan_blend.c: can_fixed_function_equation"},
};
constexpr Fact kMaliOld[] = {
    {kStoredVaryings, kArmVertices},
    {kMostVertices, kArmMemory},
    {"128 bits per pixel on the tile, hardware depth beside them", kMesaTiles},
    {"the vendor states the same limit: 128 bits of colour per pixel, D32F not counted",
     "Arm, 'Vulkan best practice for mobile developers', render subpasses tutorial"},
    {"R32F does not blend; encoded depth takes RGBA16F", kBlendTable},
};
constexpr Fact kAdreno[] = {
    {"input attachments stay in GMEM between subpasses; bins shrink as pixels grow, and 24 B per pixel is our own "
     "budget: colour, encoded depth, the sum of samples and the window",
     "Samsung and Qualcomm, 'Introduction to Vulkan Render Passes', developer.samsung.com/game/qualcomm"},
    {"Adreno 5xx does not blend R32F; encoded depth takes RGBA16F", kBlendTable},
    {"a tested depth buffer need not be stored again",
     "VK_QCOM_render_pass_store_ops, later VK_EXT_load_store_op_none"},
};
constexpr Fact kAdrenoNoSubpass[] = {
    {"some drivers fail to compile shaders with input attachments, or crash in them",
     "github.com/microsoft/DirectXShaderCompiler issue 2842; github.com/SaschaWillems/Vulkan pull request 697"},
};
constexpr Fact kNoSubpass[] = {
    {"one subpass, and nothing read from the tile: the least risk", "engine/graph/known_drivers.cpp"},
};
constexpr Fact kPowerVr[] = {
    {kStoredVaryings,
     "Imagination, 'PowerVR Series5 Architecture Guide': the tiling accelerator writes transformed vertices to the "
     "parameter buffer in memory"},
    {"input attachments stay on the tile; 16 B per pixel is our own budget",
     "Imagination, 'PowerVR Performance Recommendations', Vulkan: subpasses map to pixel local storage"},
    {"R32F need not blend; encoded depth takes RGBA16F", kBlendTable},
    {"floating-point formats blend by shader code: one pass in raster order does without, where the driver has it",
     "Mesa, src/imagination/vulkan/pvr_formats.c"},
};
constexpr Fact kApple[] = {
    {"every subpass is a Metal render pass of its own, so nothing survives on the tile from one to the next",
     "github.com/KhronosGroup/MoltenVK issue 2454"},
    {"memoryless attachments work within one Metal encoder alone", "github.com/KhronosGroup/MoltenVK issue 490"},
    {"an input attachment becomes a plain texture read", "github.com/KhronosGroup/MoltenVK issue 2281"},
    {"256 bits per pixel on the tile (512 from Apple4 on)", "Apple, 'Metal Feature Set Tables'"},
};
constexpr const char* kShim = "the command streams that Mesa 25.0.7 writes over its no-op kernel drivers (drm-shim)";
constexpr Fact kTurnip[] = {
    {"encoded: three clears, no load, one store per tile; the input attachment is read from GMEM", kShim},
    {"R32F blends, in fewer instructions than RGBA16F (48 and 117 for a sphere of the encoding on A740)", kShim},
    {"a fragment shader that writes depth is tested late, whatever it declares", kShim},
    {"no lazily allocated memory is reported", kShim},
    {"fragment density maps, of 32 pixels per texel, for images that are no subsampled ones",
     "Mesa 25.0.7, src/freedreno/vulkan/tu_device.cc: EXT_fragment_density_map, MIN_FDM_TEXEL_SIZE"},
};
constexpr Fact kV3dv[] = {
    {"one job per subpass: the depth that two share is stored and loaded again", kShim},
    {"fragdepth, in one subpass, stores colour alone", kShim},
    {"a fragment shader that writes depth is tested late, whatever it declares: plates reject nothing there", kShim},
};
constexpr Fact kPanvk[] = {
    {kStoredVaryings, kArmVertices},
    {"one framebuffer per subpass", kShim},
    {"depth is stored although no pass reads it", kShim},
    {"every invocation loads the directions of a batch for itself: 48 of a texel's 53 loads on G610", kShim},
    {"a fragment shader that writes depth is tested late, whatever it declares: plates reject nothing there", kShim},
};
constexpr Fact kDesktop[] = {
    {"no lazily allocated memory, no tile: transient attachments save nothing",
     "VkPhysicalDeviceMemoryProperties of immediate-mode GPUs, vulkan.gpuinfo.org"},
};

PlanCaps plan(const char* name, std::uint32_t tileBytes, bool storeNone) {
    PlanCaps caps;
    caps.name = name;
    caps.tileBytesPerPixel = tileBytes;
    caps.storeNone = storeNone;
    return caps;
}

/// Radius from which more corners pay, by counts (docs/tilers.md): instructions of Mesa's compilers times vertices and
/// fragments; for GPUs that store varyings, 100 pJ per byte and 10 per instruction. Where depth is tested late by
/// default, octagons begin sooner: only their outline saves fragments.
constexpr GeometryCaps kDirect{false, 3.5, 6.5, 6.5}, kDirectLate{false, 3.5, 3.5, 6.5}, kV3dLate{false, 4.5, 5, 9.5},
    kStored{true, 9, 20, 20}, kStoredByArm{true, 9, 20, 20, 150'000'000}, kStoredLate{true, 9, 10, 20};

std::vector<CapabilitySet> makeSets() {
    constexpr auto kTiler = DeviceKind::tiler;
    const EncodedFormat kFloat = encodedFormats()[0], kHalf = encodedFormats()[1];
    PlanCaps mali = plan("mali", 32, true);
    mali.rasterOrder = RasterOrder::promised;
    mali.blendsByShader = true;
    mali.geometry = kStoredByArm;
    PlanCaps maliLate = mali;
    maliLate.name = "mali-late";
    maliLate.geometry = kDirect;
    PlanCaps maliOld = plan("mali-old", 16, false);
    maliOld.geometry = kStoredByArm;
    maliOld.blendsByShader = true;
    PlanCaps powerVr = plan("powervr", 16, false);
    powerVr.geometry = kStored;
    powerVr.blendsByShader = true;
    PlanCaps adreno = plan("adreno", 24, true);
    adreno.geometry = kDirect;
    PlanCaps noSubpass = plan("adreno-no-subpass", 16, true);
    noSubpass.geometry = kDirectLate;
    noSubpass.tileSubpasses = false;
    PlanCaps doubtful = plan("no-subpass", 16, false);
    doubtful.geometry = kStoredLate;
    doubtful.tileSubpasses = false;
    PlanCaps turnip = plan("turnip", 24, true);
    turnip.transient = false;
    turnip.geometry = kDirect;
    turnip.conservativeDepth = false;
    turnip.densityTexel = 32;
    PlanCaps v3dv = plan("v3dv", 16, false);
    v3dv.tileSubpasses = false;
    v3dv.geometry = kV3dLate;
    v3dv.transient = false;
    v3dv.conservativeDepth = false;
    PlanCaps panvk = v3dv;
    panvk.name = "panvk";
    panvk.storeAll = true;
    panvk.loadsUniforms = panvk.blendsByShader = true;
    panvk.geometry = kStoredLate;
    PlanCaps apple = plan("apple-moltenvk", 32, false);
    apple.tileSubpasses = false;
    PlanCaps desktop = plan("desktop", 16, false);
    desktop.transient = false;
    return {
        {{mali, kTiler, encodedInOrder()}, kMali},
        {{maliLate, kTiler, encodedInOrder()}, kMaliLate},
        {{maliOld, kTiler, kHalf}, kMaliOld},
        {{adreno, kTiler, kHalf}, kAdreno},
        {{noSubpass, kTiler, kHalf}, kAdrenoNoSubpass},
        {{powerVr, kTiler, kHalf}, kPowerVr},
        {{doubtful, kTiler, kHalf}, kNoSubpass},
        {{turnip, kTiler, kFloat}, kTurnip},
        {{v3dv, kTiler, kHalf}, kV3dv},
        {{panvk, kTiler, kHalf}, kPanvk},
        {{apple, DeviceKind::layered, kFloat}, kApple},
        {{desktop, DeviceKind::immediate, kFloat}, kDesktop},
    };
}

}  // namespace

std::span<const CapabilitySet> capabilitySets() {
    static const std::vector<CapabilitySet> sets = makeSets();
    return sets;
}

const CapabilitySet& capabilitySet(std::string_view name) {
    std::string names;
    for (const CapabilitySet& set : capabilitySets()) {
        if (set.plan.name == name) return set;
        names += (names.empty() ? "" : ", ") + set.plan.name;
    }
    throw Error("unknown capability set", std::string(name), "known are " + names);
}

}  // namespace nacre::graph
