#pragma once
// The viewer's frames on its screen: their timing, ambient occlusion, and failures. Out-of-memory failures are reported
// and retried a little later. The shell replaces a lost device.

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/events.h"
#include "app/viewer/outline.h"
#include "app/viewer/screen.h"
#include "app/viewer/stage.h"

namespace nacre::app {

/// Delays retries, longer after each consecutive failure.
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

struct ViewerOptions {
    std::uint32_t mostSamples = 4;   ///< per pixel side, for refinement
    double movingMilliseconds = 4;   ///< of occlusion per frame during motion
    double restingMilliseconds = 8;  ///< of one submission of it otherwise: the delay for a touch
    std::uint64_t occlusionBytes = RenderSettings{}.occlusion.bytes;
    std::string occlusionCache;  ///< folder of finished bakes; empty: no cache
    FrameTuning tuning;          ///< never changes the picture
    bool errorsStay = false;     ///< the shell shows Messages::failure() until it is dismissed
};

/// Where marked atoms are visible in the window.
struct ShownMarks {
    std::vector<MarkSpan> spans;
    std::uint32_t step = 1;  ///< pixels of the window per pixel of the spans
};

/// A free part of the window, as a picture.
struct FreePart {
    View view;
    glm::dvec2 corner;      ///< in the window, pixels
    glm::ivec2 from, size;  ///< including covered areas, and as large as the other eye's: may extend beyond the window
    OverlayEye eye = OverlayEye::both;  ///< the eye that sees the overlay on it
};

class Frames {
public:
    Frames(Screen& screen, Stage& stage, const ViewerOptions& options)
        : screen_(screen), stage_(stage), options_(options) {}

    // The window
    void resize(PixelSize pixels, double pixelsPerPoint, double now);
    PixelSize size() const { return size_; }
    double pixelsPerPoint() const { return scale_; }
    /// Sets the area covered by the panel: the molecule is centred in the rest.
    void setCovered(const Insets& pixels, double now);
    /// Size of the free area, and its position, pixels.
    PixelSize freeSize() const;
    glm::dvec2 freeCorner() const { return {covered_.left, covered_.top}; }
    /// The free area in points.
    Viewport viewport() const { return {freeSize().width / scale_, freeSize().height / scale_}; }
    glm::dvec2 freeOrigin() const { return freeCorner() / scale_; }

    // The picture
    // As currently shown. Only if Stage::shown().
    RenderSettings settings() const;
    /// As above, centred in a picture of another size.
    RenderSettings pictureSettings(PixelSize size) const;
    /// The free area, or each eye's part of it: left, right.
    std::vector<FreePart> freeParts() const;
    /// The views of both eyes, if the picture has two.
    std::optional<std::array<WindowEye, 2>> eyes() const;
    /// A picture of the document for a file, with its words.
    /// @param picture  its camera, size, shading and words
    /// @param marked  with the outline of the selected atoms, unless it has two eyes @throws Error
    Picture draw(Renderer& renderer, PictureDescription picture, bool marked = false);
    /// Settings of such a picture; shifts the molecule clear of the words if it is fully visible. @throws Error
    const RenderSettings& compose(PictureDescription picture);
    /// Screen position of a point relative to the scene's centre. @param view  from settings() @returns points
    glm::dvec2 projectPoint(const glm::dvec3& place, const View& view) const;
    /// @param at, reach  points
    /// @returns the atom from 1, 0 for none; empty if it failed, which is reported
    std::optional<std::uint32_t> atomAt(glm::dvec2 at, double reach, double now);
    DebugView debugView() const { return debug_; }
    void setDebugView(DebugView view, double now);
    /// Samples per pixel side of the refinement, from now on.
    void setMostSamples(std::uint32_t samples) { options_.mostSamples = samples; }
    /// See ViewerOptions::occlusionBytes. Applies from now on.
    void setOcclusionBytes(std::uint64_t bytes) { options_.occlusionBytes = bytes; }
    std::uint32_t mostSamples() const { return options_.mostSamples; }
    /// For software devices: a frame during motion may take this many seconds before the resolution drops, at least to
    /// a minimum fraction; the user is told.
    void keepSharp(double seconds, double leastScale);
    /// Text about reduced resolution during motion; empty unless the user is to be told.
    std::string coarseness() const;

