#include "app/viewer/player.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/molecule/text.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr double kRates[] = {0.5, 1, 2, 5, 10, 15, 20, 24, 30, 60, 120};

}  // namespace

Player::Player(std::shared_ptr<const Molecule> molecule, std::shared_ptr<Motion> motion, std::function<void()> wake)
    : molecule_(std::move(molecule)),
      motion_(std::move(motion)),
      frames_(motion_->frames()),
      wake_(std::move(wake)),
      free_(std::make_shared<FreeMolecules>()),
      thread_(startThread([this] { run(); })) {}

Player::~Player() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Player::setScene(std::shared_ptr<MovingPicture> scene) {
    const std::lock_guard lock(mutex_);
    scene_ = std::move(scene);
    ready_.reset();
    changed_.notify_all();
}

void Player::setMotion(MotionOptions options) {
    const std::lock_guard lock(mutex_);
    newMotion_ = std::move(options);
    ready_.reset();
    changed_.notify_all();
}

void Player::want(std::size_t frame) {
    const std::lock_guard lock(mutex_);
    wanted_ = frame;
    ++order_;
    ready_.reset();
    failure_ = nullptr;
    changed_.notify_all();
}

std::optional<PlayedFrame> Player::take() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(ready_, std::nullopt);
}

void Player::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ready_ || failure_ || (!working_ && !(wanted_ && scene_)); });
}

void Player::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ending_ || (wanted_ && scene_); });
        if (ending_) return;
        const std::size_t frame = *std::exchange(wanted_, std::nullopt);
        const std::uint64_t order = order_;
        const std::shared_ptr<MovingPicture> scene = scene_;
        std::optional<MotionOptions> motion = std::exchange(newMotion_, std::nullopt);
        working_ = true;
        lock.unlock();
        std::optional<PlayedFrame> made;
        std::exception_ptr failure;
        try {
            if (motion) motion_->change(std::move(*motion), *molecule_);
            made = make(frame, *scene);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        working_ = false;
        if (order != order_) continue;
        if (scene != scene_ || newMotion_) {  // repeats it with the new settings
            wanted_ = frame;
            continue;
        }
        ready_ = std::move(made);
        failure_ = failure;
        changed_.notify_all();
        if (wake_) wake_();
    }
}

PlayedFrame Player::make(std::size_t frame, MovingPicture& scene) {
    const std::vector<glm::vec3> positions = motion_->positions(frame);
    const std::shared_ptr<Molecule> molecule = freeMolecule();
    for (std::size_t i = 0; i < positions.size(); ++i) molecule->atoms[i].position = positions[i];
    return {frame, molecule, scene.moved(*molecule), motion_->time(), motion_->rmsd()};
}

/// An unused copy of the molecule, without the positions of other models.
std::shared_ptr<Molecule> Player::freeMolecule() {
    const auto shared = [this](std::unique_ptr<Molecule> molecule) {
        return std::shared_ptr<Molecule>(molecule.release(), [free = free_](Molecule* done) {
            std::unique_ptr<Molecule> owned(done);
            const std::lock_guard lock(free->mutex);
            free->molecules.push_back(std::move(owned));
        });
    };
    {
        const std::lock_guard lock(free_->mutex);
        if (!free_->molecules.empty()) {
            std::unique_ptr<Molecule> molecule = std::move(free_->molecules.back());
            free_->molecules.pop_back();
            return shared(std::move(molecule));
        }
    }
    auto copy = std::make_unique<Molecule>();
    const Molecule& m = *molecule_;
    copy->atoms = m.atoms;
    copy->residues = m.residues;
    copy->chains = m.chains;
    copy->subchains = m.subchains;
    copy->bonds = m.bonds;
    copy->entities = m.entities;
    copy->statesSecondaryStructure = m.statesSecondaryStructure;
    copy->partialCharges = m.partialCharges;
    copy->radii = m.radii;
    copy->masses = m.masses;
    copy->displacements = m.displacements;
    copy->types = m.types;
    copy->file = m.file;
    return shared(std::move(copy));
}

void PlayClock::begin(std::size_t frames, std::size_t frame, double rate) {
    const PlayOrder order = order_;
    *this = {};
    order_ = order;
    frames_ = frames;
    frame_ = frame;
    rate_ = rate;
}

void PlayClock::setFrames(std::size_t frames) {
    if (frames == frames_) return;
    frames_ = frames;
    frame_ = std::min(frame_, frames - std::min<std::size_t>(frames, 1));
    playing_ = false;
}

void PlayClock::play(double now) {
    playing_ = frames_ > 1;
    due_ = now;
    if (order_ == PlayOrder::once && frame_ + 1 >= frames_ && playing_) frame_ = frames_ - 1, back_ = true;
}

std::optional<std::size_t> PlayClock::next() const {
    if (frames_ < 2) return std::nullopt;
    const bool last = frame_ + 1 >= frames_;
    switch (order_) {
        case PlayOrder::round:
            return last ? 0 : frame_ + 1;
        case PlayOrder::backAndForth:
            return (back_ && frame_ > 0) || last ? frame_ - 1 : frame_ + 1;
        default:
            if (last && back_) return 0;
            return last ? std::nullopt : std::optional(frame_ + 1);
    }
}

void PlayClock::shown(std::size_t frame, double now) {
    if (order_ == PlayOrder::backAndForth && frame != frame_) back_ = frame < frame_;
    if (order_ == PlayOrder::once) back_ = false;
    frame_ = frame;
    // A late frame does not make the next one come sooner.
    const double interval = 1 / rate_;
    due_ = std::max(due_ + interval, now);
}

std::string rateText(double rate) { return formatted("%g frame%s per second", rate, rate == 1 ? "" : "s"); }

void PlayClock::setRate(double rate) { rate_ = std::clamp(rate, kSlowest, kFastest); }

void PlayClock::stepRate(int way) {
    const auto end = std::end(kRates);
    if (way > 0) {
        const auto faster = std::upper_bound(std::begin(kRates), end, rate_ * 1.001);
        if (faster != end) rate_ = *faster;
    } else {
        const auto slower = std::lower_bound(std::begin(kRates), end, rate_ * 0.999);
        if (slower != std::begin(kRates)) rate_ = *(slower - 1);
    }
}

}  // namespace nacre::app
