// The program on a device that fails: one line, exit code 1, no file; under the validation layer, with nothing left.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/measured_run.h"
#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

class ProgramFaults : public testing::Test {
protected:
    MeasuredRun render(const std::string& fault, bool faultData = false) {
        RunOptions options;
        options.environment = {{"VK_ADD_LAYER_PATH", NACRE_FAULT_LAYER_FOLDER},
                               {"VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_faults"},
                               {"NACRE_FAULT", fault},
                               {"NACRE_FAULT_DATA", faultData ? "1" : "0"}};
        return runMeasured(
            {"render", "sample:glucose", "-o", folder_ / "out.png", "--layers", folder_ / "out.exr", "--stats",
             folder_ / "out.json", "--size", "64x64", "--occlusion", "2", "--visibility", "encoded", "--validate"},
            options);
    }
    /// @returns the line
    std::string expectOneLine(const MeasuredRun& run) {
        EXPECT_EQ(run.code, 1) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_TRUE(run.err.starts_with("nacre: error: ")) << run.err;
        EXPECT_EQ(folder_.count(), 0u);
        return run.err;
    }

    TemporaryFolder folder_;
};

TEST_F(ProgramFaults, WithoutAFaultItLeavesNothingBehind) {
    const MeasuredRun run = render("watch");
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(folder_.count(), 3u);
}

TEST_F(ProgramFaults, EveryKindOfFailureIsOneLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"vkCreateInstance:1:OUT_OF_HOST_MEMORY", "cannot start Vulkan"},
        {"vkEnumeratePhysicalDevices:1:INITIALIZATION_FAILED", "cannot start Vulkan"},
        {"vkCreateDevice:1:OUT_OF_DEVICE_MEMORY", "cannot start Vulkan"},
        {"vkCreateImage:2:OUT_OF_DEVICE_MEMORY", "out of device memory: "},
        {"vkCreateFramebuffer:1:OUT_OF_HOST_MEMORY", "out of memory: "},
        {"vkAllocateDescriptorSets:3:OUT_OF_DEVICE_MEMORY", "out of device memory: "},
        // One that a thread could not make ahead is tried once more where it is needed: the fault lasts.
        {"vkCreateGraphicsPipelines:1+:INITIALIZATION_FAILED", "cannot make pipeline: opaque prepass, spheres: "},
        {"vkCreateComputePipelines:1+:OUT_OF_HOST_MEMORY", "cannot make pipeline: "},
        {"vkEndCommandBuffer:4:OUT_OF_HOST_MEMORY", "out of memory: "},
        {"vkWaitForFences:3:DEVICE_LOST", "last submitted: [occlusion"}};
    for (const auto& [fault, words] : cases) {
        SCOPED_TRACE(fault);
        const std::string line = expectOneLine(render(fault));
        EXPECT_NE(line.find(words), std::string::npos) << line;
    }
}

TEST_F(ProgramFaults, AFullDiskLeavesNoPicture) {
    for (const char* name : {"out.png", "out.jpg", "out.tif", "out.exr"}) {
        SCOPED_TRACE(name);
        const Outcome outcome =
            nacreIn(folder_, std::string("render sample:glucose -o ") + name + " --size 200x200 --occlusion off", "",
                    "ulimit -f 2");
        EXPECT_EQ(outcome.code, 1);
        EXPECT_TRUE(outcome.err.starts_with(std::string("nacre: error: cannot write file: ") + name)) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(folder_.count(), 0u);
    }
}

TEST_F(ProgramFaults, ALossTellsWhatTheDriverTells) {
    const std::string line = expectOneLine(render("vkQueueSubmit:4:DEVICE_LOST", true));
    EXPECT_NE(line.find("; the driver tells: page fault of the fault layer, WriteInvalid at 0xdead0000"),
              std::string::npos)
        << line;
}

}  // namespace
}  // namespace nacre::test
