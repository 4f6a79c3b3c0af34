#pragma once
// The viewer, free of platforms: molecule, look, camera, hands, picks, and when to draw. A shell feeds it events, asks
// it after each when it wants to be called again, and shows what annotations() and title() say. It has no clock: every
// call says what time it is, in seconds. For one thread.
//
// What the screen cannot do for lack of memory is said and tried again a little later; a picture too large to be loaded
// leaves the one before. A device that is lost is the shell's to replace.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/annotation/placed_words.h"
#include "app/picture/aim.h"
#include "app/viewer/camera_motion.h"
#include "app/viewer/commands.h"
#include "app/viewer/events.h"
#include "app/viewer/frame_schedule.h"
#include "app/viewer/gestures.h"
#include "app/viewer/history.h"
#include "app/viewer/loader.h"
#include "app/viewer/mouse.h"
#include "app/viewer/playback.h"
#include "app/viewer/player.h"
#include "app/viewer/retry.h"
#include "app/viewer/screen.h"

namespace nacre::app {

/// What a shell draws over the picture, in points from the window's top left.
struct Annotations {
    std::vector<glm::dvec2> atoms;     ///< picked, in their order; a line joins each to the next
    std::string atom;                  ///< what the last one is
    std::string measurement;           ///< what they measure
    std::string message;               ///< of the last command, or of what went wrong
    std::string error;                 ///< what went wrong, until it is dismissed (ViewerOptions::errorsStay)
    std::vector<glm::dvec2> selected;  ///< atoms of the selection; of many, some
    std::string hover;                 ///< what the pointer rests on
    std::string coarse;                ///< that a moving picture is not as sharp as one at rest
};

/// What is selected: a text that is being typed, or what was clicked.
struct SelectedAtoms {
    std::string text;
    std::string error;      ///< why the text is no selection
    std::size_t count = 0;  ///< atoms of the molecule
    bool any() const { return !text.empty() && error.empty(); }
};

/// Points of the words in a window, and of an em of the panel's font of 15 points.
constexpr double kWordPoints = 15 / 1.164;

struct ViewerOptions {
    std::uint32_t mostSamples = 4;   ///< a side of a pixel, of the refinement
    double movingMilliseconds = 4;   ///< of occlusion a frame while something moves
    double restingMilliseconds = 8;  ///< of one submission of it while nothing does: a touch waits so long
    std::uint64_t occlusionBytes = RenderSettings{}.occlusion.bytes;
    std::string occlusionCache;  ///< folder of finished bakes; empty: none are kept
    FrameTuning tuning;          ///< never changes the picture
    bool errorsStay = false;     ///< the shell shows Annotations::error, and lets it be dismissed
};

class Viewer {
public:
    Viewer(Screen& screen, Sources sources, const SavedView& view, const ViewerOptions& options,
           std::function<void()> wake = {});

    // Events
    void resize(PixelSize pixels, double pixelsPerPoint, double now);
    void touch(const TouchEvent& event, double now);
    void mouseMove(glm::dvec2 at, double now);
    void mouseButton(MouseButton button, bool down, glm::dvec2 at, Modifiers with, double now);
    void wheel(double steps, glm::dvec2 at, double now);
    /// One that the platform recognised itself: pinch and twist of a trackpad.
    void gesture(const Gesture& gesture, double now) { apply({gesture}, now); }
    void run(ViewerCommand command, double now);
    /// Instead of what is shown; several stand together.
    void open(const std::vector<std::string>& paths, double now);
    void open(const std::string& path, double now) { open(std::vector{path}, now); }
    /// Beside what is shown.
    void add(const std::vector<std::string>& paths, double now);
    void add(const std::string& path, double now) { add(std::vector{path}, now); }
    /// All that a view says: its molecule is read. @param seconds  that the flight there takes
    void show(const SavedView& view, double now, double seconds = CameraMotion::kFlightSeconds);
    /// What is being read is not wanted any more.
    void cancelLoading(double now);
    /// What a panel covers: the molecule stands in the middle of what it leaves.
    void setCovered(const Insets& pixels, double now);
    /// The pointer has left the picture.
    void pointerLeft();
    /// Flies to where a molecule is seen from as asked; while one is read, that one, once it is there.
    void aim(const Aim& aim, double now);
    void pause();
    void resume(double now);
    /// Gives up what can be made again: the refined picture's samples from now on, picks stay.
    void lowMemory() { options_.mostSamples = 1; }
    /// As ViewerOptions::occlusionBytes, from now on.
    void setOcclusionBytes(std::uint64_t bytes) { options_.occlusionBytes = bytes; }
    /// A side of a pixel, of the refinement, from now on.
    void setMostSamples(std::uint32_t samples) { options_.mostSamples = samples; }
    std::uint32_t mostSamples() const { return options_.mostSamples; }
    /// The window's picture or the device is lost, or `screen` draws on another one. Says what is known of the loss.
    void screenLost(double now);

