#include "app/desktop/end_signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<int> cameFirst{0};  // any thread may run the handler
static_assert(std::atomic<int>::is_always_lock_free);
int wakeUp[2] = {-1, -1};  // write end for the handler, read end for the thread

extern "C" void tellOfEnd(int signal) {
    cameFirst = signal;
    for (const int each : kSignals) std::signal(each, SIG_DFL);
    const char byte = 1;
    [[maybe_unused]] const auto written = write(wakeUp[1], &byte, 1);
}

}  // namespace

EndSignals::EndSignals(void (*wake)()) {
    cameFirst = 0;
    if (pipe(wakeUp) != 0) return;  // the signals keep their default action
    const bool started = mayStart(thread_, [wake, from = wakeUp[0]] {
        for (char byte = 0; read(from, &byte, 1) == 1 && byte == 1;) wake();
    });
    if (!started) {
        for (const int end : wakeUp) close(end);
        return;
    }
    for (const int signal : kSignals)
        // A signal that the parent ignores (nohup) stays ignored.
        if (struct sigaction now{}; sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
            std::signal(signal, tellOfEnd);
}

EndSignals::~EndSignals() {
    if (!thread_.joinable()) return;
    for (const int signal : kSignals)
        if (struct sigaction now{}; sigaction(signal, nullptr, &now) == 0 && now.sa_handler == tellOfEnd)
            std::signal(signal, SIG_DFL);
    const char byte = 0;
    [[maybe_unused]] const auto written = write(wakeUp[1], &byte, 1);
    thread_.join();
    for (const int end : wakeUp) close(end);
}

int EndSignals::came() { return cameFirst; }

}  // namespace nacre::app
