#pragma once
// What ends a program from outside: Ctrl C in its terminal, a log-out, a terminal that closes.

#include <thread>

namespace nacre::app {

/// While it lives the first SIGINT, SIGTERM or SIGHUP is told and not obeyed, so that a window can keep its state and
/// go; another one ends the program at once. One of them at a time.
class EndSignals {
public:
    /// @param wake  called by a thread of its own when one has come
    explicit EndSignals(void (*wake)());
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;

    /// Its number; 0: none has come.
    static int came();

private:
    std::thread thread_;
};

}  // namespace nacre::app
