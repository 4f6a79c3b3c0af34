#pragma once
// Which frame of a molecule that moves, or which model of its file, is due when. Pure arithmetic; it has no clock.

#include <cstddef>
#include <optional>
#include <string>

namespace nacre::app {

enum class PlayOrder {
    round,     ///< after the last comes the first
    toAndFro,  ///< after the last comes the one before it
    once,      ///< the last stays
};

class PlayClock {
public:
    static constexpr double kModelRate = 10, kTrajectoryRate = 30;  ///< frames a second, at first
    static constexpr double kSlowest = 0.5, kFastest = 120;

    /// Of another molecule: at rest. @param frames  0: none is there  @param frame  from 0
    void begin(std::size_t frames, std::size_t frame, double rate);
    /// The same molecule has another number of frames, as if its copies stand still.
    void setFrames(std::size_t frames);
    std::size_t frames() const { return frames_; }
    /// The one that is asked for, from 0.
    std::size_t frame() const { return frame_; }
    void goTo(std::size_t frame) { frame_ = frame; }

    bool playing() const { return playing_; }
    /// Plays on from where it is; from the first, if it stands at the end of what is played once.
    void play(double now);
    void stop() { playing_ = false; }
    /// The frame after this one, as it is played; none: it has ended.
    std::optional<std::size_t> next() const;
    /// When that is due.
    double due() const { return due_; }
    /// A frame is shown that was due.
    void shown(std::size_t frame, double now);

    double rate() const { return rate_; }
    /// @param rate  frames a second
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

/// "30 frames a second"
std::string rateText(double rate);

}  // namespace nacre::app