    // The scene
    // @returns whether it is on the screen: not if the device is lost; the next device gets it. @throws Error
    bool setScene(const Drawing& drawing) { return put(drawing.joinedScene(), &Screen::setScene); }
    /// Like setScene(), for the document's scene with moved atoms.
    bool moveScene(const Representation& scene) {
        return !sceneThere_ || put(withMaps(scene, stage_.document.drawing.maps()), &Screen::moveScene);
    }
    /// Outlines these atoms from the next frame on: hovered ones at rest, selected ones in motion too if the device
    /// finds them in time.
    void setMarks(Highlights marks);
    const Highlights& marks() const { return marks_; }
    const ShownMarks& shownMarks() const { return shownMarks_; }
    /// Prepares the first frame of the document being read.
    void expectScene(const PictureDescription& coming);
    /// Finished share of the ambient occlusion.
    double occlusion() const { return occlusion_; }
    void restartOcclusion() {
        const PictureDescription& view = stage_.view();
        occlusion_ = view.occlusion.directions ? 0 : 1;
    }
    /// Forgets the last failure: another document may need less memory.
    void retryOcclusion() { occlusionRetry_ = {}; }

    /// Draws, if there is something to draw.
    /// @param playing  frames of a molecule follow each other
    /// @param overlay  called before a frame is drawn; may be empty
    /// @returns when to call again without further events; never: infinity
    double update(double now, bool playing, const std::function<const Overlay*()>& overlay);
    /// Whether the last update() showed a frame.
    bool drew() const { return drew_; }
    /// Waits for the queue and window image if a frame will be drawn.
    void await(double now);
    /// Whether the device was lost while drawing: create another screen, then call replaced().
    bool lost() const { return lost_; }
    /// Call if the window's picture or the device is lost, or the screen uses another one. Reports the loss.
    void replaced(double now);

private:
    bool put(Representation scene, void (Screen::*how)(Representation));
    void findMarks(bool moving);
    void setUp(RenderSettings& settings) const;
    void putScene(double now);
    void advanceOcclusion(double now, bool moving, bool playing);
    void draw(const FrameSchedule::Next& next, double now, bool moving, const std::function<const Overlay*()>& overlay);
    FrameSchedule::Next next(double now, bool moving) const;
    /// Finished share of the occlusion, 1 without a document.
    double bakedShare() const { return stage_.shown() ? occlusion_ : 1.0; }
    std::uint32_t refinedSamples() const;
    void failed(const std::exception& error, Retry& retry, double now);
    bool noticeLoss();

    Screen& screen_;
    Stage& stage_;
    ViewerOptions options_;
    PixelSize size_{1, 1};
    double scale_ = 1;  // pixels per point
    Insets covered_;
    DebugView debug_ = DebugView::none;
    double occlusion_ = 1;
    WindowFrame frame_;  // the last one
    bool drew_ = false, lost_ = false, tellsScale_ = false;
    bool played_ = false;     // at the last update
    bool sceneThere_ = true;  // the document's scene is on the screen
    Highlights marks_;
    ShownMarks shownMarks_;
    std::vector<std::uint32_t> seen_;  // the atom in each pixel, of a picture with
    PixelSize seenSize_{0, 0};
    std::uint64_t seenAt_ = 0;     // Stage::changes() at that time
    double seenMilliseconds_ = 0;  // per pixel
    bool marksDue_ = false;        // shownMarks_ are older than marks_
    std::vector<Style> expected_;  // of the document most recently read or being read
    Retry sceneRetry_, occlusionRetry_, frameRetry_;
    std::string loss_;  // of the device, until it is replaced
};

}  // namespace nacre::app
