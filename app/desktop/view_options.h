#pragma once
// What a window is asked for, as plain data.

#include <cstdint>
#include <string>

#include "app/picture/aim.h"
#include "app/picture/option_values.h"
#include "app/picture/saved_view.h"
#include "engine/settings.h"

namespace nacre::app {

struct ViewOptions {
    SavedView first;       ///< what it shows at first
    Aim aim;               ///< and from where
    bool restore = false;  ///< nothing is named: the start screen, which offers to go on where the last window was left
    InputOptions input;    ///< how molecules are had: cache, network, memory; what they are is `first`'s
    Size size{1280, 800};
    std::uint64_t occlusionBytes = RenderSettings{}.occlusion.bytes;
    DebugView debug = DebugView::none;
    FrameTuning tuning;
    DeviceOptions device;
    std::string stats;  ///< path; may be empty
};

}  // namespace nacre::app
