// What no option of a picture alone can tell.

#include <algorithm>
#include <iterator>

#include "app/cli/movie_options.h"
#include "app/cli/paper_options.h"
#include "app/cli/picture_options.h"
#include "app/files/output_file.h"
#include "app/images/image_file.h"
#include "app/input/input_files.h"
#include "app/movie/movie_file.h"
#include "app/picture/input_names.h"

namespace nacre::app {
namespace {

/// INPUT, or the one of the saved view. @returns whether there is one
bool takeInput(RenderOptions& options) {
    options.input.alone = options.look.ownFrame;
    if (!options.input.path.empty()) return true;
    options.input.path = options.savedInput.path;
    options.input.format = options.savedInput.format;
    options.input.model = options.savedInput.model;
    options.input.hash = options.savedInput.hash;
    options.input.name = options.savedInput.name;
    options.input.further = options.savedInput.further;
    std::vector<FitOptions>& fits = options.input.fits;
    fits.insert(fits.begin(), options.savedInput.fits.begin(), options.savedInput.fits.end());
    if (options.input.path.empty()) return false;
    options.input.namedBy = options.view;
    if (options.input.trajectory.path.empty() && !options.savedInput.trajectory.path.empty()) {
        const std::int64_t frame = options.input.trajectory.frame;
        options.input.trajectory = options.savedInput.trajectory;
        options.input.trajectory.path = trajectoryPathOf(options.input);
        options.input.trajectory.namedBy = options.view;
        if (frame != 1) options.input.trajectory.frame = frame;
    }
    return !options.input.path.empty();
}

/// What names of several INPUTs mean, and that options fit them. @throws UsageError
void checkSeveral(RenderOptions& options) {
    InputOptions& input = options.input;
    if (input.further.empty()) {
        if (!input.fits.empty()) throw UsageError("--fit lays one INPUT onto another: name two");
        return;
    }
    if (!options.look.assembly.empty()) throw UsageError("--assembly is for one INPUT");
    const auto standardInputs = std::count_if(input.further.begin(), input.further.end(),
                                              [](const FurtherInput& further) { return further.path == "-"; });
    if (standardInputs + (input.path == "-" ? 1 : 0) > 1) throw UsageError("standard input is one INPUT alone");
    const std::vector<std::string> names = inputNames(input);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const std::string& given = i == 0 ? input.name : input.further[i - 1].name;
            !given.empty() && given != names[i])
            throw UsageError("two INPUTs have the name '" + given + "'");
    for (FitOptions& fit : input.fits) {
        nameInputs(names, fit.moving);
        nameInputs(names, fit.fixed);
    }
    nameInputs(options);
}

void checkInputs(RenderOptions& options, bool throughModels = false) {
    const TrajectoryOptions& frames = options.input.trajectory;
    if (frames.path.empty() && (frames.frame != 1 || frames.whole))
        throw UsageError("--frame and --whole are for the frames of --trajectory");
    if (frames.path.empty() && !throughModels && (frames.fit || frames.smooth != 1))
        throw UsageError(
            "--fit-frames and --smooth are for the frames of --trajectory, or of a movie through --models");
    checkSeveral(options);
}

void checkDebug(const RenderOptions& options) {
    const std::string view = debugViewNames()[static_cast<std::size_t>(options.debug)];
    if (needsOcclusion(options.debug) && options.occlusion.directions == 0)
        throw UsageError("--debug " + view + " shows nothing with --occlusion off");
    if (options.debug != DebugView::none && options.supersample > 1)
        throw UsageError("--debug " + view + " takes one sample a pixel: leave out --supersample");
}

/// @param further  files that not every command has
void checkFiles(const RenderOptions& options, std::vector<NamedFile> further = {}) {
    std::vector<NamedFile> files{{"INPUT", filePathOf(options.input)}, {"--view", options.view},
                                 {"--output", options.output, true},   {"--layers", options.layers, true},
                                 {"--stats", options.stats, true},     {"--capture", options.capture, true}};
    files.push_back({"--trajectory", options.input.trajectory.path});
    for (const FurtherInput& input : options.input.further) files.push_back({"INPUT", input.path});
    std::move(further.begin(), further.end(), std::back_inserter(files));
    try {
        checkApart(files);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

}  // namespace

void nameInputs(RenderOptions& options) {
    if (options.input.further.empty()) return;
    const std::vector<std::string> names = inputNames(options.input);
    for (Rule& rule : options.look.rules) nameInputs(names, rule.selection);
    for (Label& label : options.words.labels) nameInputs(names, label.selection);
    for (std::optional<Selection>* selection : {&options.aim.lookAt, &options.aim.zoomTo, &options.aim.uncover})
        if (*selection) nameInputs(names, **selection);
    // A view that holds several has the colours that it was saved with.
    if (options.input.namedBy.empty()) colorApart(names, options.look);
}

void checkLooks(const LooksOptions& options) {
    const bool input = !options.picture.input.path.empty(), output = !options.picture.output.empty();
    if (input != output) throw UsageError(input ? "--output is required for a sheet" : "INPUT is required for a sheet");
}

void checkRender(RenderOptions& options) {
    if (!takeInput(options)) throw UsageError("INPUT is required");
    checkInputs(options);
    checkDebug(options);
    takePaper(options);
    checkFormat(options);
    try {
        checkSamples(options.size, options.supersample);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    checkFiles(options);
}

void checkMovie(MovieOptions& options) {
    RenderOptions& picture = options.picture;
    if (!options.views.empty() && !picture.view.empty())
        throw UsageError("--view and --views exclude each other: name it among them");
    if (!options.views.empty() && picture.input.path.empty() && picture.savedInput.path.empty()) {
        picture.view = options.views.front();
        picture.savedInput = inputOf(readSavedView(picture.view));
    }
    if (!takeInput(picture)) throw UsageError("INPUT is required");
    if (!picture.input.further.empty() && options.models) throw UsageError("--models is for one INPUT");
    checkInputs(picture, options.models);
    if (isStandardOutput(picture.output) && isStandardOutput(options.report))
        throw UsageError("--output and --report cannot both be standard output");
    checkMotion(options);
    try {
        checkSamples(picture.size, picture.supersample, kMostSamplesHeld);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    std::vector<NamedFile> further{{"--report", options.report, true}};
    for (std::size_t i = 0; i < options.views.size(); ++i)
        if (options.views[i] != picture.view) further.push_back({"--views", options.views[i]});
    checkFiles(picture, std::move(further));
}

bool checkWindow(RenderOptions& first) {
    checkDebug(first);
    const bool named = takeInput(first);
    checkSeveral(first);
    if (!first.input.further.empty() && !first.input.trajectory.path.empty())
        throw UsageError("a window moves one INPUT: leave out --trajectory, or the others");
    checkFiles(first);
    return named;
}

}  // namespace nacre::app