    // State
    const SavedView& view() const;
    /// Another look or projection; the camera of `look` is not looked at.
    /// @param continues  one step of the history with the look before, as while a slider is dragged
    void setLook(const SavedView& look, double now, bool continues = false);
    bool canUndo() const;
    bool canRedo() const;
    void undo(double now);
    void redo(double now);
    /// Selects by text; an empty one selects nothing.
    void select(const std::string& text);
    const SelectedAtoms& selection() const { return selected_; }
    /// Models of the file; 0 while there is none.
    int models() const;
    // Of a molecule that moves, or a file of several models: frames are counted from 0.
    const Playback& playback() const { return playback_; }
    /// The frames are those of a trajectory, not models of the file.
    bool hasTrajectory() const;
    /// Frames can be laid: fitted, smoothed, made whole.
    bool canLay() const { return player_ && document_.moves(); }
    void showFrame(std::size_t frame, double now);
    void setPlaying(bool playing, double now);
    void setRate(double framesPerSecond);
    void setOrder(PlayOrder order);
    /// How frames are laid; file and frame of the options are not looked at.
    void setMotion(const TrajectoryOptions& options, double now);
    /// Of the frame that is shown: ps, if its file says so; and how far fitted atoms are from the first frame's, Å.
    std::optional<double> frameTime() const { return frameTime_; }
    double frameRmsd() const { return frameRmsd_; }
    const std::string& failure() const { return failure_; }
    void dismissFailure();
    void overlayChanged() { schedule_.overlayChanged(); }
    std::string title() const;
    Annotations annotations() const;
    /// Of what was asked for at first. @throws what reading it threw, if that is known by now
    void throwEarlyFailure() { loader_.throwFailure(); }
    bool loading() const { return loader_.busy(); }
    /// Of the input that is being read, as Sources::progress.
    double loadingProgress() const { return loader_.progress(); }
    const std::string& loadingName() const { return loader_.view().input; }
    void waitForLoading() const { loader_.wait(); }
    /// The time that the last update() was told.
    double lastUpdate() const { return updated_; }
    /// Until the frame that was asked for last is ready, if one was.
    void waitForFrame() const {
        if (player_) player_->wait();
    }
    const Document* document() const { return document_.molecule ? &document_ : nullptr; }
    double occlusion() const { return occlusion_; }
    /// The view as it is saved: what the picked atoms measure stays.
    SavedView savedView() const;
    /// Labels, legend and the like, where they stand in the document.
    const PlacedWords& words() const { return placedWords_; }
    /// Pixels of an em of them.
    double textSize() const;
    /// What the user has to answer before the molecule is read; null: nothing.
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    void answer(bool yes, double now);
    /// Picked atoms, from 0, in their order.
    const std::vector<std::uint32_t>& picks() const { return picks_; }
    bool playing() const { return playback_.playing(); }
    bool autoRotating() const { return motion_.autoRotation(); }
    bool rocking() const { return motion_.rocking(); }
    DebugView debugView() const { return debug_; }
    void setDebugView(DebugView view, double now);
    void say(const std::string& message, double now);
    /// Tells what went wrong.
    void fail(const std::string& what, double now);
    /// The picture as it is seen. Only if document().
    RenderSettings settings() const;
    /// The same in the middle of a picture of another size, for a file.
    RenderSettings pictureSettings(PixelSize size) const;
    /// The same of one that words are painted on: the molecule stands beside them, as `nacre render --view` has it,
    /// where it is seen whole.
    RenderSettings pictureWithWords(PixelSize size, double textSize) const;
    /// Labels, legend and the like, onto a picture that was drawn so. Only if document().
    /// @param size  pixels of an em  @param transparent  it has no background
    void paintWords(const View& view, double size, bool transparent, Picture& picture) const;
    PixelSize size() const { return size_; }
    /// What the panel leaves of it: how large, and where it begins, pixels.
    PixelSize freeSize() const;
    glm::dvec2 freeCorner() const { return {covered_.left, covered_.top}; }

