#pragma once
// State shared by the viewer's parts: the wanted view with the interactive camera and its undo history (each user
// action is a step, a drag counts once), the document shown, notifications of changes to both, and messages to the
// user: shown for a while, errors until they are dismissed.

#include <limits>
#include <string>
#include <vector>

#include "app/picture/description.h"
#include "app/viewer/camera_motion.h"
#include "app/viewer/frame_schedule.h"
#include "app/viewer/loader.h"

namespace nacre::app {

/// Messages to the user.
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

/// Undo history of views.
class History {
public:
    static constexpr std::size_t kMost = 200;  ///< views

    /// Clears the history except for one view.
    void begin(const PictureDescription& view);
    /// Call before an action: the current view becomes a step, unless it is the last one; clears the redo steps.
    void remember(const PictureDescription& now);
    /// The current view may not be a step yet: it becomes one before the next undo.
    void acted() { acted_ = true; }
    bool empty() const { return views_.empty(); }
    // For the current view
    bool canUndo(const PictureDescription& now) const { return at_ > 0 || isAnother(now); }
    bool canRedo(const PictureDescription& now) const { return at_ + 1 < views_.size() && !isAnother(now); }
    /// The previous or next view; null: none. Valid until the next call.
    const PictureDescription* undo(const PictureDescription& now) { return go(now, -1); }
    const PictureDescription* redo(const PictureDescription& now) { return go(now, 1); }

private:
    bool isAnother(const PictureDescription& now) const;
    const PictureDescription* go(const PictureDescription& now, int step);
    std::vector<PictureDescription> views_;
    std::size_t at_ = 0;
    bool acted_ = false;
};

class Stage {
public:
    static constexpr double kHandSeconds = 0.1;  ///< a drag that rests this long counts as finished

    Stage(const PictureDescription& view, bool errorsStay) : messages(schedule, errorsStay), view_(view) {
        motion.set(view.camera);
    }
    Stage(const Stage&) = delete;

    FrameSchedule schedule;
    Messages messages;
    CameraMotion motion;
    History history;
    Document document;

    /// The wanted view, with the camera of `motion`.
    const PictureDescription& view() const {
        view_.camera = motion.camera();
        view_.aim.fits = false;  // the camera sets the scale
        return view_;
    }
    /// As above for changes; its camera is ignored.
    PictureDescription& wanted() { return view_; }
    /// The wanted view at the end of a flight.
    PictureDescription destination() const {
        PictureDescription view = view_;
        view.camera = motion.destination();
        view.aim.fits = false;
        return view;
    }
    /// Whether there is a document.
    bool shown() const { return document.molecule != nullptr; }
    /// Radius of the document, Å.
    double radius() const { return shown() ? document.radius : 1.0; }

    /// Call before every visible change: makes the previous state an undo step.
    void remember() {
        if (shown()) history.remember(destination());
    }
    /// Reports a visible change.
    void changed(double now) {
        ++changes_;
        changedAt_ = now;
        schedule.pictureChanged(now);
    }
    std::uint64_t changes() const { return changes_; }
    double changedAt() const { return changedAt_; }

    void handMoved(double now) {
        handMoved_ = now;
        changed(now);
    }
    /// When the last drag counts as finished.
    double handRests() const { return handMoved_ + kHandSeconds; }
    /// The picture moves by itself or is dragged.
    bool moving(double now) const { return motion.moving() || now < handRests(); }

private:
    mutable PictureDescription view_;
    std::uint64_t changes_ = 0;
    double changedAt_ = 0, handMoved_ = -1e9;
};

}  // namespace nacre::app
