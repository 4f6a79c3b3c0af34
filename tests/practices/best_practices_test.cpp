// The validation layer's best practices with the checks of all four vendors, on lavapipe in the guise of a phone
// (tests/phone_layer): no message but those that are allowed here, each for a reason. An allowance that nothing uses
// any longer fails as well.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <span>
#include <sstream>

#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

struct Allowed {
    const char* id;  ///< what follows "BestPractices-" in a message
    const char* reason;
    const char* link;    ///< what the vendor or Khronos says of it
    bool timed = false;  ///< depends on when things happen: need not be said
};

constexpr const char* kArm = "https://developer.arm.com/documentation/101897/latest/";
constexpr const char* kAmd = "https://gpuopen.com/learn/rdna-performance-guide/";
constexpr const char* kNvidia = "https://developer.nvidia.com/blog/vulkan-dos-donts/";
constexpr const char* kLayer =
    "https://github.com/KhronosGroup/Vulkan-ValidationLayers/blob/main/docs/best_practices.md";

constexpr Allowed kAlways[] = {
    {"vkCreateInstance-specialuse-extension-debugging",
     "VK_EXT_debug_utils names passes and resources for capture tools, which attach to release builds; without a tool "
     "the calls end in the loader",
     kLayer},
    {"CreateImage-Depth32Format",
     "NVIDIA: depth is 32 bits since what encoded depth stores must be what the depth buffer holds, bit for bit; it "
     "never leaves a tile",
     kNvidia},
    {"CreatePipelinesLayout-KeepLayoutSmall",
     "AMD: 128 bytes of push constants are one view; a uniform buffer would be one more thing to fetch on tilers",
     kAmd},
    {"vkCreateGraphicsPipelines-too-many-instanced-vertex-buffers",
     "positions stand apart from looks, so that binning reads 16 bytes a sphere; Arm asks for that split elsewhere",
     kArm},
    {"AllocateMemory-SetPriority", "NVIDIA: VK_EXT_memory_priority is no part of what phones have", kNvidia},
    {"vkAllocateMemory-small-allocation",
     "a scene is a dozen allocations in all, of 4,096 that every device allows, and the next scene takes them over; "
     "blocks for several resources would be more code than they save",
     kLayer},
    {"vkBindMemory-small-dedicated-allocation", "as above", kLayer},
};

constexpr Allowed kOfBakes[] = {
    {"Pipeline-SortAndBind",
     "AMD, NVIDIA: the depth maps of a batch alternate between plates and impostors, since each map's plates must be "
     "there before its impostors; the alternative is two render passes and the depth buffer through memory",
     kAmd},
    {"vkCreateComputePipelines-compute-spatial-locality",
     "Arm: texels are a list, patch by patch, not an image; neighbours in it are neighbours on an atom", kArm},
    // Where pipelines take long, as without anything compiled, a bake goes on in further submissions.
    {"ImageBarrierAccessLayout", "maps' depth was written and then tested only, and ends in the read-only layout",
     kLayer, true},
    {"RenderPass-redundant-store", "Arm, IMG: maps that no texel asks any longer are cleared for the next directions",
     kArm, true},
    {"AllocateMemory-ReuseAllocations", "NVIDIA: what a bake needed is given back once, when it is done", kNvidia,
     true},
};

constexpr Allowed kOfLayers[] = {
    {"vkCmdBeginRenderPass-attachment-needs-readback",
     "Arm, IMG: three layers of 16 bytes a pixel do not fit one tile; they are files, not frames", kArm},
    {"ImageBarrierAccessLayout",
     "depth that was written and then tested only ends in the read-only layout: its last write is what a barrier from "
     "there names",
     kLayer},
    {"PipelineBarrier-readToReadBarrier", "AMD, NVIDIA: depth between the render passes of the layers", kAmd},
    {"AllocateMemory-ReuseAllocations", "NVIDIA: buffers that layers are read from go with them", kNvidia, true},
};

constexpr Allowed kOfSamples[] = {
    {"vkCmdBeginRenderPass-attachment-needs-readback",
     "Arm, IMG: samples are added to a picture of which an earlier frame drew the rest; windows do not do it", kArm},
    {"Pipeline-SortAndBind", "AMD, NVIDIA: frames of a picture and of its samples have the same pipelines", kAmd},
    {"PipelineBarrier-readToReadBarrier",
     "AMD, NVIDIA: what a lens or another frame may read ends as a texture, and is then read back", kAmd},
    {"AllocateMemory-ReuseAllocations", "NVIDIA: what the samples are added up in goes with the picture", kNvidia,
     true},
};

