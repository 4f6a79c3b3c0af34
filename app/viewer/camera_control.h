#pragma once
// The camera under user control: gestures, keys, and aims at parts of the molecule, which may clip whatever is in
// front.

#include "app/picture/aim.h"
#include "app/viewer/commands.h"
#include "app/viewer/frames.h"
#include "app/viewer/gestures.h"
#include "app/viewer/reading.h"

namespace nacre::app {

class CameraControl {
public:
    CameraControl(Stage& stage, Frames& frames, Reading& reading) : stage_(stage), frames_(frames), reading_(reading) {}

    /// @returns whether the gesture moves or stops the camera
    bool apply(const Gesture& gesture, double now);
    /// See CameraMotion::hold. Call after a gesture `touched`.
    void hold(const glm::dquat& orientation, double zoom, double now);
    /// @returns whether it is a camera command
    bool run(ViewerCommand command, double now);
    /// Flies to the view of an aim; while a molecule is being read, waits for it.
    void aim(const Aim& aim, double now);
    /// As above for the current document. @param fly  animate
    void take(Aim aim, bool fly, double now);
    /// Shows the broadest side of a newly opened document, like the command `orient`.
    void alignToAxes();
    /// Flies to the whole molecule.
    void fit(double now);
    /// Call when a new document or scene is there: applies a waiting aim. @param fly  animate
    void arrived(bool fly, double now);
    /// Call when the view was replaced by one with its own clipping planes.
    void forgetClip() { clipped_ = false; }

private:
    bool runByHand(ViewerCommand command, double now);
    void unclip();

    Stage& stage_;
    Frames& frames_;
    Reading& reading_;
    bool clipped_ = false;  // a close-up set clipping planes
    Aim aim_;               // waits for the molecule being read
};

}  // namespace nacre::app
