#include "app/cli/commands.h"
#include "app/cli/movie_options.h"
#include "app/cli/movie_scenes.h"
#include "app/cli/movie_snapshots.h"
#include "app/cli/progress.h"
#include "app/movie/movie_encoder.h"
#include "app/movie/stop_request.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr std::uint64_t kSamples = 6;  ///< frames that a palette is made from

[[noreturn]] void stopped(const std::string& path, std::uint64_t frames, std::uint64_t all) {
    throw Error("stopped", path,
                frames == 0 ? "before the first frame: nothing is written"
                            : std::to_string(frames) + " of " + std::to_string(all) + " frames are in it");
}

}  // namespace

void movieCommand(const MovieOptions& options) {
    const std::string& path = options.picture.output;
    Progress progress;
    // The file, or the program that writes it, is there before any work; only how many frames there are is not known.
    MovieShape shape{options.picture.size, options.framesPerSecond, isTransparent(options), 1};
    const bool snapshots = showsSnapshots(options);
    if (options.views.empty() && !snapshots) shape.frames = framesOf(options, 1);
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
    if (file->wantsSamples())
        for (std::uint64_t i = 0; i < std::min(kSamples, frames) && !stop.asked(); ++i)
            file->sample(scenes.draw(i * frames / kSamples));
    scenes.onBake = {};

    std::uint64_t drawn = 0;
    progress.begin("drawing frames");
    {
        MovieEncoder encoder(*file);
        for (; drawn < frames && !stop.asked(); ++drawn) {
            encoder.add(scenes.draw(drawn));
            progress.advanceTo(drawn + 1, frames);
            report.drawn(drawn + 1, frames, scenes.modelOf(drawn));
        }
        if (drawn == 0) stopped(path, 0, frames);
        progress.begin("writing");
        encoder.finish();
    }
    stop.leave();
    if (drawn < frames) stopped(path, drawn, frames);
}

}  // namespace nacre::app
