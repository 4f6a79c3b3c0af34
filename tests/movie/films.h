#pragma once
// Films as other programs see them.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/run_program.h"

namespace nacre::app {

using test::nacreIn;
using test::Outcome;
using test::readContents;
using test::TemporaryFolder;

constexpr std::size_t kFrameBytes = 3 * 64 * 48;
inline const std::string kSmall = " --size 64x48 --occlusion 8 --cache off ";

inline std::string captureOutput(const std::string& command) {
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
    pclose(pipe);
    return text;
}

/// Pixels of all frames, three bytes each.
inline std::string readFrames(const std::string& path) {
    return captureOutput("ffmpeg -v error -nostdin -i '" + path +
                         "' -fps_mode passthrough -f rawvideo -pix_fmt rgb24 - 2>&1");
}

inline std::string probed(const std::string& path, const std::string& entries) {
    return captureOutput("ffprobe -v error -count_frames -show_entries stream=" + entries +
                         " -of default=noprint_wrappers=1 '" + path + "' 2>&1");
}

inline int largestDifference(const std::string& a, const std::string& b) {
    int largest = a.size() == b.size() ? 0 : 256;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i])));
    return largest;
}

}  // namespace nacre::app
