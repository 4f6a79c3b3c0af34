#include "app/cli/picture_options.h"

#include <algorithm>
#include <filesystem>
#include <thread>

#include "app/cli/movie_options.h"
#include "app/download/allowed_hosts.h"
#include "app/drawing/complete.h"
#include "app/files/output_file.h"
#include "app/movie/movie_file.h"
#include "app/picture/option_values.h"
#include "app/picture/saved_view.h"

namespace nacre::app {
namespace {

constexpr Topics kShading = Topic::background | Topic::lighting | Topic::occlusion | Topic::effects;
constexpr Topics kDevice = Topic::device | Topic::path | Topic::frame | Topic::validation;
constexpr Topics kContent = kReading | kAppearance;
constexpr Topics kSeen = kContent | kShading | Topic::camera | Topic::aim | Topic::words;

std::string writtenName(const Option& option) {
    const std::string key(option.key);
    if (!option.positional) return (option.letter.empty() ? "--" : "-" + std::string(option.letter) + ",--") + key;
    std::string name = key;
    for (char& c : name) c = static_cast<char>(c - 'a' + 'A');
    return name;
}

constexpr int kMostJobs = 64;

/// One device draws all jobs: these options are the batch's.
constexpr Topics kOfTheDevice = Topic::device | Topic::path | Topic::validation;
/// Options of a single job.
constexpr Topics kOfOneJob = Topic::input | Topic::files;
constexpr double kFigureDpi = 300;

/// "8080", "0.0.0.0:8080", "[::1]:8080". @throws std::invalid_argument
void takeAddress(const std::string& text, ServeOptions& options) {
    const std::size_t colon = text.rfind(':');
    if (colon != std::string::npos) {
        options.address = text.substr(0, colon);
        if (options.address.starts_with('[') && options.address.ends_with(']'))
            options.address = options.address.substr(1, options.address.size() - 2);
        if (options.address.empty()) throw std::invalid_argument("expected ADDRESS:PORT");
    }
    options.port = static_cast<int>(parseInteger(text.substr(colon == std::string::npos ? 0 : colon + 1), 0, 65535));
}

}  // namespace

void addPicture(CommandSpec& command, PictureDescription& picture, Topics topics, std::vector<OptionValue>* given) {
    for (const Option& option : options()) {
        if (!has(topics, option.topic)) continue;
        OptionSpec& spec = command.add(
            {writtenName(option), option.syntax, option.standard == "=" ? option.value.print(picture) : option.standard,
             option.help, [&row = option, &picture, given, topics](const std::string& text) {
                 const bool view = row.positional && has(topics, Topic::view) && isViewFile(text);
                 const Option& set = view ? nacre::app::option("view") : row;
                 setOption(set, text, picture);
                 if (given) given->push_back({std::string(set.key), text});
             }});
        spec.required = option.required;
        spec.repeatable = option.kind == Option::Kind::list;
        spec.pair = option.kind == Option::Kind::pair;
        spec.bare = option.bare;
        if (!option.excludes.empty()) spec.excludes = "--" + std::string(option.excludes);
        spec.choices = option.choices;
    }
}

void addInputs(CommandSpec& command, std::vector<std::string>& paths, PictureDescription& picture) {
    addPicture(command, picture, Topic::input | Topic::reading);
    OptionSpec& input = command.options.front();
    input.help =
        input.help.substr(0, input.help.find(" Several form one picture")) + " Several are processed one by one";
    input.set = [&](const std::string& text) { paths.push_back(text); };
    input.required = true;
}

void addRender(CommandSpec& command, PictureDescription& picture) { addPicture(command, picture, kEveryTopic); }

void addMovie(CommandSpec& command, MovieOptions& options) {
    PictureDescription& picture = options.picture;
    command
        .value("-o,--output", "FILE|FOLDER/", "",
               "The movie: .mp4, .webm (both by ffmpeg), .gif, .png (animated); or a folder of PNG frames;\n"
               "- is an animated PNG to standard output",
               [&](const std::string& text) {
                   if (!isMovieName(text)) refuseEnding(text, movieEndings(), ", or a folder");
                   picture.output = text;
               })
        .required = true;
    addMotion(command, options);
    addPicture(
        command, picture,
        kSeen | Topic::view | Topic::look | Topic::detail | Topic::size | Topic::samples | Topic::levels | kDevice,
        &options.given);
}

void addWindow(CommandSpec& command, PictureDescription& first) {
    first.size = {1280, 800};
    addPicture(command, first, kSeen | Topic::view | Topic::look | Topic::size | Topic::debug | kDevice);
    command.value("--stats", "FILE", "none",
                  "Frames, times and memory as JSON when the window closes; - for standard output",
                  [&](const std::string& text) { first.stats = fileName(text); });
    command.flag("--capture", first.device.capture,
                 "Load RenderDoc, so that F12 captures a frame; it listens on this machine only");
}

void addHeadset(CommandSpec& command, PictureDescription& first) {
    addPicture(command, first, kSeen | Topic::view | Topic::look | kDevice);
}

void addLooks(CommandSpec& command, LooksOptions& options) {
    PictureDescription& picture = options.picture;
    picture.size = {384, 384};
    addPicture(command, picture,
               kContent | Topic::camera | Topic::aim | Topic::occlusion | Topic::size | Topic::samples | kDevice);
    OptionSpec output{"-o,--output", "FILE", "", option("output").help,
                      [&](const std::string& text) { option("output").value.parse(text, picture); }};
    command.add(output);
    command.value("--columns", "N", "4", "Looks per row of the sheet, 1 to 16",
                  [&](const std::string& text) { options.columns = static_cast<int>(parseInteger(text, 1, 16)); });
    command.flag("--json", options.json, "All looks as one JSON object; each works as --look FILE");
}

void addBatch(CommandSpec& command, BatchOptions& options) {
    command
        .value("JOBS", "", "", "A file of jobs, one JSON object per line; - for standard input",
               [&](const std::string& text) { options.path = fileName(text); })
        .required = true;
    options.parallel = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, unsigned{kMostJobs}));
    command.value(
        "--jobs", "N", "one per processor",
        "Pictures processed at the same time, 1 to 64; files are read and written while one is drawn",
        [&](const std::string& text) { options.parallel = static_cast<int>(parseInteger(text, 1, kMostJobs)); });
    command.flag("--resume", options.resume, "Skip jobs whose files exist");
    // Applies the common options now, so that errors show before any work.
    addPicture(command, options.tried, kEveryTopic & ~kOfTheDevice & ~kOfOneJob, &options.common);
    addPicture(command, options.tried, kOfTheDevice);
}

