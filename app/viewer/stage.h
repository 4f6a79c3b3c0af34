#pragma once
// What the viewer's parts share: the view as it is wanted, with the camera in the user's hand, the document that is
// shown, and who is told that either changed.

#include "app/viewer/camera_motion.h"
#include "app/viewer/frame_schedule.h"
#include "app/viewer/history.h"
#include "app/viewer/loader.h"
#include "app/viewer/messages.h"

namespace nacre::app {

class Stage {
public:
    static constexpr double kHandSeconds = 0.1;  ///< a hand that rests this long no longer moves the picture

    Stage(const PictureDescription& view, bool errorsStay) : messages(schedule, errorsStay), view_(view) {
        motion.set(view.camera);
    }
    Stage(const Stage&) = delete;

    FrameSchedule schedule;
    Messages messages;
    CameraMotion motion;
    History history;
    Document document;

    /// As it is wanted, seen from where `motion` has the camera.
    const PictureDescription& view() const {
        view_.camera = motion.camera();
        view_.aim.fits = false;  // that says how large
        return view_;
    }
    /// The same, to be changed; its camera is not looked at.
    PictureDescription& wanted() { return view_; }
    /// The same where a flight has arrived.
    PictureDescription destination() const {
        PictureDescription view = view_;
        view.camera = motion.destination();
        view.aim.fits = false;
        return view;
    }
    /// A document is there.
    bool shown() const { return document.molecule != nullptr; }
    /// Radius of what is shown, Å.
    double radius() const { return shown() ? document.radius : 1.0; }

    /// Called before whatever changes what is seen: what stood until now becomes a step.
    void remember() {
        if (shown()) history.remember(destination());
    }
    /// The picture is another one.
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
    /// When a hand that moved the picture last counts as at rest.
    double handRests() const { return handMoved_ + kHandSeconds; }
    /// The picture moves by itself, or under a hand.
    bool moving(double now) const { return motion.moving() || now < handRests(); }

private:
    mutable PictureDescription view_;
    std::uint64_t changes_ = 0;
    double changedAt_ = 0, handMoved_ = -1e9;
};

}  // namespace nacre::app
