#pragma once
// Signals that end a program: Ctrl C in its terminal, a log-out, a closed terminal.

#include <thread>

namespace nacre::app {

/// While it exists, the first SIGINT, SIGTERM or SIGHUP is reported instead of obeyed, so that a window can save its
/// state; a second one ends the program at once. One instance at a time.
class EndSignals {
public:
    /// @param wake  called on a separate thread when a signal arrived
    explicit EndSignals(void (*wake)());
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;

    /// The signal's number; 0: none arrived.
    static int came();

private:
    std::thread thread_;
};

}  // namespace nacre::app
