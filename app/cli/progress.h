#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/picture/description.h"
#include "engine/molecule/molecule.h"

namespace nacre::app {

/// One line for a terminal, at most 60 columns: "nacre: ambient occlusion [######        ]  43 %", or without a bar if
/// the finished share (0..1) is unknown.
/// @param left  estimate of the remaining time, after a shorter bar
std::string progressText(const std::string& work, std::optional<double> share, std::chrono::seconds elapsed,
                         std::optional<std::chrono::seconds> left = {});

/// Shows a command's current work on a terminal once it has taken over a second; clears the line at the end.
class Progress {
public:
    /// Standard error, if it is a terminal; otherwise shows nothing. @param shown  false: show nothing
    explicit Progress(bool shown = true);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin(const std::string& work);
    /// Sets the finished share of the current work, 0..1.
    void advance(double share);
    /// As above for work at a steady rate, whose end can be estimated.
    void advanceTo(std::uint64_t done, std::uint64_t all);

private:
    void show();

    // A separate thread writes: most work (reading, uploading) has no place to call from.
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ending_ = false;
    std::string work_;
    std::optional<double> share_;
    bool steady_ = false;  // the share grows steadily
    std::chrono::steady_clock::time_point began_;
    std::thread thread_;
};

/// Callback of a download as bytes arrive.
std::function<void(double)> downloadProgress(Progress& progress);

class OpenScene;

/// Reads the molecule and the maps of a picture. @param scene  its INPUT, if that is open @throws Error
Molecule readMoleculeAndMaps(const PictureDescription& picture, Progress& progress, OpenScene* scene = nullptr);

/// Reports a movie's progress to a waiting program, as lines of JSON.
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
