#pragma once
// SIGINT, SIGTERM and SIGHUP as a wish to stop: work that is worth keeping comes to an end of its own.

namespace nacre::app {

/// As long as it is there, the first of these signals is noted; a second one does what it did before. One at a time.
class StopRequest {
public:
    StopRequest();
    ~StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;

    bool asked() const;
    /// Back to what the signals did before: from now on nothing looks whether asked().
    void leave();
};

}  // namespace nacre::app
