#pragma once
// When to draw, and what: the whole of the viewer's thrift. A picture that moves is drawn as often as the display asks
// for it, at a resolution that keeps up; one that came to rest is refined, sample by sample; then nothing is drawn.

#include <cstdint>
#include <limits>

namespace nacre::app {

/// Frames of motions.
struct MotionFrames {
    std::uint64_t frames = 0, reduced = 0;  ///< all, and those below the window's resolution
    double smallestScale = 1;               ///< of one of them
};

/// What a moving picture gives up to keep up: first what is finer than a moving eye sees, then resolution, each by the
/// smallest step.
class ResolutionControl {
public:
    static constexpr int kPatience = 4;     ///< slow frames in a row before the resolution drops
    static constexpr int kConfidence = 30;  ///< frames in a row that leave room for more before it rises
    static constexpr int kInFlight = 2;     ///< frames after a change that are still of the resolution before

    double scale() const;
    /// As WindowFrame::meshError.
    double meshError() const;
    /// Cartoons or surfaces are seen: coarser ones are a step of their own.
    void setMeshes(bool meshes) { meshes_ = meshes; }
    /// The least share of the window's resolution that is taken.
    void setLeastScale(double scale) { leastScale_ = scale; }
    /// How near the device is to slowing itself down for its heat: 0 cold, 1 it does. From kWarm on motions give up
    /// pixels before it comes to that, down to kHotScale of the window's resolution.
    void setHeat(double heat) { heat_ = heat; }
    static constexpr double kWarm = 0.8, kHotScale = 0.55;
    /// @param seconds   from one frame of a motion to the next
    /// @param device    of which the device took so many; 0: nobody knows
    /// @param longest   that a frame may take: from one picture of the display to the next, or more
    void frameTook(double seconds, double device, double longest);
    /// The picture stands still.
    void rest();

private:
    void change(int step);
    int nextLevel(int step) const;
    int level_ = 0, slow_ = 0, fast_ = 0, unsettled_ = 0;
    bool meshes_ = false;
    double leastScale_ = 0, heat_ = 0;
};

enum class Draw {
    nothing,
    live,
    refine,  ///< one sample of each pixel more, and kept
    keep,    ///< the refined picture once more, under another overlay
};

class FrameSchedule {
public:
    static constexpr double kSettleSeconds = 0.15;  ///< from the last change to the refinement
    static constexpr double kBakeSeconds = 0.001;   ///< from one look at what the device bakes to the next

    void pictureChanged(double now);
    void overlayChanged() { overlayChanged_ = true; }
    /// The window lost what was in it, or has another size.
    void windowChanged(double now);
    void setVisible(bool visible) { visible_ = visible; }
    bool visible() const { return visible_; }

    struct Next {
        Draw draw = Draw::nothing;
        double scale = 1, meshError = 2;
        std::uint32_t sample = 0;                               ///< of `refine`: which
        double wake = std::numeric_limits<double>::infinity();  ///< when to ask again, if nothing happens before
    };
    /// @param moving    the camera moves by itself, or under a hand
    /// @param occlusion share of the ambient occlusion that is done
    Next next(double now, bool moving, double occlusion) const;
    /// Tells what was drawn.
    /// @param deviceSeconds  that the device took for a frame lately; 0: nobody knows
    void shown(const Next& frame, double now, bool moving, double occlusion, double deviceSeconds = 0);
    /// That a pixel of a picture at rest gets, one a frame.
    void setSamples(std::uint32_t samples) { samples_ = samples; }
    const MotionFrames& motionFrames() const { return motion_; }
    /// Seconds from one picture of the display to the next, a thousandth to one; others are not taken.
    void setDisplayInterval(double seconds);
    double displayInterval() const { return interval_; }
    /// Seconds that a frame of a motion may take at full resolution, where that is more than the display's interval.
    void setLongestFrame(double seconds) { longest_ = seconds; }
    void setMeshes(bool meshes) { resolution_.setMeshes(meshes); }
    /// As ResolutionControl's.
    void setHeat(double heat) { resolution_.setHeat(heat); }
    void setLeastScale(double scale) { resolution_.setLeastScale(scale); }

private:
    ResolutionControl resolution_;
    MotionFrames motion_;
    bool visible_ = true, pictureChanged_ = true, overlayChanged_ = false, wasMoving_ = false;
    std::uint32_t samples_ = 16, refined_ = 0;  // of the picture at rest: in all, and drawn so far
    double lastChange_ = 0, lastFrame_ = 0, shownOcclusion_ = -1;
    double interval_ = 1.0 / 60, longest_ = 0;
};

}  // namespace nacre::app
