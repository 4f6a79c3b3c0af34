#include "app/cli/commands.h"
#include "app/cli/movie_options.h"
#include "app/cli/movie_scenes.h"
#include "app/cli/movie_snapshots.h"
#include "app/cli/progress.h"
#include "app/movie/stop_request.h"
#include "app/movie/write_movie.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

[[noreturn]] void stopped(const std::string& path, std::uint64_t frames, std::uint64_t all) {
    throw Error("stopped", path,
                frames == 0 ? "before the first frame: nothing is written"
                            : std::to_string(frames) + " of " + std::to_string(all) + " frames are in it");
}

}  // namespace

void movieCommand(const MovieOptions& options) {
    const std::string& path = options.picture.output;
    Progress progress;
    // Opens the file, or the program that writes it, before any work; only the number of frames is unknown.
    MovieShape shape{options.picture.size, options.framesPerSecond, isTransparent(options), 1};
    const bool snapshots = showsSnapshots(options);
    if (options.views.empty() && !snapshots) shape.frames = countFrames(options, 1);
    MovieReport report(options.report);
    const std::unique_ptr<MovieFile> file = makeMovieFile(path, shape);
    StopRequest stop;  // from here on; a second signal removes unfinished files as usual

    std::unique_ptr<MovieSource> source;
    if (snapshots)
        source = std::make_unique<MovieSnapshots>(options, progress);
    else
        source = std::make_unique<MovieScenes>(options, progress);
    MovieSource& scenes = *source;
    const std::uint64_t frames = scenes.frames();
    progress.begin(options.picture.occlusion.directions ? "ambient occlusion" : "drawing");
    scenes.onBake = [&](double share) {
        if (stop.asked()) stopped(path, 0, frames);
        progress.advance(share);
        report.baked(share);
    };
    const auto goesOn = [&](MovieStage stage, std::uint64_t drawn) {
        if (stage == MovieStage::writing) progress.begin("writing");
        if (stage != MovieStage::frames) return !stop.asked();
        if (drawn == 0) {
            scenes.onBake = {};
            progress.begin("drawing frames");
        } else {
            progress.advanceTo(drawn, frames);
            report.drawn(drawn, frames, scenes.shownModel(drawn - 1));
        }
        return !stop.asked();
    };
    const std::uint64_t drawn =
        writeMovie(*file, {frames, [&](std::uint64_t frame) { return scenes.draw(frame); }, goesOn});
    if (drawn == 0) stopped(path, 0, frames);
    stop.leave();
    if (drawn < frames) stopped(path, drawn, frames);
}

}  // namespace nacre::app