PictureDescription parseJob(const std::string& json, const BatchOptions& batch) {
    std::vector<OptionValue> values = batch.common;
    for (OptionValue& value : parseOptionValues(json)) {
        if (has(kOfTheDevice, option(value.key).topic) || value.key == "capture")
            throw UsageError("\"" + value.key + "\" is the batch's: all jobs are drawn by one device");
        if (value.value == "-" || isStandardOutput(value.value))
            throw UsageError("\"" + value.key + "\": a job's files have names");
        values.push_back(std::move(value));
    }
    PictureDescription job;
    setOptions(values, job);
    if (job.output.empty()) throw UsageError("\"output\" is required");
    completePicture(job);
    return job;
}

void addFigure(CommandSpec& command, FigureOptions& options) {
    BatchOptions& batch = options.batch;
    command
        .value("PANELS", "", "", "A file of panels, one JSON object per line; - for standard input",
               [&](const std::string& text) { batch.path = fileName(text); })
        .required = true;
    command
        .value("-o,--output", "FILE", "", option("output").help,
               [&](const std::string& text) {
                   option("output").value.parse(text, batch.tried);
                   options.output = text;
               })
        .required = true;
    command.value("--columns", "N", "2", "Panels per row, 1 to 26",
                  [&](const std::string& text) { options.columns = static_cast<int>(parseInteger(text, 1, 26)); });
    command.value("--letters", "a|A|off", "a", "Letters of the panels", [&](const std::string& text) {
        options.letters = static_cast<PanelLetters>(parseChoice(text, {"a", "A", "off"}));
    });
    command.value("--gap", "POINTS", "6", "Space between panels, 0 to 144 points at --dpi (without it 300)",
                  [&](const std::string& text) { options.gapPoints = parseNumber(text, 0, 144); });
    addPicture(command, batch.tried, kEveryTopic & ~kOfTheDevice & ~kOfOneJob, &batch.common);
    addPicture(command, batch.tried, kOfTheDevice);
}

