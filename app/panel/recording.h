#pragma once
// Movies of the window's contents: requests of the panel to its shell, and progress.

#include <cstdint>
#include <string>

#include "engine/results.h"

namespace nacre::app {

struct RecordingWish {
    enum class Motion { spin, rock, models, views };
    Motion motion = Motion::spin;
    double seconds = 6, framesPerSecond = 30;
    PixelSize size;
    bool loop = false;  ///< for keyframes: the last leads back to the first
    bool transparent = false;
    std::string path;
};

struct RecordingState {
    bool running = false, stopping = false;
    double share = 0;                     ///< of the frames, 0..1
    std::uint64_t frame = 0, frames = 0;  ///< finished, and total; 0: not known yet
    double left = -1;                     ///< remaining seconds, estimated; negative: not known
    std::string path;
    std::string message;  ///< result of the last recording
    bool failed = false;
};

}  // namespace nacre::app
