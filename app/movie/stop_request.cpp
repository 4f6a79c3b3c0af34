#include "app/movie/stop_request.h"

#include <array>
#include <atomic>
#include <csignal>

namespace nacre::app {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kSignals.size()> before{};
std::atomic<bool> stop{false};  // any thread may run the handler, and other threads read it
static_assert(std::atomic<bool>::is_always_lock_free);
bool watching = false;

extern "C" void noteStop(int) {
    stop = true;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

}  // namespace

StopRequest::StopRequest() {
    stop = false;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before[i]);
        if (before[i].sa_handler == SIG_IGN) continue;  // as under nohup
        struct sigaction note {};
        note.sa_handler = noteStop;
        note.sa_flags = SA_RESTART;
        sigemptyset(&note.sa_mask);
        sigaction(kSignals[i], &note, nullptr);
    }
    watching = true;
}

StopRequest::~StopRequest() { leave(); }

bool StopRequest::asked() const { return stop; }

void StopRequest::leave() {
    if (!watching) return;
    watching = false;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

}  // namespace nacre::app
