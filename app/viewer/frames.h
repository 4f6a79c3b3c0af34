#pragma once
// What the viewer's screen shows and when: frames, ambient occlusion, and what fails of them. What the screen cannot do
// for lack of memory is said and tried again a little later. A device that is lost is the shell's to replace.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/events.h"
#include "app/viewer/retry.h"
#include "app/viewer/screen.h"
#include "app/viewer/stage.h"

namespace nacre::app {

struct ViewerOptions {
    std::uint32_t mostSamples = 4;   ///< a side of a pixel, of the refinement
    double movingMilliseconds = 4;   ///< of occlusion a frame while something moves
    double restingMilliseconds = 8;  ///< of one submission of it while nothing does: a touch waits so long
    std::uint64_t occlusionBytes = RenderSettings{}.occlusion.bytes;
    std::string occlusionCache;  ///< folder of finished bakes; empty: none are kept
    FrameTuning tuning;          ///< never changes the picture
    bool errorsStay = false;     ///< the shell shows Messages::failure(), and lets it be dismissed
};

class Frames {
public:
    Frames(Screen& screen, Stage& stage, const ViewerOptions& options)
        : screen_(screen), stage_(stage), options_(options) {}

    // The window
    void resize(PixelSize pixels, double pixelsPerPoint, double now);
    PixelSize size() const { return size_; }
    double pixelsPerPoint() const { return scale_; }
    /// What a panel covers: the molecule stands in the middle of what it leaves.
    void setCovered(const Insets& pixels, double now);
    /// What it leaves: how large, and where it begins, pixels.
    PixelSize freeSize() const;
    glm::dvec2 freeCorner() const { return {covered_.left, covered_.top}; }
    /// The same in points.
    Viewport viewport() const { return {freeSize().width / scale_, freeSize().height / scale_}; }
    glm::dvec2 freeOrigin() const { return freeCorner() / scale_; }

    // The picture
    /// As it is seen. Only if Stage::shown().
    RenderSettings settings() const;
    /// The same in the middle of a picture of another size, for a file.
    RenderSettings pictureSettings(PixelSize size) const;
    /// Where a place is seen, from the scene's centre. @param view  of settings() @returns points
    glm::dvec2 pointOf(const glm::dvec3& place, const View& view) const;
    /// @param at, reach  points
    /// @returns the atom from 1, 0 for none; nothing if it could not be had, which is said
    std::optional<std::uint32_t> atomAt(glm::dvec2 at, double reach, double now);
    DebugView debugView() const { return debug_; }
    void setDebugView(DebugView view, double now);
    /// A side of a pixel, of the refinement, from now on.
    void setMostSamples(std::uint32_t samples) { options_.mostSamples = samples; }
    /// As ViewerOptions::occlusionBytes, from now on.
    void setOcclusionBytes(std::uint64_t bytes) { options_.occlusionBytes = bytes; }
    std::uint32_t mostSamples() const { return options_.mostSamples; }
    /// A processor draws: a frame of a motion may take so many seconds before its resolution drops, which it does not
    /// below a share, and which is told.
    void keepSharp(double seconds, double leastScale);
    /// That a moving picture is not as sharp as one at rest, where that is told.
    std::string coarseness() const;

    // The scene
    /// @returns whether it is on the screen: not, if the device is lost, whose successor gets it. @throws Error
    bool setScene(const Representation& scene, const MapLayers& maps) { return put(scene, maps, &Screen::setScene); }
    /// The same of one whose atoms have moved.
    bool moveScene(const Representation& scene) {
        return !sceneThere_ || put(scene, stage_.document.maps, &Screen::moveScene);
    }
    /// Has made what the first frame of what is being read is going to want.
    void expectScene(const PictureDescription& coming);
    /// Share of the ambient occlusion that is done.
    double occlusion() const { return occlusion_; }
    void restartOcclusion() {
        const PictureDescription& view = stage_.view();
        occlusion_ = view.occlusion.directions ? 0 : 1;
    }
    /// Another document may have room for what failed before.
    void retryOcclusion() { occlusionRetry_ = {}; }

    /// Draws, if there is something to draw.
    /// @param playing  frames of a molecule follow each other
    /// @param overlay  called before a frame is drawn; may be empty
    /// @returns when to call again, if nothing happens before; never: infinity
    double update(double now, bool playing, const std::function<const Overlay*()>& overlay);
    /// The last update() showed a frame.
    bool drew() const { return drew_; }
    /// If a frame is going to be drawn, waits until it can be.
    void await(double now);
    /// The device was lost while drawing: make another screen, then replaced().
    bool lost() const { return lost_; }
    /// The window's picture or the device is lost, or the screen draws on another one. Says what is known of the loss.
    void replaced(double now);

private:
    bool put(const Representation& scene, const MapLayers& maps, void (Screen::*how)(const Representation&));
    void putScene(double now);
    void advanceOcclusion(double now, bool moving);
    void draw(const FrameSchedule::Next& next, double now, bool moving, const std::function<const Overlay*()>& overlay);
    FrameSchedule::Next next(double now, bool moving) const;
    /// Share of the occlusion that is done of what there is: nothing has none.
    double bakedShare() const { return stage_.shown() ? occlusion_ : 1.0; }
    std::uint32_t refinedSamples() const;
    void failed(const std::exception& error, Retry& retry, double now);
    bool noticeLoss();

    Screen& screen_;
    Stage& stage_;
    ViewerOptions options_;
    PixelSize size_{1, 1};
    double scale_ = 1;  // pixels a point
    Insets covered_;
    DebugView debug_ = DebugView::none;
    double occlusion_ = 1;
    WindowFrame frame_;  // the last one
    bool drew_ = false, lost_ = false, tellsScale_ = false;
    bool sceneThere_ = true;       // the document's scene is on the screen
    std::vector<Style> expected_;  // of what was read last, or is being read
    Retry sceneRetry_, occlusionRetry_, frameRetry_;
    std::string loss_;  // of the device, until another is there
};

}  // namespace nacre::app
