#include "app/desktop/recorder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "app/files/output_file.h"
#include "app/picture/option_text.h"
#include "engine/error.h"
#include "engine/threads.h"

extern char** environ;

namespace nacre::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The running program, even if its file has been replaced.
constexpr const char* kOwnProgram = "/proc/self/exe";

std::string temporaryFolder() {
    std::string name = (fs::temp_directory_path() / "nacre-movie-XXXXXX").string();
    if (!mkdtemp(name.data())) throw Error("cannot record", name, std::strerror(errno));
    return name;
}

std::string writeView(const std::string& folder, std::size_t number, const PictureDescription& view) {
    const std::string path = folder + "/" + std::to_string(number) + ".view.json";
    OutputFile file(path);
    writeText(file, savedViewJson(view));
    return path;
}

struct Pipe {
    std::array<int, 2> ends{-1, -1};
    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("cannot record", "", std::strerror(errno));
    }
    ~Pipe() {
        for (const int end : ends)
            if (end >= 0) close(end);
    }
    int keep(std::size_t i) { return std::exchange(ends[i], -1); }
};

/// The last error line, without the program's name.
std::string lastComplaint(const std::string& text) {
    const std::string_view mark = "nacre: error: ";
    const std::size_t at = text.rfind(mark);
    if (at == std::string::npos) return {};
    const std::size_t from = at + mark.size();
    return text.substr(from, text.find('\n', from) - from);
}

std::string readAll(int file) {
    std::string text;
    std::array<char, 1024> part{};
    for (ssize_t n = 0; (n = read(file, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(n));
    return text;
}

/// Starts the program in its own process group, which signals to this one do not reach. Restores the default of the
/// stop signal, in case this program was started to ignore it. @returns an error number, or 0
int spawn(pid_t& pid, std::vector<std::string>& words, int out, int err) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out, 1);
    posix_spawn_file_actions_adddup2(&actions, err, 2);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t heard;
    sigemptyset(&heard);
    sigaddset(&heard, SIGTERM);
    posix_spawnattr_setsigdefault(&attributes, &heard);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int failed = posix_spawn(&pid, argv[0], &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

}  // namespace

std::vector<std::string> movieArguments(const RecordingWish& wish, const PictureDescription& shown,
                                        const std::string& view, const std::vector<std::string>& keys) {
    using M = RecordingWish::Motion;
    std::vector<std::string> words{"movie"};
    // Several inputs are only in the view, together with their colours.
    if (shown.input.further.empty()) words.push_back(shown.input.path);
    words.insert(words.end(), {"--output", wish.path});
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    add({"--size", std::to_string(wish.size.width) + "x" + std::to_string(wish.size.height)});
    add({"--seconds", numberText(wish.seconds), "--fps", numberText(wish.framesPerSecond), "--report", "-"});
    if (shown.input.format) add({"--format", std::string(formatName(*shown.input.format))});
    const TrajectoryOptions& t = shown.input.trajectory;
    if (!t.path.empty()) add({"--trajectory", t.path});
    if (!t.path.empty() && wish.motion != M::models) add({"--frame", std::to_string(t.frame)});
    if (t.whole) add({"--whole"});
    if (t.fit) add({"--fit-frames", t.fit->text});
    if (t.smooth > 1) add({"--smooth", std::to_string(t.smooth)});
    if (wish.motion != M::models && wish.motion != M::morph && shown.input.model != 1)
        add({"--model", shown.input.model == kAllModels ? "all" : std::to_string(shown.input.model)});
    if (wish.motion == M::views) {
        std::string list;
        for (const std::string& key : keys) list += (list.empty() ? "" : ",") + key;
        add({"--views", list});
        if (wish.loop) add({"--loop"});
    } else {
        add({"--view", view});
        if (!shown.input.further.empty()) add({"--allow-download"});  // the cache may be off
    }
    if (wish.motion == M::spin) add({"--spin", "y"});
    if (wish.motion == M::rock) add({"--rock", "30"});
    if (wish.motion == M::models) add({"--models"});
    if (wish.motion == M::morph) add({"--morph"});
    return words;
}

Recorder::~Recorder() { finish(); }

void Recorder::finish() {
    stop();
    if (!thread_.joinable()) return;
    {
        std::unique_lock lock(mutex_);
        const auto ended = [&] { return !state_.running; };
        // Its encoder is in the same process group, and holds the pipes open.
        if (!ended_.wait_for(lock, std::chrono::duration<double>(patience_), ended) && child_ > 0)
            kill(-child_, SIGKILL);
    }
    thread_.join();
}

void Recorder::start(const RecordingWish& wish, PictureDescription shown, std::vector<PictureDescription> keys,
                     const std::vector<std::string>& fixed) {
    if (state().running) return;
    if (thread_.joinable()) thread_.join();
    folder_ = temporaryFolder();
    if (wish.transparent) shown.background[3] = 0;
    std::vector<std::string> files;
    for (PictureDescription& key : keys) {
        if (wish.transparent) key.background[3] = 0;
        files.push_back(writeView(folder_, files.size() + 1, key));
    }
    std::vector<std::string> words = movieArguments(wish, shown, writeView(folder_, 0, shown), files);
    words.insert(words.begin(), program_.empty() ? kOwnProgram : program_);
    words.insert(words.end(), fixed.begin(), fixed.end());

    Pipe reports, complaints;
    pid_t pid = -1;
    if (const int failed = spawn(pid, words, reports.ends[1], complaints.ends[1]); failed != 0) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
        throw Error("cannot record", words[0], std::strerror(failed));
    }
    const std::lock_guard lock(mutex_);
    child_ = pid;
    state_ = {};
    state_.running = true;
    state_.path = wish.path;
    if (mayStart(thread_, [this, out = reports.keep(0), err = complaints.keep(0)] { follow(out, err); })) return;
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
    child_ = -1;
    state_ = {};
    throw Error("cannot record", wish.path, "no thread can be started");
}

