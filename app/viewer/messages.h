#pragma once
// Messages to the user: shown for a while; errors until they are dismissed.

#include <limits>
#include <string>

#include "app/viewer/frame_schedule.h"

namespace nacre::app {

class Messages {
public:
    static constexpr double kSeconds = 4;  ///< duration of a message

    /// @param errorsStay  errors stay until dismissed: the shell shows failure()
    Messages(FrameSchedule& schedule, bool errorsStay) : schedule_(schedule), errorsStay_(errorsStay) {}

    void say(const std::string& message, double now) {
        message_ = message;
        until_ = now + kSeconds;
        schedule_.overlayChanged();
    }
    /// Reports an error.
    void fail(const std::string& what, double now) {
        if (!errorsStay_) return say(what, now);
        failure_ = what;
        message_.clear();
        schedule_.overlayChanged();
    }
    void dismissFailure() {
        if (failure_.empty()) return;
        failure_.clear();
        schedule_.overlayChanged();
    }
    void clear() { message_.clear(); }
    /// @returns when something is due; infinity: never
    double advance(double now) {
        if (!message_.empty() && now >= until_) say("", now);
        return message_.empty() ? std::numeric_limits<double>::infinity() : until_;
    }

    const std::string& message() const { return message_; }
    const std::string& failure() const { return failure_; }

private:
    FrameSchedule& schedule_;
    bool errorsStay_;
    std::string message_, failure_;
    double until_ = 0;
};

}  // namespace nacre::app
