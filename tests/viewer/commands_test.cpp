#include "app/viewer/commands.h"

#include <gtest/gtest.h>

#include "app/viewer/presets.h"

namespace nacre::app {
namespace {

TEST(Presets, EveryOneIsWhatASavedViewHolds) {
    for (const Preset& preset : presets()) {
        PictureDescription view;
        applyPreset(preset, view);
        EXPECT_EQ(parseSavedView(savedViewJson(view), preset.name).look, view.look) << preset.name;
    }
}

TEST(Commands, EveryCommandHasAKeyOfItsOwn) {
    for (const Binding& b : keyBindings()) {
        EXPECT_EQ(findCommand(b.key), b.command) << b.keys;
        EXPECT_NE(std::string(b.what), "");
    }
    for (int c = 0; c <= static_cast<int>(ViewerCommand::quit); ++c) {
        bool bound = false;
        for (const Binding& b : keyBindings()) bound = bound || b.command == static_cast<ViewerCommand>(c);
        EXPECT_TRUE(bound) << c;
    }
    EXPECT_EQ(findCommand({U'?', {true, false}}), ViewerCommand::help);  // wherever the layout has it
    EXPECT_EQ(findCommand({U'y', {}}), std::nullopt);
}

}  // namespace
}  // namespace nacre::app
