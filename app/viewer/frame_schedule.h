#pragma once
// Decides when to draw, and what, to save energy. Moving pictures are drawn at the display's rate, at a resolution that
// keeps up; still ones are refined sample by sample; then nothing is drawn.

#include <cstdint>
#include <limits>

namespace nacre::app {

/// Frames during motion.
struct MotionFrames {
    std::uint64_t frames = 0, reduced = 0;  ///< all, and those below the window's resolution
    double smallestScale = 1;               ///< of any frame
};

/// Reduces quality of a moving picture to keep up: first details finer than visible in motion, then resolution, each by
/// the smallest step.
class ResolutionControl {
public:
    static constexpr int kPatience = 4;     ///< consecutive slow frames before the resolution drops
    static constexpr int kConfidence = 30;  ///< consecutive fast frames before it rises
    static constexpr int kInFlight = 2;     ///< frames after a change that still have the old resolution

    double scale() const;
    /// See WindowFrame::meshError.
    double meshError() const;
    /// Whether meshes are visible: coarser ones are an extra step.
    void setMeshes(bool meshes) { meshes_ = meshes; }
    /// Minimum of the resolution, as a fraction of the window's.
    void setLeastScale(double scale) { leastScale_ = scale; }
    /// Thermal state: 0 cold, 1 throttling. From kWarm on motion uses fewer pixels to avoid throttling, down to
    /// kHotScale of the window's resolution.
    void setHeat(double heat) { heat_ = heat; }
    static constexpr double kWarm = 0.8, kHotScale = 0.55;
    /// @param seconds   between two frames of a motion
    /// @param device    GPU time of a frame; 0: unknown
    /// @param longest   allowed frame time: the display's interval, or more
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
    refine,  ///< adds one sample per pixel, and keeps the picture
    keep,    ///< shows the refined picture again, under another overlay
};

class FrameSchedule {
public:
    static constexpr double kSettleSeconds = 0.15;  ///< from the last change to the refinement
    static constexpr double kBakeSeconds = 0.001;   ///< between two checks of the bake on the device

    void pictureChanged(double now);
    void overlayChanged() { overlayChanged_ = true; }
    /// The window lost its contents, or has another size.
    void windowChanged(double now);
    void setVisible(bool visible) { visible_ = visible; }
    bool visible() const { return visible_; }

    struct Next {
        Draw draw = Draw::nothing;
        double scale = 1, meshError = 2;
        std::uint32_t sample = 0;                               ///< for `refine`: its index
        double wake = std::numeric_limits<double>::infinity();  ///< when to call again without further events
    };
    /// @param moving    the camera moves by itself or is dragged
    /// @param occlusion finished share of the ambient occlusion
    Next next(double now, bool moving, double occlusion) const;
    /// Reports a drawn frame. @param deviceSeconds  recent GPU time per frame; 0: unknown
    void shown(const Next& frame, double now, bool moving, double occlusion, double deviceSeconds = 0);
    /// Samples per pixel of a still picture, one per frame.
    void setSamples(std::uint32_t samples) { samples_ = samples; }
    const MotionFrames& motionFrames() const { return motion_; }
    /// The display's frame interval, 0.001 to 1 s; other values are ignored.
    void setDisplayInterval(double seconds);
    double displayInterval() const { return interval_; }
    /// Allowed time of a frame during motion at full resolution, if longer than the display's interval.
    void setLongestFrame(double seconds) { longest_ = seconds; }
    void setMeshes(bool meshes) { resolution_.setMeshes(meshes); }
    /// See ResolutionControl.
    void setHeat(double heat) { resolution_.setHeat(heat); }
    void setLeastScale(double scale) { resolution_.setLeastScale(scale); }

private:
    ResolutionControl resolution_;
    MotionFrames motion_;
    bool visible_ = true, pictureChanged_ = true, overlayChanged_ = false, wasMoving_ = false;
    std::uint32_t samples_ = 16, refined_ = 0;  // of the still picture: in total, and drawn so far
    double lastChange_ = 0, lastFrame_ = 0, shownOcclusion_ = -1;
    double interval_ = 1.0 / 60, longest_ = 0;
};

}  // namespace nacre::app
