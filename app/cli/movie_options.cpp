#include "app/cli/movie_options.h"

#include <algorithm>
#include <cmath>

#include "app/cli/movie_snapshots.h"
#include "app/movie/movie_file.h"

namespace nacre::app {
namespace {

constexpr double kStretchSeconds = 2;
constexpr std::size_t kMostViews = 1000;

std::vector<std::string> parseViews(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        names.push_back(fileName(text.substr(from, comma - from)));
        from = comma + 1;
    }
    if (names.size() < 2) throw std::invalid_argument("expected two views or more, A.json,B.json");
    if (names.size() > kMostViews) throw std::invalid_argument("more than " + std::to_string(kMostViews) + " views");
    return names;
}

/// "101-500:10", "101-", "-500:10", ":10".
FrameRange parseFrames(const std::string& text) {
    constexpr std::int64_t kMost = 1'000'000'000;
    const auto refuse = [&]() -> FrameRange {
        throw std::invalid_argument("expected frames such as 101-500 or 101-500:10, not '" + text + "'");
    };
    const std::size_t colon = text.find(':');
    const std::string span = text.substr(0, colon);
    const std::size_t dash = span.find('-');
    FrameRange range;
    if (colon != std::string::npos) range.step = parseInteger(text.substr(colon + 1), 1, kMost);
    if (span.empty()) return colon == std::string::npos ? refuse() : range;
    if (dash == std::string::npos) return refuse();
    if (dash > 0) range.first = parseInteger(span.substr(0, dash), 1, kMost);
    if (dash + 1 < span.size()) range.last = parseInteger(span.substr(dash + 1), 1, kMost);
    if (range.last != 0 && range.last < range.first) throw std::invalid_argument("the range ends before it begins");
    return range;
}

/// Whether the last frame continues with the first.
bool goesRound(const MovieOptions& options) {
    if (!options.views.empty()) return options.loop;
    return options.spin || options.rock;
}

}  // namespace

void addMotion(CommandSpec& command, MovieOptions& options) {
    const auto motion = [&](const std::string& key, const std::string& type, const std::string& fallback,
                            const std::string& help) {
        command.value("--" + key, type, fallback, help,
                      [&options, key](const std::string& text) { setMotion(key, text, options); });
    };
    motion("spin", "AXIS", "none",
           "Spin about x, y, z (across, up, towards the viewer) or a vector X,Y,Z, right-handed, back to the start");
    motion("turns", "N", "1", "Turns of --spin, -100 to 100, not 0; may be a fraction");
    motion("rock", "DEGREES", "none", "Rotate to either side and back, by up to 180 degrees");
    motion("axis", "AXIS", "y", "Axis of --rock, as for --spin");
    motion("map-sweep", "FROM,TO", "none",
           "Contour level of the first map from FROM to TO, as --map-level has them; with --spin or --rock also back");
    const auto models = [&](const std::string& name, MovieModels shown, const std::string& help) {
        command.add({name, "", "", help, [&options, shown](const std::string&) {
                         if (options.models != MovieModels::one)
                             throw UsageError("--models and --morph exclude each other");
                         options.models = shown;
                     }});
    };
    models("--models", MovieModels::sequence,
           "Show the models or records of INPUT in sequence, or the frames of --trajectory");
    models("--morph", MovieModels::morph,
           "Move from each model of INPUT to the next, or from INPUT to the further ones, by interpolated\n"
           "frames of its parts: bonds keep their lengths");
    command.value("--frames", "FIRST-LAST[:STEP]", "all",
                  "With --models: only these models or frames, counted from 1, every STEP-th; 101- runs to the end",
                  [&](const std::string& text) { options.range = parseFrames(text); });
    command.value("--views", "A.json,B.json,...", "none",
                  "Move along saved views: the camera moves, other differences cross-fade; options override each view",
                  [&](const std::string& text) { options.views = parseViews(text); });
    command.flag("--loop", options.loop, "Return from the last of --views or --morph to the first");
    motion("easing", "NAME", "smooth for --morph, and for --views that do not loop, else linear",
           "linear: constant speed; smooth: starts and ends at rest; stops: rests at each view or conformation");
    motion("seconds", "S",
           "6 for --spin, 4 for --rock and --map-sweep, 2 per step of --views or --morph, 0.1 per model, one frame per "
           "frame of --trajectory",
           "Duration, up to 86400");
    motion("fps", "N", "30", "Frames per second, 0.1 to 120 (GIF: 50)");
    command.value("--report", "FILE", "none", "One line of JSON per finished frame; - for standard output",
                  [&](const std::string& text) { options.report = fileName(text); });
}

