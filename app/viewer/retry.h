#pragma once

#include <algorithm>
#include <limits>

namespace nacre::app {

/// Delays retries: longer after each consecutive failure.
class Retry {
public:
    static constexpr double kFirstSeconds = 0.5, kLastSeconds = 8;

    bool due(double now) const { return now >= at_; }
    double at() const { return at_; }
    void failed(double now) {
        at_ = now + wait_;
        wait_ = std::min(2 * wait_, kLastSeconds);
    }
    void succeeded() { *this = {}; }

private:
    double at_ = -std::numeric_limits<double>::infinity(), wait_ = kFirstSeconds;
};

}  // namespace nacre::app
