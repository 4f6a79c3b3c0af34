// Captures of `nacre render`, opened and replayed by RenderDoc's own Python module.

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "app/files/capture_file.h"
#include "tests/capture/inspect.h"
#include "tests/support/run_program.h"

namespace nacre::test {
namespace {

using Names = std::vector<std::string>;

// 40 directions are three batches, since deep texels are looked for after the 32nd. A transparent background, so that
// the picture is the colour target's very bytes.
const std::string kPicture = "render sample:glucose -o a.png --size 96x80 --occlusion 40 --background transparent ";
const std::string kRender = kPicture + "--supersample 1 ";

std::vector<std::uint8_t> readPixels(const std::string& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open(path, &config);
    if (!in) throw std::runtime_error("no image " + path);
    std::vector<std::uint8_t> bytes(in->spec().image_pixels() * static_cast<std::size_t>(in->spec().nchannels));
    in->read_image(0, 0, 0, in->spec().nchannels, OIIO::TypeDesc::UINT8, bytes.data());
    return bytes;
}

/// The bake's submissions, then the screen's.
void expectBakeAndScreen(const nlohmann::json& submissions, const Names& screen) {
    EXPECT_EQ(listNames(submissions), (Names{"occlusion", "occlusion", "occlusion", "occlusion finish", "screen"}));
    for (const nlohmann::json& submission : submissions)
        if (submission["name"] == "occlusion") {
            EXPECT_EQ(listNames(submission["steps"]), (Names{"depth maps by tiles", "occlusion accumulation"}));
        }
    EXPECT_EQ(listNames(submissions.back()["steps"]), screen);
}

/// The paper's frame: one render pass, of which only colour reaches memory.
void expectOneRenderPass(const nlohmann::json& pass) {
    EXPECT_EQ(pass["size"], (nlohmann::json{96, 80}));
    Names passes;
    for (const nlohmann::json& subpass : pass["subpasses"]) {
        ASSERT_EQ(subpass["passes"].size(), 1u) << subpass;
        passes.push_back(subpass["passes"][0]["name"]);
        EXPECT_GT(subpass["passes"][0]["draws"], 0);
    }
    EXPECT_EQ(passes, (Names{"opaque prepass", "depth encoding", "impostor colour"}));
    EXPECT_EQ(pass["subpasses"][0]["uses"], (nlohmann::json{"writes screen: depth"}));
    EXPECT_EQ(pass["subpasses"][2]["uses"],
              (nlohmann::json{"reads screen: encoded depth as input", "tests screen: depth", "writes screen: colour"}));
    ASSERT_EQ(listNames(pass["attachments"]), (Names{"screen: depth", "screen: encoded depth", "screen: colour"}));
    for (const nlohmann::json& attachment : pass["attachments"]) {
        EXPECT_EQ(attachment["load"], "clear") << attachment;
        EXPECT_EQ(attachment["store"], attachment["name"] == "screen: colour" ? "store" : "don't care") << attachment;
    }
}

TEST(RenderCapture, ShowsTheBakeAndOneRenderPassAndReplaysToThePicture) {
    const TemporaryFolder folder;
    nacreDone(folder, kRender + "--visibility encoded --capture a.rdc --validate");
    EXPECT_EQ(folder.count(), 2u) << "something was left behind";
    const nlohmann::json listing =
        inspect(folder / "a.rdc", "--save 'screen: colour' '" + (folder / "replayed.png") + "'");
    EXPECT_EQ(listing["unnamed"], nlohmann::json::array());
    EXPECT_GT(listing["resources"], 50);
    expectBakeAndScreen(listing["submissions"], {"render pass", "read back"});
    expectOneRenderPass(listing["submissions"].back()["steps"][0]);

    const std::vector<std::uint8_t> drawn = readPixels(folder / "a.png");
    ASSERT_EQ(drawn.size(), 96u * 80 * 4);
    EXPECT_GT(std::count_if(drawn.begin(), drawn.end(), [](std::uint8_t b) { return b > 0; }), 1000);
    EXPECT_EQ(readPixels(folder / "replayed.png"), drawn);

    // Capturing changes no pixel.
    nacreDone(folder, kRender);
    EXPECT_EQ(readPixels(folder / "a.png"), drawn);
}

TEST(RenderCapture, EveryResourceOfEveryPathHasAName) {
    const TemporaryFolder folder;
    for (const char* path :
         {"fragdepth --merge off --supersample 1", "tiles", "deferred --supersample 2 --layers l.exr"}) {
        nacreDone(folder, kPicture + "--capture a.rdc --visibility " + path);
        EXPECT_EQ(inspect(folder / "a.rdc")["unnamed"], nlohmann::json::array()) << path;
    }
}

TEST(RenderCapture, TheFrameIsRenderDocsWhereItStartedTheProgram) {
    const TemporaryFolder folder;
    const std::string command = "renderdoccmd capture --wait-for-exit -d '" + folder.path() + "' -c '" +
                                (folder / "started") + "' '" NACRE_PROGRAM "' " + kRender + " >'" + (folder / "log") +
                                "' 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << readContents(folder / "log");
    // By the path that software devices take.
    expectBakeAndScreen(inspect(folder / "started_capture.rdc")["submissions"], {"nearest primitive, shaded"});
    EXPECT_NE(readContents(folder / "log").find("captured to " + (folder / "started_capture.rdc")), std::string::npos);
}

TEST(RenderCapture, RenderDocListensOnThisMachineAlone) {
    const TemporaryFolder folder;
    // While the program runs: the sockets that it holds, and all that listen.
    const std::string command = "cd '" + folder.path() + "' && ('" NACRE_PROGRAM "' " + kRender +
                                "--capture a.rdc & pid=$!; while kill -0 $pid 2>/dev/null; do "
                                "ls -l /proc/$pid/fd 2>/dev/null | grep -o 'socket:.[0-9]*'; cat /proc/net/tcp; "
                                "sleep 0.02; done) >log 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::set<std::string> held, listening;  // inodes; addresses
    std::istringstream log(readContents(folder / "log"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(log, line);) {
        if (line.starts_with("socket:[")) held.insert(line.substr(8));
        std::istringstream words(line);
        rows.emplace_back(std::istream_iterator<std::string>(words), std::istream_iterator<std::string>());
    }
    for (const std::vector<std::string>& row : rows)
        if (row.size() > 9 && row[3] == "0A" && held.contains(row[9])) listening.insert(row[1].substr(0, 8));
    EXPECT_EQ(listening, std::set<std::string>{"0100007F"});  // 127.0.0.1
}

TEST(RenderCapture, SaysWhyItCannot) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "empty");
    std::ofstream(folder / "empty/librenderdoc.so") << "no library";
    const auto expectError = [&](const std::string& environment, const std::string& more, const std::string& why) {
        const std::string command = "cd '" + folder.path() + "' && " + environment + " '" NACRE_PROGRAM "' " + kRender +
                                    "--capture a.rdc " + more + " >/dev/null 2>log";
        EXPECT_NE(std::system(command.c_str()), 0);
        const std::string said = readContents(folder / "log");
        EXPECT_TRUE(said.starts_with("nacre: error: ")) << said;
        EXPECT_NE(said.find(why), std::string::npos) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
        EXPECT_EQ(folder.count(), 2u) << "something was left behind";  // the log, and what is no library
    };
    expectError("", "--visibility raster-order", "RenderDoc hides VK_EXT_rasterization_order_attachment_access");
    expectError("LD_LIBRARY_PATH=empty", "", "cannot capture: RenderDoc");
    expectError("HOME=/none XDG_DATA_DIRS=/none", "", "Vulkan does not know RenderDoc's layer");
    expectError("ulimit -f 100;", "", "cannot write file: a.rdc");
}

TEST(RenderCapture, ACutFileIsTold) {
    const TemporaryFolder folder;
    nacreDone(folder, kRender + "--capture a.rdc");
    const std::string whole = readContents(folder / "a.rdc");
    EXPECT_TRUE(app::isWholeCapture(folder / "a.rdc"));
    for (std::size_t n = 0; n < whole.size(); n += n < 200 ? 1 : 9973) {
        std::ofstream(folder / "cut.rdc", std::ios::binary).write(whole.data(), static_cast<std::streamsize>(n));
        // With its first header alone it is a capture of no sections.
        EXPECT_EQ(app::isWholeCapture(folder / "cut.rdc"), n == static_cast<std::uint8_t>(whole[12])) << n;
    }
    EXPECT_FALSE(app::isWholeCapture(folder / "none.rdc"));
}

}  // namespace
}  // namespace nacre::test
