#pragma once
// The camera as the user commands it: gestures, keys, and aims at parts of the molecule, which may cut away what stands
// before them.

#include "app/picture/aim.h"
#include "app/viewer/commands.h"
#include "app/viewer/frames.h"
#include "app/viewer/gestures.h"
#include "app/viewer/reading.h"

namespace nacre::app {

class CameraControl {
public:
    CameraControl(Stage& stage, Frames& frames, Reading& reading) : stage_(stage), frames_(frames), reading_(reading) {}

    /// @returns whether it was one that moves the camera, or stops it
    bool apply(const Gesture& gesture, double now);
    /// @returns whether it was a command of the camera
    bool run(ViewerCommand command, double now);
    /// Flies to where a molecule is seen from as asked; while one is read, that one, once it is there.
    void aim(const Aim& aim, double now);
    /// The same, of what is shown. @param fly  not at once
    void take(Aim aim, bool fly, double now);
    /// Flies to the whole molecule.
    void fit(double now);
    /// Another molecule or scene is there: an aim that waited for it is taken. @param fly  from where the camera is
    void arrived(bool fly, double now);
    /// The view is another one, with its own clipping planes.
    void forgetClip() { clipped_ = false; }

private:
    bool runByHand(ViewerCommand command, double now);
    void unclip();

    Stage& stage_;
    Frames& frames_;
    Reading& reading_;
    bool clipped_ = false;  // by a close-up
    Aim aim_;               // of the molecule that is being read
};

}  // namespace nacre::app