void Recorder::stop() {
    const std::lock_guard lock(mutex_);
    if (child_ <= 0 || state_.stopping) return;
    state_.stopping = true;
    kill(child_, SIGTERM);
}

RecordingState Recorder::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

/// Reads the program's reports until it ends.
void Recorder::follow(int reports, int complaints) {
    std::string complained;
    // Reads its errors on another thread, so that neither pipe fills up.
    std::thread other;
    const bool beside = mayStart(other, [&] { complained = readAll(complaints); });
    std::FILE* lines = fdopen(reports, "r");
    const Clock::time_point began = Clock::now();
    Clock::time_point drawing = began;
    std::array<char, 256> line{};
    while (lines && std::fgets(line.data(), static_cast<int>(line.size()), lines)) {
        unsigned long long frame = 0, frames = 0;
        if (std::sscanf(line.data(), "{\"frame\": %llu, \"frames\": %llu}", &frame, &frames) != 2 || frames == 0)
            continue;
        if (frame == 1) drawing = Clock::now();
        {
            const std::lock_guard lock(mutex_);
            state_.frame = frame;
            state_.frames = frames;
            state_.share = static_cast<double>(frame) / static_cast<double>(frames);
            const double seconds = std::chrono::duration<double>(Clock::now() - drawing).count();
            if (frame > 1) state_.left = seconds / static_cast<double>(frame - 1) * static_cast<double>(frames - frame);
        }
        if (wake_) wake_();
    }
    if (beside)
        other.join();
    else
        complained = readAll(complaints);
    if (lines) std::fclose(lines);
    close(complaints);
    int status = 0;
    {
        // After waiting, its process ID may be reused.
        siginfo_t info{};
        while (waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
        }
        const std::lock_guard lock(mutex_);
        waitpid(child_, &status, 0);
        child_ = -1;
        const bool done = WIFEXITED(status) && WEXITSTATUS(status) == 0;
        state_.running = false;
        state_.failed = !done && !state_.stopping;
        const std::string complaint = lastComplaint(complained);
        state_.message = done ? "saved " + state_.path : complaint.empty() ? "the movie could not be made" : complaint;
        state_.stopping = false;
    }
    ended_.notify_all();
    std::error_code error;
    fs::remove_all(folder_, error);
    if (wake_) wake_();
}

}  // namespace nacre::app
