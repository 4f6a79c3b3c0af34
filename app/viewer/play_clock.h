#pragma once
// Timing of trajectory frames and models. Pure arithmetic, without a clock.

#include <cstddef>
#include <optional>
#include <string>

namespace nacre::app {

enum class PlayOrder {
    round,         ///< the first follows the last
    backAndForth,  ///< backwards after the last
    once,          ///< stops at the last
};

class PlayClock {
public:
    static constexpr double kModelRate = 10, kTrajectoryRate = 30;  ///< initial frames per second
    static constexpr double kSlowest = 0.5, kFastest = 120;

    /// For another molecule: stopped. @param frames  0: none  @param frame  from 0
    void begin(std::size_t frames, std::size_t frame, double rate);
    /// The same molecule has another number of frames, for example none while it has copies.
    void setFrames(std::size_t frames);
    std::size_t frames() const { return frames_; }
    /// The current frame, from 0.
    std::size_t frame() const { return frame_; }
    void goTo(std::size_t frame) { frame_ = frame; }

    bool playing() const { return playing_; }
    /// Plays from the current frame; from the first after a finished single play.
    void play(double now);
    void stop() { playing_ = false; }
    /// The next frame to play; empty: finished.
    std::optional<std::size_t> next() const;
    /// When it is due.
    double due() const { return due_; }
    /// Reports that a due frame is shown.
    void shown(std::size_t frame, double now);

    double rate() const { return rate_; }
    /// @param rate  frames per second
    void setRate(double rate);
    /// The next of some usual rates. @param way  1: faster, -1: slower
    void stepRate(int way);
    PlayOrder order() const { return order_; }
    void setOrder(PlayOrder order) { order_ = order; }

private:
    std::size_t frames_ = 0, frame_ = 0;
    double rate_ = kModelRate, due_ = 0;
    PlayOrder order_ = PlayOrder::round;
    bool playing_ = false, back_ = false;
};

/// "30 frames per second"
std::string rateText(double rate);

}  // namespace nacre::app
