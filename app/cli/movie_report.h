#pragma once
// A movie's progress for a waiting program: lines of JSON.

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

namespace nacre::app {

class MovieReport {
public:
    /// @param path  "-": standard output; empty: no report. @throws Error
    explicit MovieReport(const std::string& path);
    ~MovieReport();
    MovieReport(const MovieReport&) = delete;
    MovieReport& operator=(const MovieReport&) = delete;

    /// {"baked": 0.43} while the first frame's occlusion is baked.
    void baked(double share);
    /// {"frame": 12, "frames": 180} after each frame. @param model  shown, if there are several: "model": 4
    void drawn(std::uint64_t frame, std::uint64_t frames, std::optional<int> model);

private:
    std::FILE* file_ = nullptr;
};

}  // namespace nacre::app