using Said = std::map<std::string, std::string>;  // ids, and the first message of each

constexpr const char* kPractices =
    "VK_VALIDATION_FEATURE_ENABLE_BEST_PRACTICES_EXT,VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT,"
    "VALIDATION_CHECK_ENABLE_VENDOR_SPECIFIC_ARM,VALIDATION_CHECK_ENABLE_VENDOR_SPECIFIC_AMD,"
    "VALIDATION_CHECK_ENABLE_VENDOR_SPECIFIC_IMG,VALIDATION_CHECK_ENABLE_VENDOR_SPECIFIC_NVIDIA";

/// Draws, and adds what the layer says. @param arguments  how many samples, then options
void draw(const std::string& arguments, Said& said, const std::string& enables = kPractices) {
    const TemporaryFolder folder, settings;
    std::ofstream(settings / "vk_layer_settings.txt")
        << "khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG\n"
           "khronos_validation.report_flags = error,warn,perf,info\n"
           "khronos_validation.duplicate_message_limit = 100000\n"
           "khronos_validation.log_filename = "
        << (settings / "log") << "\nkhronos_validation.enables = " << enables << "\n";
    setenv("VK_LAYER_SETTINGS_PATH", settings.path().c_str(), 1);
    const Outcome outcome =
        nacreIn(folder, "render sample:glucose -o a.png --size 128x128 --cache off --supersample " + arguments);
    unsetenv("VK_LAYER_SETTINGS_PATH");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string text = readContents(settings / "log");
    ASSERT_NE(text.find("Current Enables: " + enables.substr(0, enables.find(','))), std::string::npos) << text;
    std::istringstream log(text);
    const std::regex identifier(R"(\[ (\S+) \])");
    for (std::string line; std::getline(log, line);) {
        std::smatch match;
        if (std::regex_search(line, match, identifier)) said.emplace(match[1], line);
    }
    said.erase("UNASSIGNED-khronos-validation-createinstance-status-message");  // what is enabled
    said.erase("UNASSIGNED-CoreValidation-Shader-OutputNotConsumed");           // see engine/gpu/instance.cpp
}

void expectAllowed(Said said, const std::vector<std::span<const Allowed>>& lists) {
    for (const auto& list : lists)
        for (const Allowed& allowed : list) {
            const std::size_t found = said.erase(std::string("UNASSIGNED-BestPractices-") + allowed.id);
            EXPECT_TRUE(found || allowed.timed) << "nothing says " << allowed.id << " any longer";
        }
    for (const auto& [id, message] : said) ADD_FAILURE() << message;
}

TEST(BestPractices, OfTheFrameByEveryPath) {
    Said said;
    for (const char* path : {"encoded", "fragdepth", "deferred"})
        draw(std::string("1 --occlusion off --visibility ") + path, said);
    expectAllowed(said, {kAlways});
}

TEST(BestPractices, OfAnAntialiasedPicture) {
    Said said;
    draw("auto --occlusion off --visibility encoded", said);
    expectAllowed(said, {kAlways, kOfSamples});
}

TEST(BestPractices, OfTheBake) {
    // The driver keeps what it compiles. Where pipelines take long, a bake is spread over more submissions.
    Said compiled, said;
    draw("1 --occlusion 40", compiled);
    draw("1 --occlusion 40", said);
    expectAllowed(said, {kAlways, kOfBakes});
}

TEST(BestPractices, OfTheLayers) {
    Said said;
    draw("1 --occlusion off --layers l.exr", said);
    expectAllowed(said, {kAlways, kOfLayers});
}

// Shaders instrumented by the layer: every index that they use is inside its buffer.
TEST(BestPractices, GpuAssistedValidationFindsNothing) {
    // On lavapipe as it is: phones lack what the instrumented shaders use.
    const std::string layers = std::getenv("VK_INSTANCE_LAYERS");
    setenv("VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation", 1);
    for (const char* path : {"encoded", "deferred"}) {
        Said said;
        draw(std::string("auto --occlusion 20 --layers l.exr --stats s.json --visibility ") + path, said,
             "VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT");
        expectAllowed(said, {});
    }
    setenv("VK_INSTANCE_LAYERS", layers.c_str(), 1);
}

}  // namespace
}  // namespace nacre::test
