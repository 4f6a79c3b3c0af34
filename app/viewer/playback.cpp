#include "app/viewer/playback.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "app/input/read_input.h"
#include "engine/error.h"
#include "engine/molecule/trajectory/morph.h"

namespace nacre::app {
namespace {

constexpr double kNotAgain = std::numeric_limits<double>::infinity();
constexpr std::size_t kMorphFrames = 30;  // from model to model

}  // namespace

Playback::Playback(Stage& stage, Frames& frames, Reading& reading, std::function<void(double now)> moved,
                   std::function<void()> wake)
    : stage_(stage), frames_(frames), reading_(reading), moved_(std::move(moved)), wake_(std::move(wake)) {}

std::size_t Playback::models() const {
    if (!stage_.shown()) return 0;
    if (stage_.document.molecule->modelsAreInputs) return 1;
    const FileSummary& file = stage_.document.molecule->file;
    return static_cast<std::size_t>(std::max(file.models.value_or(1), file.records.value_or(1)));
}

bool Playback::hasTrajectory() const {
    const PictureDescription& view = stage_.view();
    return player_ && !view.input.trajectory.path.empty();
}

void Playback::arrived(const Reading::Arrival& arrival) {
    Document& document = stage_.document;
    const PictureDescription& view = document.view;
    const std::size_t model = static_cast<std::size_t>(std::max(view.input.model, 1)) - 1;
    if (arrival.another && !arrival.step) stop();
    if (arrival.another) morphs_ = false, readModel_ = std::max(view.input.model, 1);
    if (morphs_ && !document.moves()) {
        const auto shown = static_cast<std::size_t>(std::lround(place()));
        makePlayer(false);
        clock_.goTo(shown);
    }
    if (document.motion) {
        player_ = std::make_unique<Player>(document.molecule, std::exchange(document.motion, nullptr), wake_);
        const bool trajectory = !view.input.trajectory.path.empty();
        const auto first = static_cast<std::size_t>(view.input.trajectory.frame - 1);
        if (!arrival.step)
            clock_.begin(player_->frames(), 0, trajectory ? PlayClock::kTrajectoryRate : PlayClock::kModelRate);
        clock_.goTo(std::min(trajectory ? first : model, player_->frames() - 1));
    } else if (arrival.another) {
        player_.reset();
        if (!arrival.step) clock_.begin(models(), model, PlayClock::kModelRate);
        clock_.goTo(model);
    }
    waiting_.reset();
    if (!player_) return;
    clock_.setFrames(document.moves() ? player_->frames() : hasTrajectory() ? 1 : models());
    player_->setScene(document.drawing.moving());
    if (document.moves()) player_->want(clock_.frame());
}

void Playback::show(std::size_t frame, double now) {
    if (clock_.frames() < 2) return;
    if (!playing()) stage_.remember();
    clock_.goTo(std::min(frame, clock_.frames() - 1));
    waiting_.reset();
    request(clock_.frame(), now);
}

void Playback::request(std::size_t frame, double now) {
    if (canLay()) return player_->want(frame);
    clock_.goTo(frame);
    reading_.readModel(static_cast<int>(frame + 1));
    stage_.messages.say("model " + std::to_string(frame + 1) + " of " + std::to_string(models()), now);
}

std::size_t Playback::framesPerModel() const { return morphs_ ? kMorphFrames : 1; }

/// Steps from an interpolated frame to the next model.
void Playback::step(int step, double now) {
    stop();
    if (clock_.frames() < 2) return stage_.messages.say("it has only one model", now);
    const auto count = static_cast<int>((clock_.frames() - 1) / framesPerModel() + 1);
    const bool all = stage_.view().input.model == kAllModels;
    const int from = static_cast<int>(step > 0 ? std::floor(place()) : std::ceil(place()));
    show(all ? 0 : static_cast<std::size_t>((from + count + step) % count) * framesPerModel(), now);
}

/// @throws Error
void Playback::makePlayer(bool morphs) {
    const Document& document = stage_.document;
    const std::shared_ptr<const Molecule>& molecule = document.molecule;
    std::vector<double> places;
    for (std::size_t i = 0; i <= (models() - 1) * kMorphFrames; ++i)
        places.push_back(static_cast<double>(i) / static_cast<double>(kMorphFrames));
    std::unique_ptr<Trajectory> frames =
        morphs ? morphOfModels(molecule, readModel_, std::move(places), false, document.view.input.path)
               : trajectoryOfModels(molecule, readModel_);
    const TrajectoryOptions& laid = document.view.input.trajectory;
    player_ = std::make_unique<Player>(
        molecule, std::make_shared<Motion>(std::move(frames), *molecule, motionOptions(laid, *molecule)), wake_);
    morphs_ = morphs;
    waiting_.reset();
}

void Playback::setMorph(bool morphs, double now) {
    if (morphs == morphs_ || !canMorph()) return;
    const auto model = static_cast<std::size_t>(std::lround(place()));
    const bool wasPlaying = playing();
    try {
        makePlayer(morphs);
    } catch (const Error& error) {
        return stage_.messages.say(error.what(), now);
    }
    clock_.begin(player_->frames(), model * framesPerModel(),
                 morphs ? PlayClock::kTrajectoryRate : PlayClock::kModelRate);
    player_->setScene(stage_.document.drawing.moving());
    player_->want(clock_.frame());
    if (wasPlaying) clock_.play(now);
    stage_.changed(now);
}

void Playback::play(double now) {
    if (clock_.frames() < 2) return stage_.messages.say("it has only one model", now);
    stage_.remember();
    clock_.play(now);
    if (const auto next = clock_.next(); next && player_) request(*next, now);
    stage_.changed(now);
}

void Playback::setRate(double rate) {
    clock_.setRate(rate);
    stage_.schedule.overlayChanged();
}

void Playback::stepRate(int way, double now) {
    clock_.stepRate(way);
    stage_.messages.say(rateText(clock_.rate()), now);
}

void Playback::setOrder(PlayOrder order) {
    clock_.setOrder(order);
    stage_.schedule.overlayChanged();
}

void Playback::setMotion(const TrajectoryOptions& options, double now) {
    if (!canLay()) return;
    stage_.remember();
    try {
        lay(options);
        player_->want(clock_.frame());
    } catch (const Error& error) {
        stage_.messages.say(error.what(), now);
    }
}

/// @throws Error if too few atoms are fitted
void Playback::lay(const TrajectoryOptions& options) {
    Document& document = stage_.document;
    TrajectoryOptions& laid = document.view.input.trajectory;
    if (laid.whole != options.whole || laid.fit != options.fit || laid.smooth != options.smooth) {
        player_->setMotion(motionOptions(options, *document.molecule));
        waiting_.reset();
    }
    PictureDescription& view = stage_.wanted();
    for (TrajectoryOptions* to : {&view.input.trajectory, &laid}) {
        to->whole = options.whole;
        to->fit = options.fit;
        to->smooth = options.smooth;
    }
}

void Playback::restore(const PictureDescription& view) {
    lay(view.input.trajectory);
    const std::int64_t number = hasTrajectory() ? view.input.trajectory.frame : view.input.model;
    const std::size_t frame = static_cast<std::size_t>(std::max<std::int64_t>(number, 1) - 1) * framesPerModel();
    // An interpolated frame counts as the nearest model.
    if (std::lround(place()) != number - 1) clock_.goTo(std::min(frame, clock_.frames() - 1));
    player_->want(clock_.frame());
}

double Playback::advance(double now) {
    if (!stage_.shown()) return kNotAgain;
    if (!canLay()) return readNext(now);
    try {
        if (!waiting_) waiting_ = player_->take();
    } catch (const std::exception& error) {
        stop();
        stage_.messages.fail(error.what(), now);
    }
    if (!waiting_) return kNotAgain;  // the player will wake it
    if (playing() && now < clock_.due()) return clock_.due();
    put(now);
    if (!playing()) return kNotAgain;
    if (const auto next = clock_.next())
        player_->want(*next);
    else
        stop();
    return kNotAgain;
}

/// Reads the next model, if models are read one by one.
double Playback::readNext(double now) {
    if (!playing() || reading_.loader().busy()) return kNotAgain;
    if (now < clock_.due()) return clock_.due();
    const auto next = stage_.view().input.model == kAllModels ? 0 : clock_.next();
    if (!next) return stop(), kNotAgain;
    clock_.shown(*next, now);
    request(*next, now);
    return kNotAgain;
}

/// Shows the waiting frame.
void Playback::put(double now) {
    PlayedFrame played = *std::exchange(waiting_, std::nullopt);
    try {
        if (!frames_.moveScene(played.scene)) stop();
    } catch (const Error& error) {
        stop();
        return stage_.messages.fail(error.what(), now);
    }
    if (playing())
        clock_.shown(played.frame, now);
    else
        clock_.goTo(played.frame);
    Document& document = stage_.document;
    PictureDescription& view = stage_.wanted();
    document.drawing.takeMoved(*played.molecule, std::move(played.scene));
    document.placed = std::move(played.molecule);
    frameTime_ = played.time;
    frameRmsd_ = played.rmsd;
    const int number = static_cast<int>(std::lround(place())) + 1;
    if (hasTrajectory())
        view.input.trajectory.frame = document.view.input.trajectory.frame = number;
    else
        view.input.model = document.view.input.model = number;
    if (view.occlusion.directions) frames_.restartOcclusion();
    moved_(now);
    stage_.changed(now);
}

}  // namespace nacre::app
