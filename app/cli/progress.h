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

/// One line for a terminal, at most 60 columns: "nacre: ambient occlusion [######        ]  43 %", or without a bar
/// where the share done (0..1) is not known.
/// @param left  what is probably left, shown beside a shorter bar
std::string progressText(const std::string& work, std::optional<double> share, std::chrono::seconds elapsed,
                         std::optional<std::chrono::seconds> left = {});

/// Says on a terminal what a command is doing once that has taken over a second; leaves an empty line behind.
class Progress {
public:
    /// Standard error, if it is a terminal; otherwise nothing is ever shown. @param shown  false: nor there
    explicit Progress(bool shown = true);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin(const std::string& work);
    /// The share of the current work that is done, 0..1.
    void advance(double share);
    /// The same of work that takes one like the other, whose end can be told from what is done.
    void advanceTo(std::uint64_t done, std::uint64_t all);

private:
    void show();

    // Written to from a thread of its own: most of the work (reading, uploading) has no place to call from.
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ending_ = false;
    std::string work_;
    std::optional<double> share_;
    bool steady_ = false;  // time goes with the share
    std::chrono::steady_clock::time_point began_;
    std::thread thread_;
};

/// What a download calls as bytes arrive.
std::function<void(double)> downloadProgress(Progress& progress);

}  // namespace nacre::app
