#pragma once
// The viewer, independent of platforms: molecule, look, camera, input, picks, and timing. A shell passes events to it,
// asks after each when to call again, and shows annotations() and title(). It has no clock: every call passes the time,
// in seconds. For one thread.
//
// Its parts share a Stage and are accessible to the shell: reading, playback, picking, words, frames. If a document
// cannot be loaded for lack of memory, the previous one stays.

#include <functional>
#include <string>
#include <vector>

#include "app/viewer/camera_control.h"
#include "app/viewer/frames.h"
#include "app/viewer/gestures.h"
#include "app/viewer/picking.h"
#include "app/viewer/picture_words.h"
#include "app/viewer/playback.h"
#include "app/viewer/reading.h"
#include "app/viewer/stage.h"

namespace nacre::app {

class Viewer {
public:
    Viewer(Screen& screen, Sources sources, const PictureDescription& view, const ViewerOptions& options,
           std::function<void()> wake = {});
    Viewer(const Viewer&) = delete;

    // Its parts
    Messages& messages() { return stage_.messages; }
    const Messages& messages() const { return stage_.messages; }
    FrameSchedule& schedule() { return stage_.schedule; }
    const FrameSchedule& schedule() const { return stage_.schedule; }
    const CameraMotion& motion() const { return stage_.motion; }
    Frames& frames() { return frames_; }
    const Frames& frames() const { return frames_; }
    Reading& reading() { return reading_; }
    const Reading& reading() const { return reading_; }
    Playback& playback() { return playback_; }
    const Playback& playback() const { return playback_; }
    Picking& picking() { return picking_; }
    const Picking& picking() const { return picking_; }
    const PictureWords& words() const { return words_; }
    PictureWords& words() { return words_; }
    CameraControl& camera() { return camera_; }

    // Events
    void touch(const TouchEvent& event, double now) { apply(touches_.handle(event, now), now); }
    void mouseMove(glm::dvec2 at, double now);
    void mouseButton(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now);
    void wheel(double steps, glm::dvec2 at, double now);
    /// Changes the contour level of the first map that has one, in steps of 0.1 sigma.
    void changeLevel(double steps, double now);
    /// A gesture that the platform recognised: pinch and twist of a trackpad.
    void gesture(const Gesture& gesture, double now) { apply({gesture}, now); }
    void run(ViewerCommand command, double now);
    void pause();
    void resume(double now);

    /// Opens files of any kind (file_kind.h): shows a saved view, applies a look to the current scene, and passes other
    /// files to Reading. Reports files that cannot be opened.
    /// @param beside  adds structures to the current scene
    void open(const std::vector<std::string>& paths, bool beside, double now);
    void open(const std::string& path, double now) { open(std::vector{path}, false, now); }

    // Current state
    const PictureDescription& view() const { return stage_.view(); }
    /// As above, for a restart; empty if it could not be read. The camera is absolute if an earlier style determines
    /// the scale.
    PictureDescription restartView() const {
        if (!stage_.shown() && !reading_.loader().busy() && !reading_.question()) return {};
        return stage_.document.drawing.reframed() ? stage_.placed(view()) : view();
    }
    const Document* document() const { return stage_.shown() ? &stage_.document : nullptr; }
    /// Applies a complete view, and reads its molecule. @param seconds  duration of the flight
    void show(const PictureDescription& view, double now, double seconds = CameraMotion::kFlightSeconds);
    /// Sets another look or projection; ignores the camera of `look`.
    /// @param continues  joins the previous undo step, as during a slider drag
    void setLook(const PictureDescription& look, double now, bool continues = false);
    bool canUndo() const { return stage_.shown() && stage_.history.canUndo(stage_.destination()); }
    bool canRedo() const { return stage_.shown() && stage_.history.canRedo(stage_.destination()); }
    void undo(double now);
    void redo(double now);
    std::string title() const;
    /// Explains the picture (explanation.h); empty without a document.
    std::string explanation() const;
    /// Whether labels, measurements or rules changed since the molecule was opened or the view saved.
    bool hasUnsavedWork() const;
    void noteSaved() { saved_ = view(); }

    /// Advances everything to a time and draws, if there is something to draw.
    /// @param overlay called before a frame is drawn; may be empty
    /// @returns when to call again without further events; never: infinity
    double update(double now, const std::function<const Overlay*()>& overlay = {});

private:
    void apply(const std::vector<Gesture>& gestures, double now);
    void showFile(const std::string& path, double now);
    void aimAt(ViewerCommand command, double now);
    bool changeLook(ViewerCommand command, PictureDescription& look, double now);
    void restore(const PictureDescription& saved, double now, double seconds = CameraMotion::kFlightSeconds);
    void takeDocument(double now);
    bool focusMoved() const;
    void followCamera(double now);
    double advance(double now);

    Stage stage_;
    PictureDescription saved_;
    Frames frames_;
    Reading reading_;
    PictureWords words_;
    Picking picking_;
    Playback playback_;
    CameraControl camera_;
    TouchGestures touches_;
    MouseGestures mouse_;
    std::size_t preset_ = 0, look_ = 0;  // indices most recently stepped to
    double levelTurned_ = -1e9;
    mutable std::uint64_t explained_ = 0;  // the scene's number
    mutable std::string explanation_;      // of that scene
    std::uint64_t followed_ = 0;           // Stage::changes() when the scene last followed the camera
};

}  // namespace nacre::app
