#include "app/cli/movie_snapshots.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/movie/movie_file.h"
#include "app/mvs/animation.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"

namespace nacre::app {

SnapshotTimeline::SnapshotTimeline(std::vector<SnapshotTimes> times, bool loop) : times_(std::move(times)) {
    const bool silent = std::all_of(times_.begin(), times_.end(), [](const SnapshotTimes& t) { return t.linger == 0; });
    if (silent)
        for (SnapshotTimes& each : times_) each.linger = kLinger;
    if (!loop) times_.back().transition = 0;
    for (SnapshotTimes& each : times_) {
        each.linger = silent && each.animation > 0 ? each.animation : std::max(each.linger, each.animation);
        seconds_ += each.linger + each.transition;
    }
}

SnapshotPlace SnapshotTimeline::at(double time) const {
    constexpr double kRounding = 1e-7;  // s: a frame at the end of a snapshot's time belongs to the next one
    for (std::size_t i = 0; i < times_.size(); ++i) {
        const SnapshotTimes& each = times_[i];
        if (time < each.linger - kRounding) return {i, 0, std::max(time, 0.0)};
        time -= each.linger;
        if (time < each.transition - kRounding) return {i, time > kRounding ? time / each.transition : 0, each.linger};
        time -= each.transition;
    }
    return {times_.size() - 1, 0, times_.back().linger};
}

std::optional<double> SnapshotTimeline::animationAt(std::size_t snapshot, double seconds) const {
    const SnapshotTimes& times = times_[snapshot];
    if (!(times.animation > 0)) return std::nullopt;
    return times.loops && seconds > times.animation ? std::fmod(seconds, times.animation)
                                                    : std::min(seconds, times.animation);
}

namespace {

/// The visible radius while the camera leaps: in between it shows both ends, unless they overlap.
double leapRadius(double from, double to, double distance, double share) {
    const double straight = std::lerp(from, to, share);
    const double overlap = (from + to - distance) / std::max(std::min(from, to), 1e-9);
    if (overlap >= 1 || !(distance > std::abs(to - from))) return straight;
    const double top = (distance + from + to) / 2, summit = (distance - from + to) / (2 * distance);
    const double climb = share <= summit ? share / summit : (1 - share) / (1 - summit);
    const double leap = std::lerp(share <= summit ? from : to, top, climb * (3 - climb * climb) / 2);
    return std::lerp(leap, straight, std::max(overlap, 0.0));
}

}  // namespace

Lens lensBetween(const Lens& from, const Lens& to, const std::string& trajectory, double share, double height) {
    Lens lens = CameraPath({from, to}, false).at(share);  // its rotation
    const double a = height / 2 / from.scale, b = height / 2 / to.scale, apart = glm::distance(from.focus, to.focus);
    double along = share, radius = std::lerp(a, b, share);
    if (trajectory.starts_with("leap")) {
        radius = leapRadius(a, b, apart, share);
    } else if (trajectory == "linear-relative" && std::abs(b - a) > 0.001 * (a + b + 2)) {
        // Steps grow with the visible radius plus 1 Å.
        along = (a + 1) / (b - a) * (std::pow((b + 1) / (a + 1), share) - 1);
        radius = std::lerp(a, b, along);
    }
    lens.focus = from.focus + (to.focus - from.focus) * along;
    lens.scale = height / 2 / radius;
    lens.distance = std::lerp(from.distance * from.scale, to.distance * to.scale, share) / lens.scale;
    return lens;
}

bool showsSnapshots(const MovieOptions& options) {
    if (options.picture.input.snapshot == kAllSnapshots) return true;
    const bool moves =
        options.spin || options.rock || options.sweep || options.models != MovieModels::one || !options.views.empty();
    return !moves && !isGiven(options, "snapshot") && mvs::isSceneFile(resolveInputPath(options.picture.input));
}

MovieSnapshots::MovieSnapshots(const MovieOptions& options, Progress& progress)
    : options_(options),
      progress_(progress),
      scene_(options.picture.input),
      timeline_(scene_.times(), options.loop),
      shots_(timeline_.count()) {
    const std::string& path = options.picture.input.path;
    if (timeline_.count() == 1 && !(timeline_.times(0).animation > 0))
        throw Error("no motion given", path, "the scene has one snapshot: add --spin or --rock");
    const double seconds = options.seconds.value_or(timeline_.seconds());
    const double frames = std::max(std::round(seconds * options.framesPerSecond), 1.0);
    if (frames > static_cast<double>(kMostMovieFrames))
        throw Error("movie too long", path, "more than " + std::to_string(kMostMovieFrames) + " frames");
    frames_ = static_cast<std::uint64_t>(frames);
    // An explicit duration stretches all times.
    secondsPerFrame_ = timeline_.seconds() / seconds / options.framesPerSecond;
    loadMaps(options.picture, downloadProgress(progress_));
}

SnapshotPlace MovieSnapshots::findPlace(std::uint64_t frame) const {
    return timeline_.at(static_cast<double>(frame) * secondsPerFrame_);
}

std::optional<int> MovieSnapshots::shownModel(std::uint64_t frame) const {
    return static_cast<int>(findPlace(frame).from) + 1;
}

void MovieSnapshots::load(std::size_t number, std::optional<double> seconds, Shot& shot) {
    PictureDescription picture = options_.picture;
    picture.input.snapshot = static_cast<int>(number) + 1;
    shot.drawing.forget();
    shot.molecule = loadSnapshot(scene_, picture.input, downloadProgress(progress_), seconds);
    shot.drawing.prepare(shot.molecule, picture);
    shot.seconds = seconds;
}

MovieSnapshots::Shot& MovieSnapshots::ready(std::size_t number, double time) {
    const std::optional<double> seconds = timeline_.animationAt(number, time);
    std::unique_ptr<Shot>& shot = shots_[number];
    if (shot && shot->seconds == seconds) return *shot;
    auto made = shot ? std::move(shot) : std::make_unique<Shot>();
    const bool isNew = !made->canvas;
    if (isNew) {
        load(number, std::nullopt, *made);  // its camera stays, unless the animation moves it
        for (const std::string& warning : made->drawing.warnings)
            sayWarning("snapshot " + std::to_string(number + 1) + ": " + warning);
        made->lens = makeLens(made->drawing.settings.view, made->drawing.run.center);
        made->canvas = std::make_unique<Canvas>(options_.picture.device);
    }
    if (made->seconds != seconds) load(number, seconds, *made);
    if (timeline_.times(number).camera) made->lens = makeLens(made->drawing.settings.view, made->drawing.run.center);
    made->drawing.settings.occlusion.onProgress = [this](double share) {
        if (onBake) onBake(share);
    };
    made->drawing.handOver(*made->canvas);
    shot = std::move(made);
    return *shot;
}

/// A snapshot's picture. @param lens  null: its own
Picture MovieSnapshots::drawFrom(std::size_t number, double seconds, const Lens* lens) {
    Shot& shot = ready(number, seconds);
    RenderSettings settings = shot.drawing.settings;
    if (!lens && shot.seconds) lens = &shot.lens;
    if (lens) settings.view = viewThrough(*lens, settings.view, shot.drawing.run.center);
    return shot.drawing.drawAs(settings, shot.canvas->renderer);
}

double MovieSnapshots::easedShare(const SnapshotPlace& place) const {
    const std::string& named = timeline_.times(place.from).easing;
    if (!options_.easing && !named.empty())
        if (const auto share = mvs::easedByName(named, place.share)) return *share;
    return eased(options_.easing.value_or(Easing::smooth), place.share);
}

Picture MovieSnapshots::draw(std::uint64_t frame) {
    const SnapshotPlace place = findPlace(frame);
    const std::size_t to = (place.from + 1) % shots_.size();
    for (std::size_t i = 0; i < shots_.size(); ++i)
        if (i != place.from && i != to) shots_[i].reset();
    if (place.share == 0) return drawFrom(place.from, place.seconds, nullptr);
    const double share = easedShare(place);
    const std::vector<Lens> lenses{ready(place.from, place.seconds).lens, ready(to, 0).lens};
    if (lenses[0].projection != lenses[1].projection)
        return share < 0.5 ? drawFrom(place.from, place.seconds, nullptr) : drawFrom(to, 0, nullptr);
    const std::string& trajectory = timeline_.times(place.from).trajectory;
    const double height = shots_[to]->drawing.settings.view.height;
    const Lens lens = trajectory.empty() ? CameraPath(lenses, false).at(share)
                                         : lensBetween(lenses[0], lenses[1], trajectory, share, height);
    Picture picture = drawFrom(place.from, place.seconds, &lens);
    return mixed(std::move(picture), drawFrom(to, 0, &lens), static_cast<float>(share));
}

}  // namespace nacre::app
