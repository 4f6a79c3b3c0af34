#include "app/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "app/download/load_map.h"
#include "app/download/load_molecule.h"
#include "app/files/messages.h"
#include "app/files/output_file.h"
#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kBetween = std::chrono::milliseconds(200);
constexpr int kBarWidth = 24;
constexpr double kTelling = 0.02;  // share from which the remaining time can be estimated

/// "0:07", "1:02:33"
std::string clockText(std::chrono::seconds time) {
    const auto two = [](std::int64_t n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    const std::int64_t all = time.count(), hours = all / 3600, minutes = all / 60 % 60;
    return (hours ? std::to_string(hours) + ":" + two(minutes) : std::to_string(minutes)) + ":" + two(all % 60);
}

}  // namespace

std::string progressText(const std::string& work, std::optional<double> share, std::chrono::seconds elapsed,
                         std::optional<std::chrono::seconds> left) {
    if (!share) return "nacre: " + work + ", " + std::to_string(elapsed.count()) + " s";
    const double done = std::clamp(*share, 0.0, 1.0);
    const int width = left ? kBarWidth / 2 : kBarWidth;
    const auto full = static_cast<std::size_t>(done * width);
    std::string percent = std::to_string(static_cast<int>(done * 100));
    percent.insert(0, 3 - percent.size(), ' ');
    return "nacre: " + work + " [" + std::string(full, '#') + std::string(static_cast<std::size_t>(width) - full, ' ') +
           "] " + percent + " %" + (left ? ", " + clockText(*left) + " left" : "");
}

Progress::Progress(bool shown) {
    if (shown && isatty(STDERR_FILENO) && !isQuiet()) mayStart(thread_, [this] { show(); });
}

Progress::~Progress() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Progress::begin(const std::string& work) {
    const std::lock_guard lock(mutex_);
    work_ = work;
    share_.reset();
    steady_ = false;
    began_ = Clock::now();
}

void Progress::advance(double share) {
    const std::lock_guard lock(mutex_);
    share_ = share;
}

void Progress::advanceTo(std::uint64_t done, std::uint64_t all) {
    const std::lock_guard lock(mutex_);
    share_ = static_cast<double>(done) / static_cast<double>(all);
    steady_ = true;
}

std::function<void(double)> downloadProgress(Progress& progress) {
    return [&progress, began = false](double share) mutable {
        if (!began) progress.begin("downloading");
        began = true;
        progress.advance(share);
        if (share >= 1) progress.begin("reading");
    };
}

Molecule readMoleculeAndMaps(const PictureDescription& picture, Progress& progress, OpenScene* scene) {
    progress.begin("reading");
    const auto onDownload = downloadProgress(progress);
    Molecule molecule = scene ? loadSnapshot(*scene, picture.input, onDownload)
                              : loadMolecule(picture.input, onDownload, [&](double share) { progress.advance(share); });
    loadMaps(picture, downloadProgress(progress));
    return molecule;
}

void Progress::show() {
    const Clock::time_point start = Clock::now();
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, kPatience, [this] { return ending_; })) return;
    do {
        const auto elapsed = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start);
        std::optional<std::chrono::seconds> left;
        if (steady_ && share_ && *share_ >= kTelling)
            left = std::chrono::duration_cast<std::chrono::seconds>((Clock::now() - began_) * (1 / *share_ - 1));
        // Carriage return, then "erase to end of line", which all terminals since the VT100 support.
        std::fprintf(stderr, "\r\x1b[K%s", progressText(work_, share_, elapsed, left).c_str());
        std::fflush(stderr);
        setLineShown(true);
    } while (!wake_.wait_for(lock, kBetween, [this] { return ending_; }));
    setLineShown(false);
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
}

MovieReport::MovieReport(const std::string& path) {
    if (path.empty()) return;
    file_ = isStandardOutput(path) ? stdout : std::fopen(path.c_str(), "we");
    std::signal(SIGPIPE, SIG_IGN);  // the movie continues if nobody reads the report
    if (!file_) throw Error("cannot write file", path, std::strerror(errno));
}

MovieReport::~MovieReport() {
    if (file_ && file_ != stdout) std::fclose(file_);
}

void MovieReport::baked(double share) {
    if (!file_) return;
    std::fprintf(file_, "{\"baked\": %.3f}\n", share);
    std::fflush(file_);
}

void MovieReport::drawn(std::uint64_t frame, std::uint64_t frames, std::optional<int> model) {
    if (!file_) return;
    const std::string shown = model ? ", \"model\": " + std::to_string(*model) : "";
    std::fprintf(file_, "{\"frame\": %llu, \"frames\": %llu%s}\n", static_cast<unsigned long long>(frame),
                 static_cast<unsigned long long>(frames), shown.c_str());
    std::fflush(file_);
}

}  // namespace nacre::app
