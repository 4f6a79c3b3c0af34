// How a frame is drawn is decided in one place: the files engine/frame/choose*. No other code compares paths, or asks
// whether a device is a software device.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace nacre::test {
namespace {

bool decides(const std::string& line) {
    static const std::regex kDecides(
        R"re([!=]=\s*(\w+::)?Visibility::\w|Visibility::\w+\s*[!=]=|case (\w+::)?Visibility::|)re"
        R"re(DeviceKind::software\s*[!=]=|[!=]=\s*(\w+::)?DeviceKind::software|caps\w*(\(\))?\.software)re");
    return std::regex_search(line, kDecides);
}

TEST(House, OnePlaceDecidesHowAFrameIsDrawn) {
    namespace fs = std::filesystem;
    const fs::path root = NACRE_SOURCE_DIR;
    std::size_t here = 0;
    for (const char* top : {"engine", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const std::string kind = entry.path().extension().string();
            if (kind != ".h" && kind != ".cpp" && kind != ".mm") continue;
            const std::string file = fs::relative(entry.path(), root).generic_string();
            std::ifstream stream(entry.path());
            for (std::string line; std::getline(stream, line);) {
                if (!decides(line)) continue;
                if (file.starts_with("engine/frame/choose"))
                    ++here;
                else
                    EXPECT_EQ(file, "engine/devices.h") << file << ": " << line;  // isAutomatic()
            }
        }
    EXPECT_GT(here, 10u);
}

}  // namespace
}  // namespace nacre::test
