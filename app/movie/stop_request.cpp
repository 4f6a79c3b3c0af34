#include "app/movie/stop_request.h"

#include <array>
#include <csignal>

namespace nacre::app {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, kSignals.size()> before{};
volatile std::sig_atomic_t stop = 0;
bool watching = false;

extern "C" void noteStop(int) {
    stop = 1;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

}  // namespace

StopRequest::StopRequest() {
    stop = 0;
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

bool StopRequest::asked() const { return stop != 0; }

void StopRequest::leave() {
    if (!watching) return;
    watching = false;
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

}  // namespace nacre::app
