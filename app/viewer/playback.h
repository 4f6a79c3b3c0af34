#pragma once
// Molecules that move: frames of a trajectory and models of a file, one after the other. Where a player makes them (all
// have the same atoms), they come as fast as they are drawn; other models are read from their file one by one.

#include <functional>
#include <memory>
#include <optional>

#include "app/viewer/frames.h"
#include "app/viewer/play_clock.h"
#include "app/viewer/player.h"
#include "app/viewer/reading.h"

namespace nacre::app {

class Playback {
public:
    /// @param moved  called when the atoms of what is shown have other places  @param wake  as Player's
    Playback(Stage& stage, Frames& frames, Reading& reading, std::function<void(double now)> moved,
             std::function<void()> wake);

    /// What is played, and how fast; frames are counted from 0.
    const PlayClock& clock() const { return clock_; }
    bool playing() const { return clock_.playing(); }
    /// Models of the file; 0 while there is none.
    std::size_t models() const;
    /// The frames are those of a trajectory, not models of the file.
    bool hasTrajectory() const;
    /// Frames can be laid: fitted, smoothed, made whole.
    bool canLay() const { return player_ && stage_.document.moves(); }
    /// Of the frame that is shown: ps, if its file says so; and how far fitted atoms are from the first frame's, Å.
    std::optional<double> frameTime() const { return frameTime_; }
    double frameRmsd() const { return frameRmsd_; }

    void show(std::size_t frame, double now);
    void step(int step, double now);
    void play(double now);
    void stop() { clock_.stop(); }
    void setRate(double framesPerSecond);
    /// The next of some usual rates. @param way  1: faster, -1: slower
    void stepRate(int way, double now);
    void setOrder(PlayOrder order);
    /// How frames are laid; file and frame of the options are not looked at.
    void setMotion(const TrajectoryOptions& options, double now);

    /// The document was read, or built anew: what plays it goes with it.
    void arrived(const Reading::Arrival& arrival);
    /// The frame of a view of the same molecules, laid as it says. @throws Error if too few atoms are fitted
    void restore(const PictureDescription& view);
    /// Shows what is due of what is played. @returns when to look again; infinity: something wakes
    double advance(double now);
    /// Until the frame that was asked for last is ready, if one was.
    void wait() const {
        if (player_) player_->wait();
    }

private:
    void lay(const TrajectoryOptions& options);
    void request(std::size_t frame, double now);
    double readNext(double now);
    void put(double now);

    Stage& stage_;
    Frames& frames_;
    Reading& reading_;
    std::function<void(double)> moved_;
    std::function<void()> wake_;
    PlayClock clock_;
    std::unique_ptr<Player> player_;      // null: models are read one by one, if there are any
    std::optional<PlayedFrame> waiting_;  // until it is due
    std::optional<double> frameTime_;     // ps
    double frameRmsd_ = 0;
};

}  // namespace nacre::app
