// Checks of movies, windows and sheets that need more than one option.

#include "app/cli/movie_options.h"
#include "app/cli/picture_options.h"
#include "app/drawing/complete.h"
#include "app/files/output_file.h"
#include "app/picture/saved_view.h"

namespace nacre::app {

void checkLooks(const LooksOptions& options) {
    const bool input = !options.picture.input.path.empty(), output = !options.picture.output.empty();
    if (input != output) throw UsageError(input ? "--output is required for a sheet" : "INPUT is required for a sheet");
}

void checkMovie(MovieOptions& options) {
    PictureDescription& picture = options.picture;
    if (!options.views.empty() && !picture.view.empty())
        throw UsageError("--view and --views exclude each other: name it among them");
    if (!options.views.empty() && picture.input.path.empty()) {
        PictureDescription first;
        applySavedView(options.views.front(), first);
        picture.view = first.view;
        const TrajectoryOptions given = picture.input.trajectory;
        picture.input = inputOf(first, picture.input);
        picture.input.namedBy = first.input.namedBy;
        if (!given.path.empty()) picture.input.trajectory = given;
        if (given.frame != 1) picture.input.trajectory.frame = given.frame;
    }
    if (!takeInput(picture)) throw UsageError("INPUT is required: a file, pdb:1BNA, or sample:dna");
    if (!picture.input.further.empty() && options.models) throw UsageError("--models is for one INPUT");
    checkFrames(picture, options.models);
    takeSeveral(picture);
    if (isStandardOutput(picture.output) && isStandardOutput(options.report))
        throw UsageError("--output and --report cannot both be standard output");
    checkMotion(options);
    checkSize(picture, kMostSamplesHeld);
    std::vector<NamedFile> further{{"--report", options.report, true}};
    for (const std::string& view : options.views)
        if (view != picture.view) further.push_back({"--views", view});
    checkFiles(picture, std::move(further));
}

bool checkWindow(PictureDescription& first) {
    checkDebug(first);
    const bool named = takeInput(first);
    takeSeveral(first);
    if (!first.input.further.empty() && !first.input.trajectory.path.empty())
        throw UsageError("a window moves one INPUT: leave out --trajectory, or the others");
    checkFiles(first);
    return named;
}

}  // namespace nacre::app