    /// Brings everything to a time and draws, if there is something to draw.
    /// @param overlay called before a frame is drawn; may be empty
    /// @returns when to call again, if nothing happens before; never: infinity
    double update(double now, const std::function<const Overlay*()>& overlay = {});
    /// If a frame is going to be drawn, waits until it can be: call it before the newest input is handed over, and
    /// update() after that.
    void awaitFrame(double now);
    /// Seconds from one picture of the display to the next; what no display has is not taken.
    void setDisplayInterval(double seconds) { schedule_.setDisplayInterval(seconds); }
    double displayInterval() const { return schedule_.displayInterval(); }
    /// As ResolutionControl::setHeat.
    void setHeat(double heat) { schedule_.setHeat(heat); }
    /// A processor draws: a frame of a motion may take so many seconds before its resolution drops, which it does not
    /// below a share, and which is told.
    void keepSharp(double seconds, double leastScale) {
        schedule_.setLongestFrame(seconds);
        schedule_.setLeastScale(leastScale);
        tellsScale_ = true;
    }
    const MotionFrames& motionFrames() const { return schedule_.motionFrames(); }
    /// The device was lost while drawing: make another screen, then screenLost().
    bool deviceLost() const { return deviceLost_; }

private:
    void apply(const std::vector<Gesture>& gestures, double now);
    void pick(glm::dvec2 at, double now);
    void doubleTap(glm::dvec2 at, double now);
    std::optional<std::uint32_t> atomUnder(glm::dvec2 at, double reach, double now);
    void hover(double now);
    void hoverAgain(double now);
    std::vector<std::uint32_t> markedAtoms(const std::vector<bool>& chosen) const;
    void placeSelection();
    glm::dvec2 pointOf(const glm::dvec3& place, const View& view) const;
    void remember();
    bool unrememberedChange() const;
    void restore(const SavedView& view, double now, double seconds = CameraMotion::kFlightSeconds);
    void putScene(double now);
    /// Has made what the first frame of what is being read is going to want.
    void expectScene(const WindowFrame& frame);
    bool putWords(double now);
    bool join(SavedView& view, const std::vector<std::string>& paths, double now);
    void advanceOcclusion(double now, bool moving);
    void failed(const std::exception& error, Retry& retry, double now);
    bool noticeLoss();
    void tookDocument(double now);
    double advance(double now);
    void setLaying(const TrajectoryOptions& options);
    void takePlayer(bool another, bool step);
    void stepFrame(int step, double now);
    void request(std::size_t frame, double now);
    double play(double now);
    void showPlayed(double now);
    bool moveCamera(ViewerCommand command, double now);
    bool aimCamera(ViewerCommand command, double now);
    void unclip();
    void takeAim(Aim aim, bool fly, double now);
    void draw(const FrameSchedule::Next& next, double now, bool moving, const std::function<const Overlay*()>& overlay);
    std::uint32_t refinedSamples() const;
    /// When a hand that moved the picture last counts as at rest.
    double handRests() const;
    static std::string nameOf(const std::string& input);
    glm::dvec2 freeOrigin() const { return glm::dvec2(covered_.left, covered_.top) / scale_; }
    Viewport viewport() const { return {freeSize().width / scale_, freeSize().height / scale_}; }
    double radius() const { return document_.molecule ? document_.radius : 1.0; }
    /// Share of it that is done of what there is: nothing has none.
    double bakedShare() const { return document_.molecule ? occlusion_ : 1.0; }
    void changed(double now) { hoverAgain(now), schedule_.pictureChanged(now); }

    Screen& screen_;
    ViewerOptions options_;
    Loader loader_;
    mutable SavedView view_;  // its camera is that of motion_
    Document document_;
    PlacedWords placedWords_;
    CameraMotion motion_;
    TouchGestures touches_;
    MouseGestures mouse_;
    FrameSchedule schedule_;
    PixelSize size_{1, 1};
    double scale_ = 1;  // pixels a point
    Insets covered_;
    double occlusion_ = 1;
    double handMoved_ = -1e9;
    double drawnScale_ = 1;  // of the last frame
    double updated_ = 0;
    bool tellsScale_ = false;
    bool clipped_ = false;                            // by a close-up
    Aim aim_;                                         // of the molecule that is being read
    std::vector<std::uint32_t> picks_, picksBefore_;  // atoms, from 0
    SelectedAtoms selected_;
    std::vector<glm::dvec3> selectedPlaces_;  // from the scene's centre
    std::optional<glm::dvec2> pointerAt_;     // over the molecule
    std::optional<double> hoverDue_;          // when what is there is looked for; empty: it is known
    std::uint32_t hovered_ = 0;               // atom, from 1
    History history_;
    bool restoring_ = false;     // what is being read belongs to the view as it is
    bool unremembered_ = false;  // the view may differ from what the history has last
    std::string failure_;
    DebugView debug_ = DebugView::none;
    std::optional<Question> question_;
    SavedView asked_;  // what question_ is about
    std::string message_;
    double messageUntil_ = 0;
    std::size_t preset_ = 0, lookNumber_ = 0;
    std::function<void()> wake_;
    Playback playback_;
    std::unique_ptr<Player> player_;      // null: models are read one by one, if there are any
    std::optional<PlayedFrame> waiting_;  // until it is due
    std::optional<double> frameTime_;     // ps
    double frameRmsd_ = 0;
    bool deviceLost_ = false, firstDocument_ = true;
    bool sceneThere_ = true;       // the document's scene is on the screen
    std::vector<Style> expected_;  // of what was read last, or is being read
    Retry sceneRetry_, occlusionRetry_, frameRetry_;
    std::string loss_;  // of the device, until another is there
};

}  // namespace nacre::app