void takeMorph(MovieOptions& options) {
    InputOptions& input = options.picture.input;
    if (!input.trajectory.path.empty()) throw UsageError("--morph goes through models or inputs, not a --trajectory");
    if (!input.fits.empty() || !input.alignments.empty())
        throw UsageError("--morph superposes its inputs: leave out --fit and --align");
    input.conformations = !input.further.empty();
}

void checkMotion(const MovieOptions& options) {
    const int cameras = (options.spin ? 1 : 0) + (options.rock ? 1 : 0) + (options.views.empty() ? 0 : 1);
    if (cameras > 1) throw UsageError("--spin, --rock and --views exclude each other");
    const bool sequence = options.models == MovieModels::sequence, morph = options.models == MovieModels::morph;
    const bool several = sequence || morph, snapshots = showsSnapshots(options);
    if (options.picture.input.snapshot == kAllSnapshots && (cameras || several || options.sweep))
        throw UsageError("--snapshot all moves from snapshot to snapshot: name one for other motions");
    if (cameras == 0 && !several && !options.sweep && !snapshots)
        throw UsageError("no motion given: add --spin, --rock, --views, --models, --morph or --map-sweep");
    if (options.sweep && options.picture.maps.files.empty()) throw UsageError("--map-sweep needs --map");
    if (options.sweep && (several || !options.views.empty()))
        throw UsageError("--map-sweep goes with --spin and --rock only: views have levels of their own");
    if (options.loop && options.views.empty() && !snapshots && !morph)
        throw UsageError("--loop is for --views, --morph and --snapshot all");
    checkCameraMotion(options);
    if (options.easing && cameras == 0 && !options.sweep && !snapshots && !morph)
        throw UsageError("--easing is for --spin, --rock, --views, --morph, --map-sweep and --snapshot all");
    if (options.easing == Easing::stops && options.views.empty() && !morph)
        throw UsageError("--easing stops is for --views and --morph");
    const bool trajectory = !options.picture.input.trajectory.path.empty();
    if (several && !trajectory && isGiven(options, "model"))
        throw UsageError("--models shows one model after the other: leave out --model");
    const FrameRange& range = options.range;
    if (!sequence && (range.first != 1 || range.last != 0 || range.step != 1))
        throw UsageError("--frames is for --models");
    if (sequence && isGiven(options, "frame"))
        throw UsageError("--models shows one frame after the other: leave out --frame");
    if (several && !options.views.empty() && options.picture.look.ownFrame)
        throw UsageError("--camera model and --views exclude each other: --views move the camera");
    if (sequence && options.picture.input.path == "-" && !trajectory)
        throw UsageError("--models reads INPUT several times: name a file, not standard input");
    if (!snapshots && countFrames(options, 1) > kMostMovieFrames)
        throw UsageError("more than " + std::to_string(kMostMovieFrames) + " frames: lower --seconds or --fps");
}

bool isGiven(const MovieOptions& options, const char* name) {
    return std::any_of(options.given.begin(), options.given.end(), [&](const OptionValue& v) { return v.key == name; });
}

std::uint64_t countFrames(const MovieOptions& options, std::uint64_t models) {
    const std::size_t views = options.views.size();
    const bool moving = !options.picture.input.trajectory.path.empty();
    double seconds = movieSeconds(options, models, moving);
    if (views) seconds = kStretchSeconds * static_cast<double>(options.loop ? views : views - 1);
    seconds = options.seconds.value_or(seconds);
    return static_cast<std::uint64_t>(std::max(std::llround(seconds * options.framesPerSecond), 1ll));
}

double frameTime(const MovieOptions& options, std::uint64_t frame, std::uint64_t frames) {
    const std::uint64_t whole = goesRound(options) ? frames : std::max<std::uint64_t>(frames - 1, 1);
    return static_cast<double>(frame) / static_cast<double>(whole);
}

}  // namespace nacre::app
