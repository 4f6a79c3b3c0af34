#pragma once
// Prepares frames of moving atoms on a worker thread: reads positions, fits them and builds streams while the window
// draws the previous frame. The timing of frames and models is pure arithmetic, without a clock.

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/drawing/moving_picture.h"
#include "engine/molecule/trajectory/motion.h"

namespace nacre::app {

/// A frame ready to be shown.
struct PlayedFrame {
    std::size_t frame = 0;  ///< from 0
    std::shared_ptr<const Molecule> molecule;
    Representation scene;
    std::optional<double> time;  ///< ps
    double rmsd = 0;             ///< of the fitted atoms, Å
};

class Player {
public:
    /// @param wake  called on the player's thread when a frame is ready or failed
    Player(std::shared_ptr<const Molecule> molecule, std::shared_ptr<Motion> motion, std::function<void()> wake);
    ~Player();
    Player(const Player&) = delete;

    std::size_t frames() const { return frames_; }
    /// Sets the scene for the next frames. @param scene  exclusively owned from now on; null: none
    void setScene(std::shared_ptr<MovingPicture> scene);
    /// Sets the processing of the next frames.
    void setMotion(MotionOptions options);
    /// Requests a frame; drops an earlier unfinished request.
    void want(std::size_t frame);
    /// The requested frame when it is ready. @throws Error if it could not be made
    std::optional<PlayedFrame> take();
    /// Waits until take() has something, if a frame was requested.
    void wait();

private:
    void run();
    PlayedFrame make(std::size_t frame, MovingPicture& scene);
    std::shared_ptr<Molecule> freeMolecule();

    /// Unused copies of the molecule. Holders return theirs here, from any thread.
    struct FreeMolecules {
        std::mutex mutex;
        std::vector<std::unique_ptr<Molecule>> molecules;
    };

    std::shared_ptr<const Molecule> molecule_;
    std::shared_ptr<Motion> motion_;  // the thread's
    std::size_t frames_;
    std::function<void()> wake_;
    std::shared_ptr<FreeMolecules> free_;
    std::mutex mutex_;  // guards the following
    std::condition_variable changed_;
    std::shared_ptr<MovingPicture> scene_;
    std::optional<MotionOptions> newMotion_;
    std::optional<std::size_t> wanted_;
    std::uint64_t order_ = 0;  // number of the request: results of older ones are dropped
    bool working_ = false, ending_ = false;
    std::optional<PlayedFrame> ready_;
    std::exception_ptr failure_;
    std::thread thread_;
};

enum class PlayOrder {
    round,         ///< the first follows the last
    backAndForth,  ///< reverses after the last
    once,          ///< stops at the last
};

/// Timing of trajectory frames and models.
class PlayClock {
public:
    static constexpr double kModelRate = 10, kTrajectoryRate = 30;  ///< initial frames per second
    static constexpr double kSlowest = 0.5, kFastest = 120;

    /// Starts with another molecule, stopped. @param frames  0: none  @param frame  from 0
    void begin(std::size_t frames, std::size_t frame, double rate);
    /// Changes the number of frames of the same molecule, for example to none while it has copies.
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
    /// Changes to the next of some usual rates. @param way  1: faster, -1: slower
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
