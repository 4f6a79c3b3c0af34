// Molecules that move: frames of a trajectory and models of a file, one after the other. Where a player makes them (all
// have the same atoms), they come as fast as they are drawn; other models are read from their file one by one.

#include <algorithm>
#include <limits>
#include <utility>

#include "app/input/trajectory_input.h"
#include "app/viewer/viewer.h"
#include "engine/error.h"

namespace nacre::app {

int Viewer::models() const {
    if (!document_.molecule) return 0;
    if (document_.molecule->modelsAreInputs) return 1;
    const FileSummary& file = document_.molecule->file;
    return static_cast<int>(std::max(file.models.value_or(1), file.records.value_or(1)));
}

bool Viewer::hasTrajectory() const { return player_ && !view_.trajectory.path.empty(); }

/// The document was read, or built anew: what plays it goes with it.
void Viewer::takePlayer(bool another, bool step) {
    const std::size_t models = static_cast<std::size_t>(this->models());
    const std::size_t model = static_cast<std::size_t>(std::max(document_.view.model, 1)) - 1;
    if (document_.motion) {
        player_ = std::make_unique<Player>(document_.molecule, std::exchange(document_.motion, nullptr), wake_);
        const bool trajectory = !document_.view.trajectory.path.empty();
        const auto first = static_cast<std::size_t>(document_.view.trajectory.frame - 1);
        if (!step) playback_.begin(player_->frames(), 0, trajectory ? Playback::kTrajectoryRate : Playback::kModelRate);
        playback_.goTo(std::min(trajectory ? first : model, player_->frames() - 1));
    } else if (another) {
        player_.reset();
        if (!step) playback_.begin(models, model, Playback::kModelRate);
        playback_.goTo(model);
    }
    waiting_.reset();
    if (!player_) return;
    playback_.setFrames(document_.moves() ? player_->frames() : hasTrajectory() ? 1 : models);
    player_->setScene(document_.moving);
    if (document_.moves()) player_->want(playback_.frame());
}

void Viewer::showFrame(std::size_t frame, double now) {
    if (playback_.frames() < 2) return;
    if (!playback_.playing()) remember();
    playback_.goTo(std::min(frame, playback_.frames() - 1));
    waiting_.reset();
    request(playback_.frame(), now);
}

void Viewer::request(std::size_t frame, double now) {
    if (player_ && document_.moves()) return player_->want(frame);
    playback_.goTo(frame);
    SavedView next = view();
    next.model = static_cast<int>(frame + 1);
    loader_.read(next);
    say("model " + std::to_string(frame + 1) + " of " + std::to_string(models()), now);
}

void Viewer::stepFrame(int step, double now) {
    playback_.stop();
    const std::size_t frames = playback_.frames();
    if (frames < 2) return say("it has one model alone", now);
    const bool all = view_.model == kAllModels;
    showFrame(all ? 0 : (playback_.frame() + frames + static_cast<std::size_t>(step)) % frames, now);
}

void Viewer::setPlaying(bool playing, double now) {
    if (!playing) return playback_.stop();
    if (playback_.frames() < 2) return say("it has one model alone", now);
    remember();
    playback_.play(now);
    if (const auto next = playback_.next(); next && player_) request(*next, now);
    changed(now);
}

void Viewer::setRate(double rate) {
    playback_.setRate(rate);
    schedule_.overlayChanged();
}

void Viewer::setOrder(PlayOrder order) {
    playback_.setOrder(order);
    schedule_.overlayChanged();
}

void Viewer::setMotion(const TrajectoryOptions& options, double now) {
    if (!canLay()) return;
    remember();
    unremembered_ = true;
    try {
        setLaying(options);
        player_->want(playback_.frame());
    } catch (const Error& error) {
        say(error.what(), now);
    }
}

/// @throws Error if too few atoms are fitted
void Viewer::setLaying(const TrajectoryOptions& options) {
    TrajectoryOptions& own = view_.trajectory;
    TrajectoryOptions& laid = document_.view.trajectory;
    if (laid.whole != options.whole || laid.fit != options.fit || laid.smooth != options.smooth) {
        player_->setMotion(motionOptions(options, *document_.molecule));
        waiting_.reset();
    }
    own.whole = laid.whole = options.whole;
    own.fit = laid.fit = options.fit;
    own.smooth = laid.smooth = options.smooth;
}

/// Shows what is due of what is played. @returns when to look again
double Viewer::play(double now) {
    constexpr double kNotAgain = std::numeric_limits<double>::infinity();
    if (!document()) return kNotAgain;
    if (!player_ || !document_.moves()) {
        if (!playback_.playing() || loader_.busy()) return kNotAgain;
        if (now < playback_.due()) return playback_.due();
        const auto next = view_.model == kAllModels ? 0 : playback_.next();
        if (!next) return playback_.stop(), kNotAgain;
        playback_.shown(*next, now);
        request(*next, now);
        return kNotAgain;
    }
    try {
        if (!waiting_) waiting_ = player_->take();
    } catch (const std::exception& error) {
        playback_.stop();
        fail(error.what(), now);
    }
    if (!waiting_) return kNotAgain;  // the player wakes
    if (playback_.playing() && now < playback_.due()) return playback_.due();
    showPlayed(now);
    if (!playback_.playing()) return kNotAgain;
    const auto next = playback_.next();
    if (!next) return playback_.stop(), kNotAgain;
    player_->want(*next);
    return kNotAgain;
}

/// Puts the frame that waits on the screen.
void Viewer::showPlayed(double now) {
    PlayedFrame played = *std::exchange(waiting_, std::nullopt);
    try {
        if (sceneThere_) screen_.moveScene(played.scene);
    } catch (const Error& error) {
        playback_.stop();
        if (!noticeLoss()) return fail(error.what(), now);
        sceneThere_ = false;
    }
    if (playback_.playing())
        playback_.shown(played.frame, now);
    else
        playback_.goTo(played.frame);
    document_.placed = std::move(played.molecule);
    document_.scene = std::move(played.scene);
    frameTime_ = played.time;
    frameRmsd_ = played.rmsd;
    const int number = static_cast<int>(played.frame + 1);
    if (hasTrajectory())
        view_.trajectory.frame = document_.view.trajectory.frame = number;
    else
        view_.model = document_.view.model = number;
    if (view_.occlusionDirections) occlusion_ = 0;
    if (!view_.words.labels.empty() || !view_.words.measures.empty()) putWords(now);
    placeSelection();
    changed(now);
}

}  // namespace nacre::app
