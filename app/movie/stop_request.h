#pragma once
// Turns SIGINT, SIGTERM and SIGHUP into a request to stop, so that finished work can be kept.

namespace nacre::app {

/// While it exists, the first of these signals is recorded; a second one has its usual effect. One instance at a time.
class StopRequest {
public:
    StopRequest();
    ~StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;

    bool asked() const;
    /// Restores the previous handling of signals: asked() is no longer checked.
    void leave();
};

}  // namespace nacre::app
