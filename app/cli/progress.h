#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace nacre::app {

/// One line for a terminal, at most 60 columns: "nacre: ambient occlusion [######        ]  43 %", or without a bar if
/// the finished share (0..1) is unknown.
/// @param left  estimate of the remaining time, shown beside a shorter bar
std::string progressText(const std::string& work, std::optional<double> share, std::chrono::seconds elapsed,
                         std::optional<std::chrono::seconds> left = {});

/// Shows on a terminal what a command is doing once that has taken over a second; clears the line at the end.
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
    /// As above for steady work, whose end can be estimated.
    void advanceTo(std::uint64_t done, std::uint64_t all);

private:
    void show();

    // A thread of its own writes: most work (reading, uploading) has no place to call from.
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

}  // namespace nacre::app
