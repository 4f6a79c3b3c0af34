// A render that gfxreconstruct's layer records can be replayed, and its frames told apart.

#include <gtest/gtest.h>

#include <sstream>

#include "tests/capture/inspect.h"
#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

/// Runs a command of the shell in the folder. @returns its output; a failure fails the test
std::string captureOutput(const TemporaryFolder& folder, const std::string& command) {
    const TemporaryFolder logs;
    const int status =
        std::system(("cd '" + folder.path() + "' && " + command + " >'" + (logs / "out") + "' 2>&1").c_str());
    EXPECT_EQ(status, 0) << command << ": " << readContents(logs / "out");
    return readContents(logs / "out");
}

/// What each submission holds: the outermost label of its one command buffer.
std::vector<std::string> listSubmissions(const std::string& jsonLines) {
    std::vector<std::string> submissions;
    std::string label;
    int depth = 0;
    std::istringstream lines(jsonLines);
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json call = nlohmann::json::parse(line);
        if (!call.contains("vkFunc")) continue;
        const std::string name = call["vkFunc"]["name"];
        const nlohmann::json& arguments = call["vkFunc"]["args"];
        if (name == "vkCmdBeginDebugUtilsLabelEXT" && depth++ == 0) label = arguments["pLabelInfo"]["pLabelName"];
        if (name == "vkCmdEndDebugUtilsLabelEXT") --depth;
        if (name != "vkQueueSubmit") continue;
        EXPECT_EQ(depth, 0);
        EXPECT_EQ(arguments["submitCount"], 1);
        EXPECT_EQ(arguments["pSubmits"][0]["commandBufferCount"], 1);
        submissions.push_back(label);
        label.clear();
    }
    return submissions;
}

TEST(Gfxreconstruct, ARenderReplaysAndEachFrameIsOneSubmission) {
    const TemporaryFolder folder;
    captureOutput(folder,
                  "VK_INSTANCE_LAYERS=VK_LAYER_LUNARG_gfxreconstruct GFXRECON_CAPTURE_FILE=a.gfxr "
                  "GFXRECON_CAPTURE_FILE_TIMESTAMP=false '" NACRE_PROGRAM
                  "' render sample:glucose -o a.png --size 96x80 --occlusion 40 --layers l.exr");
    const std::string replay = captureOutput(folder, "gfxrecon-replay --validate a.gfxr");
    for (const char* word : {"ERROR", "WARNING", "FATAL", "Validation"})
        EXPECT_EQ(replay.find(word), std::string::npos) << replay;
    const auto submissions = listSubmissions(captureOutput(folder, "gfxrecon-convert --output stdout a.gfxr"));
    EXPECT_EQ(submissions, (std::vector<std::string>{"white", "occlusion", "occlusion", "occlusion", "occlusion finish",
                                                     "screen", "screen"}));
}

}  // namespace
}  // namespace nacre::test
