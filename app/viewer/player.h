#pragma once
// Makes the frames of a molecule whose atoms move, on a thread of its own: positions are read, laid and turned into
// streams while the window draws the frame before.

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "engine/molecule/trajectory/motion.h"
#include "engine/scene/representation.h"

namespace nacre::app {

/// A frame, ready to be shown.
struct PlayedFrame {
    std::size_t frame = 0;  ///< from 0
    std::shared_ptr<const Molecule> molecule;
    Representation scene;
    std::optional<double> time;  ///< ps
    double rmsd = 0;             ///< of the fitted atoms, Å
};

class Player {
public:
    /// @param wake  called on the player's thread when a frame is ready, or could not be made
    Player(std::shared_ptr<const Molecule> molecule, std::shared_ptr<Motion> motion, std::function<void()> wake);
    ~Player();
    Player(const Player&) = delete;

    std::size_t frames() const { return frames_; }
    /// How the molecule is seen, from the next frame on. @param scene  for this alone from here on; null: not at all
    void setScene(std::shared_ptr<MovingScene> scene);
    /// How frames are laid, from the next one on.
    void setMotion(MotionOptions options);
    /// Begins with a frame; whatever was wanted before and is not ready is forgotten.
    void want(std::size_t frame);
    /// The frame that was wanted, once it is ready. @throws Error why it could not be made
    std::optional<PlayedFrame> take();
    /// Waits until take() has something, if anything is wanted.
    void wait();

private:
    void run();
    PlayedFrame make(std::size_t frame, MovingScene& scene);
    std::shared_ptr<Molecule> freeMolecule();

    /// Copies of the molecule that nobody holds any more. Whoever lets go of one, on whatever thread, puts it here.
    struct FreeMolecules {
        std::mutex mutex;
        std::vector<std::unique_ptr<Molecule>> molecules;
    };

    std::shared_ptr<const Molecule> molecule_;
    std::shared_ptr<Motion> motion_;  // the thread's
    std::size_t frames_;
    std::function<void()> wake_;
    std::shared_ptr<FreeMolecules> free_;
    std::mutex mutex_;  // of all below
    std::condition_variable changed_;
    std::shared_ptr<MovingScene> scene_;
    std::optional<MotionOptions> newMotion_;
    std::optional<std::size_t> wanted_;
    std::uint64_t order_ = 0;  // counts what is wanted: what was made for an older one is dropped
    bool working_ = false, ending_ = false;
    std::optional<PlayedFrame> ready_;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace nacre::app
