#pragma once
// Plays trajectory frames or models, or a morph between models. If all have the same atoms, a player prepares them as
// fast as they are drawn; other models are read from their file one by one.

#include <functional>
#include <memory>
#include <optional>

#include "app/viewer/frames.h"
#include "app/viewer/player.h"
#include "app/viewer/reading.h"

namespace nacre::app {

class Playback {
public:
    /// @param moved  called when the document's atoms moved  @param wake  as in Player
    Playback(Stage& stage, Frames& frames, Reading& reading, std::function<void(double now)> moved,
             std::function<void()> wake);

    /// State and rate; frames are counted from 0.
    const PlayClock& clock() const { return clock_; }
    bool playing() const { return clock_.playing(); }
    /// Models of the file; 0 without a file.
    std::size_t models() const;
    /// Whether the frames are a trajectory's, not models of the file.
    bool hasTrajectory() const;
    /// Whether frames can be fitted, smoothed and made whole.
    bool canLay() const { return player_ && stage_.document.moves(); }
    /// Whether interpolated frames between models are possible, and whether they are on.
    bool canMorph() const { return canLay() && !hasTrajectory(); }
    bool morphs() const { return morphs_; }
    void setMorph(bool morphs, double now);
    /// The current model, from 0; for a morph, with a fraction.
    double place() const { return static_cast<double>(clock_.frame()) / static_cast<double>(framesPerModel()); }
    /// For the frame shown: time in ps, if stated; RMSD of fitted atoms to the first frame, Å.
    std::optional<double> frameTime() const { return frameTime_; }
    double frameRmsd() const { return frameRmsd_; }

    void show(std::size_t frame, double now);
    void step(int step, double now);
    void play(double now);
    void stop() { clock_.stop(); }
    void setRate(double framesPerSecond);
    /// Changes to the next of some usual rates. @param way  1: faster, -1: slower
    void stepRate(int way, double now);
    void setOrder(PlayOrder order);
    /// Sets the processing of frames; ignores file and frame of the options.
    void setMotion(const TrajectoryOptions& options, double now);

    /// Call when the document was read or rebuilt, with its player.
    void arrived(const Reading::Arrival& arrival);
    /// Goes to the frame of a view of the same molecules. @throws Error if too few atoms are fitted
    void restore(const PictureDescription& view);
    /// Shows the frame that is due. @returns when to call again; infinity: after a wake-up
    double advance(double now);
    /// Waits for the frame last requested, if any.
    void wait() const {
        if (player_) player_->wait();
    }

private:
    void lay(const TrajectoryOptions& options);
    void makePlayer(bool morphs);
    std::size_t framesPerModel() const;
    void request(std::size_t frame, double now);
    double readNext(double now);
    void put(double now);

    Stage& stage_;
    Frames& frames_;
    Reading& reading_;
    std::function<void(double)> moved_;
    std::function<void()> wake_;
    PlayClock clock_;
    bool morphs_ = false;
    int readModel_ = 1;                   // model of the document's molecule
    std::unique_ptr<Player> player_;      // null: models are read one by one, if there are any
    std::optional<PlayedFrame> waiting_;  // until it is due
    std::optional<double> frameTime_;     // ps
    double frameRmsd_ = 0;
};

}  // namespace nacre::app