PictureDescription parsePanel(const std::string& json, const FigureOptions& options, PanelLine& line) {
    const auto isOneOf = [](const std::string& key, std::initializer_list<const char*> keys) {
        return std::ranges::find(keys, key) != keys.end();
    };
    std::vector<OptionValue> values = options.batch.common;
    for (OptionValue& value : parseOptionValues(json, "a panel")) {
        const Option& option = nacre::app::option(value.key);
        if (has(kOfTheDevice, option.topic) || has(Topics{} | Topic::files, option.topic))
            throw UsageError("\"" + value.key + "\" is the figure's, on the command line");
        line.scales |= isOneOf(value.key, {"zoom", "scale"});
        line.turns |= isOneOf(value.key, {"orient", "look-at", "orientation", "view", "pocket", "interface"});
        line.rotates |= value.key == "rotate";
        line.clips |= isOneOf(value.key, {"clip", "slab", "clip-spare", "uncover"});
        line.scaleBar |= value.key == "scale-bar";
        line.aims |= line.turns || line.rotates || value.key == "zoom-to" ||
                     (option.topic == Topic::camera && !isOneOf(value.key, {"zoom", "scale"}));
        values.push_back(std::move(value));
    }
    PictureDescription panel;
    setOptions(values, panel);
    panel.dpi = panel.dpi.value_or(kFigureDpi);  // also for lengths in points
    panel.output = options.output;
    panel.device = options.batch.tried.device;
    completePicture(panel);
    checkSize(panel, kMostSamplesHeld);
    return panel;
}

void addServe(CommandSpec& command, ServeOptions& options) {
    options.workers = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 64u));
    options.picture.input.memoryMegabytes = 2048;
    command.value("--listen", "[ADDRESS:]PORT", "127.0.0.1:8080",
                  "Address to listen on; port 0: any free port. Only this machine can reach 127.0.0.1",
                  [&](const std::string& text) { takeAddress(text, options); });
    command.value("--root", "DIR", "none", "Folder whose files are inputs; nothing outside it is read",
                  [&](const std::string& text) {
                      if (!std::filesystem::is_directory(fileName(text)))
                          throw std::invalid_argument("'" + text + "' is not a folder");
                      options.root = text;
                  });
    command.flag("--allow-download", options.picture.input.allowDownload,
                 "Download the structures that requests name; otherwise only the cache is used");
    command
        .value("--allow-host", "HOST[:PORT]", "none",
               "A host that scenes may download from, beside the databases; may be given several times",
               [&](const std::string& text) {
                   if (hostRule("http://" + text, {text}) != HostRule::named)
                       throw std::invalid_argument("'" + text + "' is not a host, or a host and a port");
                   options.sceneHosts.push_back(text);
               })
        .repeatable = true;
    command.value("--jobs", "N", "one per processor", "Pictures drawn at the same time, 1 to 64",
                  [&](const std::string& text) { options.workers = static_cast<int>(parseInteger(text, 1, 64)); });
    command.value("--queue", "N", "64", "Requests that wait for a worker, 1 to 10000; more are answered with 429",
                  [&](const std::string& text) { options.queue = static_cast<int>(parseInteger(text, 1, 10000)); });
    command.value("--timeout", "S", "60", "Maximum time of a request in seconds, 1 to 3600",
                  [&](const std::string& text) { options.seconds = parseNumber(text, 1, 3600); });
    command.value(
        "--pictures", "MB|off", "256", "Disk cache of pictures, up to 1048576 MB; the least recently used are removed",
        [&](const std::string& text) { options.cacheMiB = text == "off" ? 0 : parseInteger(text, 1, 1 << 20); });
    command.value("--memory", "MB", "2048", "Memory limit for a molecule, 1 to 1048576", [&](const std::string& text) {
        options.picture.input.memoryMegabytes = parseInteger(text, 1, 1 << 20);
    });
    command.value("--cache", "DIR|off", "NACRE_CACHE, else ~/.cache/nacre",
                  "Folder for downloads, ambient occlusion and pictures",
                  [&](const std::string& text) { options.picture.input.cache = fileName(text); });
    addPicture(command, options.picture, Topic::device | Topic::path);
}

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
        picture.input = makeInput(first, picture.input);
        picture.input.namedBy = first.input.namedBy;
        if (!given.path.empty()) picture.input.trajectory = given;
        if (given.frame != 1) picture.input.trajectory.frame = given.frame;
    }
    if (!takeInput(picture)) throw UsageError("INPUT is required: a file, pdb:1BNA, or sample:dna");
    if (picture.input.several() && options.models == MovieModels::sequence)
        throw UsageError("--models is for one INPUT");
    if (options.models == MovieModels::morph) takeMorph(options);
    takeMap(picture);
    checkFrames(picture, options.models != MovieModels::one);
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
    takeMap(first);
    takeSeveral(first);
    if (first.input.several() && !first.input.trajectory.path.empty())
        throw UsageError("a window moves one INPUT: leave out --trajectory, or the others");
    checkFiles(first);
    return named;
}

}  // namespace nacre::app
