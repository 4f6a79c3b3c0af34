// A device that is lost under the window: the viewer takes another, and the window shows the same picture.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/desktop/x_session.h"

namespace nacre::test {
namespace {

class Environment {
public:
    explicit Environment(const std::string& fault) {
        setenv("VK_ADD_LAYER_PATH", NACRE_FAULT_LAYER_FOLDER, 1);
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_NACRE_faults", 1);
        setenv("NACRE_FAULT", fault.c_str(), 1);
    }
    ~Environment() {
        for (const char* name : {"VK_ADD_LAYER_PATH", "VK_INSTANCE_LAYERS", "NACRE_FAULT"}) unsetenv(name);
    }
};

WindowPicture shown(const std::string& fault, std::string& errors) {
    const Environment environment(fault);
    XSession session("sample:glucose --size 300x300 --occlusion 16");
    session.type("m");       // the panel away
    session.type("Escape");  // and the message
    session.sleep(0.5);
    session.settle();
    WindowPicture picture = session.picture();
    EXPECT_EQ(session.quit(), 0);
    errors = session.errors();
    return picture;
}

TEST(LostDevice, OrWindowIsReplacedAndTheWindowShowsTheSame) {
    std::string errors;
    const WindowPicture expected = shown("watch", errors);
    EXPECT_EQ(errors, "");
    EXPECT_GT(std::count_if(expected.rgb.begin(), expected.rgb.end(), [](std::uint8_t c) { return c < 250; }), 5000);
    // First the window, of which no word is lost, then the device.
    EXPECT_TRUE(shown("vkAcquireNextImageKHR:3:SURFACE_LOST_KHR;vkQueueSubmit:9:DEVICE_LOST", errors) == expected);
    EXPECT_TRUE(errors.starts_with("nacre: warning: the device was lost: ")) << errors;
    EXPECT_NE(errors.find("; last submitted: ["), std::string::npos) << errors;
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

}  // namespace
}  // namespace nacre::test
