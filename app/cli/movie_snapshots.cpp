#include "app/cli/movie_snapshots.h"

#include <algorithm>
#include <cmath>

#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/files/messages.h"
#include "app/input/input_files.h"
#include "app/movie/movie_file.h"
#include "app/mvs/scene_file.h"
#include "engine/error.h"

namespace nacre::app {

SnapshotTimeline::SnapshotTimeline(std::vector<SnapshotTimes> times, bool loop) : times_(std::move(times)) {
    const bool silent = std::all_of(times_.begin(), times_.end(), [](const SnapshotTimes& t) { return t.linger == 0; });
    if (silent)
        for (SnapshotTimes& each : times_) each.linger = kLinger;
    if (!loop) times_.back().transition = 0;
    for (const SnapshotTimes& each : times_) seconds_ += each.linger + each.transition;
}

SnapshotPlace SnapshotTimeline::at(double time) const {
    constexpr double kRounding = 1e-7;  // s: a frame at the end of a snapshot's time is the next one's
    for (std::size_t i = 0; i < times_.size(); ++i) {
        const SnapshotTimes& each = times_[i];
        if (time < each.linger - kRounding) return {i, 0};
        time -= each.linger;
        if (time < each.transition - kRounding) return {i, time > kRounding ? time / each.transition : 0};
        time -= each.transition;
    }
    return {times_.size() - 1, 0};
}

bool showsSnapshots(const MovieOptions& options) {
    if (options.picture.input.snapshot == kAllSnapshots) return true;
    const bool moves =
        options.spin || options.rock || options.sweep || options.models != MovieModels::one || !options.views.empty();
    return !moves && !isGiven(options, "snapshot") && mvs::isSceneFile(filePathOf(options.picture.input));
}

MovieSnapshots::MovieSnapshots(const MovieOptions& options, Progress& progress)
    : options_(options),
      progress_(progress),
      scene_(options.picture.input),
      timeline_(scene_.times(), options.loop),
      shots_(timeline_.count()) {
    const std::string& path = options.picture.input.path;
    if (timeline_.count() == 1)
        throw Error("no motion given", path, "the scene has one snapshot: add --spin or --rock");
    const double seconds = options.seconds.value_or(timeline_.seconds());
    const double frames = std::max(std::round(seconds * options.framesPerSecond), 1.0);
    if (frames > static_cast<double>(kMostMovieFrames))
        throw Error("movie too long", path, "more than " + std::to_string(kMostMovieFrames) + " frames");
    frames_ = static_cast<std::uint64_t>(frames);
    // Another duration stretches all times.
    secondsPerFrame_ = timeline_.seconds() / seconds / options.framesPerSecond;
    loadMaps(options.picture, downloadProgress(progress_));
}

SnapshotPlace MovieSnapshots::placeOf(std::uint64_t frame) const {
    return timeline_.at(static_cast<double>(frame) * secondsPerFrame_);
}

std::optional<int> MovieSnapshots::modelOf(std::uint64_t frame) const {
    return static_cast<int>(placeOf(frame).from) + 1;
}

MovieSnapshots::Shot& MovieSnapshots::ready(std::size_t number) {
    std::unique_ptr<Shot>& shot = shots_[number];
    if (shot) return *shot;
    PictureDescription picture = options_.picture;
    picture.input.snapshot = static_cast<int>(number) + 1;
    auto made = std::make_unique<Shot>();
    made->molecule = loadSnapshot(scene_, picture.input, downloadProgress(progress_));
    made->drawing.prepare(made->molecule, picture);
    for (const std::string& warning : made->drawing.warnings)
        sayWarning("snapshot " + std::to_string(number + 1) + ": " + warning);
    made->drawing.settings.occlusion.onProgress = [this](double share) {
        if (onBake) onBake(share);
    };
    made->lens = lensOf(made->drawing.settings.view, made->drawing.run.center);
    made->canvas = std::make_unique<Canvas>(picture.device);
    made->drawing.handOver(*made->canvas);
    shot = std::move(made);
    return *shot;
}

/// A snapshot's picture. @param lens  null: its own
Picture MovieSnapshots::drawFrom(std::size_t number, const Lens* lens) {
    Shot& shot = ready(number);
    RenderSettings settings = shot.drawing.settings;
    if (lens) settings.view = viewThrough(*lens, settings.view, shot.drawing.run.center);
    return shot.drawing.drawAs(settings, shot.canvas->renderer);
}

Picture MovieSnapshots::draw(std::uint64_t frame) {
    const SnapshotPlace place = placeOf(frame);
    const std::size_t to = (place.from + 1) % shots_.size();
    for (std::size_t i = 0; i < shots_.size(); ++i)
        if (i != place.from && i != to) shots_[i].reset();
    if (place.share == 0) return drawFrom(place.from, nullptr);
    const double share = eased(options_.easing.value_or(Easing::smooth), place.share);
    const std::vector<Lens> lenses{ready(place.from).lens, ready(to).lens};
    if (lenses[0].projection != lenses[1].projection) return drawFrom(share < 0.5 ? place.from : to, nullptr);
    const Lens lens = CameraPath(lenses, false).at(share);
    Picture picture = drawFrom(place.from, &lens);
    return mixed(std::move(picture), drawFrom(to, &lens), static_cast<float>(share));
}

}  // namespace nacre::app
