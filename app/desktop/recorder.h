#pragma once
// Records movies of the window's contents by running `nacre movie` as a separate process: the same code and files,
// while the window stays responsive.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/panel/panel_input.h"
#include "app/picture/saved_view.h"

namespace nacre::app {

/// Arguments for `nacre movie`. @param view, keys  files of saved views; options set what these leave open
/// @param shown  contents of the window
std::vector<std::string> movieArguments(const RecordingWish& wish, const PictureDescription& shown,
                                        const std::string& view, const std::vector<std::string>& keys);

class Recorder {
public:
    /// @param wake     called on another thread when state() changes
    /// @param program  nacre; empty: this one
    /// @param patience  seconds that a stopped recording may take to finish its file
    explicit Recorder(std::function<void()> wake, std::string program = {}, double patience = 10)
        : wake_(std::move(wake)), program_(std::move(program)), patience_(patience) {}
    /// finish()
    ~Recorder();
    Recorder(const Recorder&) = delete;

    /// Starts, unless a recording is running. @param fixed  options of the device and the like @throws Error
    void start(const RecordingWish& wish, PictureDescription shown, std::vector<PictureDescription> keys,
               const std::vector<std::string>& fixed);
    /// Ends the movie after the current frame, and keeps all frames so far.
    void stop();
    /// Stops recording, and waits until its file is finished; kills a program that takes longer than `patience`.
    void finish();
    RecordingState state() const;

private:
    void follow(int reports, int complaints);

    std::function<void()> wake_;
    std::string program_;
    double patience_;
    std::string folder_;  // of the views
    int child_ = -1;
    mutable std::mutex mutex_;
    std::condition_variable ended_;
    RecordingState state_;
    std::thread thread_;
};

}  // namespace nacre::app
