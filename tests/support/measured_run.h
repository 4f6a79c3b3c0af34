#pragma once
// Runs the built program as a process of its own and says what it took.

#include <fcntl.h>
#include <pty.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/no_cache.h"
#include "tests/support/temporary_folder.h"

namespace nacre::test {

struct MeasuredRun {
    int code = -1;                ///< exit code; -1 after a signal
    int signal = 0;               ///< what ended it, if a signal did
    double seconds = 0;           ///< by the clock on the wall, which a busy machine stretches
    double processorSeconds = 0;  ///< of all its threads
    std::int64_t peakBytes = 0;
    std::string out, err;
};

struct RunOptions {
    std::vector<std::pair<std::string, std::string>> environment;
    bool terminal = false;             ///< standard error is a terminal
    bool oneCore = false;              ///< so that it takes as long as it works, however many cores there are
    std::function<bool()> until = {};  ///< asked again and again; once it is true signals end the program
    int signal = SIGINT;
    bool once = false;               ///< no second signal follows the first
    unsigned processorSeconds = 60;  ///< more of the processor ends it
};

namespace detail {

/// In the child: never returns.
[[noreturn]] inline void runProgram(const std::vector<std::string>& arguments, const RunOptions& options, int out,
                                    int err) {
    const int none = open("/dev/null", O_RDONLY);
    dup2(none, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    if (options.oneCore) {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<unsigned>(std::max(sched_getcpu(), 0)), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    for (const auto& [name, text] : options.environment) setenv(name.c_str(), text.c_str(), 1);
    std::string program = NACRE_PROGRAM;
    std::vector<std::string> copies = arguments;
    std::vector<char*> pointers{program.data()};
    for (std::string& argument : copies) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const rlimit limit{options.processorSeconds, options.processorSeconds};  // outlives the exec
    setrlimit(RLIMIT_CPU, &limit);
    execv(program.c_str(), pointers.data());
    _exit(127);
}

/// Everything that is written to a terminal until its last writer has gone.
inline std::string readTerminal(int terminal) {
    std::string text;
    char buffer[4096];
    for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
    return text;
}

}  // namespace detail

/// Runs `nacre ARGUMENTS`.
inline MeasuredRun runMeasured(const std::vector<std::string>& arguments, const RunOptions& options = {}) {
    const TemporaryFolder logs;
    const int out = open((logs / "out").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    int terminal = -1, err = -1;
    if (options.terminal) {
        if (openpty(&terminal, &err, nullptr, nullptr, nullptr) != 0) throw std::runtime_error("no pseudo-terminal");
    } else {
        err = open((logs / "err").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    }
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) detail::runProgram(arguments, options, out, err);
    close(out);
    close(err);
    MeasuredRun run;
    if (options.terminal) {
        run.err = detail::readTerminal(terminal);
        close(terminal);
    }
    int status = 0;
    rusage usage{};
    bool sent = false;
    while (options.until && wait4(child, &status, WNOHANG, &usage) == 0) {
        if (!(options.once && sent) && options.until()) sent = kill(child, options.signal) == 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    if (!options.until) wait4(child, &status, 0, &usage);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.processorSeconds = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    run.peakBytes = std::int64_t{usage.ru_maxrss} * 1024;
    if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
    run.out = readContents(logs / "out");
    if (!options.terminal) run.err = readContents(logs / "err");
    return run;
}

}  // namespace nacre::test
