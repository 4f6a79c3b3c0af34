#include "app/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/shared/messages.h"

namespace nacre::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kBetween = std::chrono::milliseconds(200);
constexpr int kBarWidth = 24;

}  // namespace

std::string progressText(const std::string& work, std::optional<double> share, std::chrono::seconds elapsed) {
    if (!share) return "nacre: " + work + ", " + std::to_string(elapsed.count()) + " s";
    const double done = std::clamp(*share, 0.0, 1.0);
    const auto full = static_cast<std::size_t>(done * kBarWidth);
    std::string percent = std::to_string(static_cast<int>(done * 100));
    percent.insert(0, 3 - percent.size(), ' ');
    return "nacre: " + work + " [" + std::string(full, '#') + std::string(kBarWidth - full, ' ') + "] " + percent +
           " %";
}

Progress::Progress() {
    if (isatty(STDERR_FILENO) && !isQuiet()) thread_ = std::thread([this] { show(); });
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
}

void Progress::advance(double share) {
    const std::lock_guard lock(mutex_);
    share_ = share;
}

std::function<void(double)> downloadProgress(Progress& progress) {
    return [&progress, began = false](double share) mutable {
        if (!began) progress.begin("downloading");
        began = true;
        progress.advance(share);
        if (share >= 1) progress.begin("reading");
    };
}

void Progress::show() {
    const Clock::time_point start = Clock::now();
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, kPatience, [this] { return ending_; })) return;
    do {
        const auto elapsed = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start);
        // Carriage return, then "erase to the end of the line", which every terminal since the VT100 knows.
        std::fprintf(stderr, "\r\x1b[K%s", progressText(work_, share_, elapsed).c_str());
        std::fflush(stderr);
    } while (!wake_.wait_for(lock, kBetween, [this] { return ending_; }));
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
}

}  // namespace nacre::app
