#pragma once
// State shared by the viewer's parts: the wanted view with the interactive camera, the displayed document, and
// notifications of changes to both.

#include "app/viewer/camera_motion.h"
#include "app/viewer/frame_schedule.h"
#include "app/viewer/history.h"
#include "app/viewer/loader.h"
#include "app/viewer/messages.h"

namespace nacre::app {

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
    /// A view with an absolute camera, for saving: it does not depend on the drawn scene.
    PictureDescription placed(PictureDescription view) const {
        if (!shown()) return view;
        constexpr std::uint32_t kAnySize = 1000;
        const View seen = makeView(view.camera, document.drawing.radius(), kAnySize, kAnySize);
        view.camera = absoluteCamera(seen, view.camera.fovDegrees, document.drawing.scene().center);
        return view;
    }
    /// The reverse: relative to the document, if its centre is the view's.
    PictureDescription relative(PictureDescription placed) const {
        if (!shown() || placed.camera.center != document.drawing.scene().center) return placed;
        double radius = document.drawing.radius();
        placed.camera = relativeCamera(placed.camera, radius);
        placed.camera.center = view_.camera.center;
        return placed;
    }
    /// Radius of the document, Å.
    double radius() const { return document.drawing.radius(); }

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
    /// Whether the picture moves by itself or is dragged.
    bool moving(double now) const { return motion.moving() || now < handRests(); }

private:
    mutable PictureDescription view_;
    std::uint64_t changes_ = 0;
    double changedAt_ = 0, handMoved_ = -1e9;
};

}  // namespace nacre::app
