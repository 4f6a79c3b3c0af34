#pragma once
// Films of what the window shows, made by `nacre movie` as a program of its own beside the window: the same code, the
// same files, and a window that goes on meanwhile.

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/panel/recording.h"
#include "app/picture/saved_view.h"

namespace nacre::app {

/// What `nacre movie` is called with. @param view, keys  files of saved views, of which the options name what else they
/// leave open  @param shown  what the window shows
std::vector<std::string> movieArguments(const RecordingWish& wish, const PictureDescription& shown,
                                        const std::string& view, const std::vector<std::string>& keys);

class Recorder {
public:
    /// @param wake     called on a thread of its own when state() is another
    /// @param program  nacre; empty: this one
    explicit Recorder(std::function<void()> wake, std::string program = {})
        : wake_(std::move(wake)), program_(std::move(program)) {}
    /// Stops what is recorded, and waits for that.
    ~Recorder();
    Recorder(const Recorder&) = delete;

    /// Begins, unless one is being recorded. @param fixed  options of the device and the like @throws Error
    void start(const RecordingWish& wish, PictureDescription shown, std::vector<PictureDescription> keys,
               const std::vector<std::string>& fixed);
    /// The film ends with the frame that is being drawn, and keeps those before.
    void stop();
    RecordingState state() const;

private:
    void follow(int reports, int complaints);

    std::function<void()> wake_;
    std::string program_;
    std::string folder_;  // of the views
    int child_ = -1;
    mutable std::mutex mutex_;
    RecordingState state_;
    std::thread thread_;
};

}  // namespace nacre::app
