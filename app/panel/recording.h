#pragma once
// Films of what the window shows: what the panel asks of its shell, and what it is told.

#include <cstdint>
#include <string>

#include "engine/results.h"

namespace nacre::app {

struct RecordingWish {
    enum class Motion { spin, rock, models, views };
    Motion motion = Motion::spin;
    double seconds = 6, framesPerSecond = 30;
    PixelSize size;
    bool loop = false;  ///< of views: the last leads on to the first
    bool transparent = false;
    std::string path;
};

struct RecordingState {
    bool running = false, stopping = false;
    double share = 0;                     ///< of the frames, 0..1
    std::uint64_t frame = 0, frames = 0;  ///< done, and in all; 0: not known yet
    double left = -1;                     ///< seconds, probably; below 0: not known
    std::string path;
    std::string message;  ///< how the last one ended
    bool failed = false;
};

}  // namespace nacre::app
