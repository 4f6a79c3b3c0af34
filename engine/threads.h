#pragma once
// Threads for the engine's tasks.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "engine/error.h"

namespace nacre {

namespace detail {
inline std::atomic<unsigned> threadsPerTask{0};
}

/// Sets the number of threads per task, for the whole process from the next task on. The calling thread is one of them,
/// so 1 starts none. Concurrent tasks have this number each. @param count  0: one per core, the default
inline void setThreadsPerTask(unsigned count) { detail::threadsPerTask = count; }
inline unsigned threadsPerTask() {
    const unsigned set = detail::threadsPerTask;
    return set > 0 ? set : std::max(1u, std::thread::hardware_concurrency());
}

/// Starts a thread, if the system allows one. @returns whether it runs
template <typename Run>
bool mayStart(std::thread& thread, Run&& run) {
    try {
        thread = std::thread(std::forward<Run>(run));
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

/// As above. @throws Error if the system allows none
template <typename Run>
std::thread startThread(Run&& run) {
    std::thread thread;
    if (!mayStart(thread, std::forward<Run>(run)))
        throw Error("cannot start a thread", "", "the system's limit on threads or processes is reached");
    return thread;
}

/// Calls work(0) to work(count - 1) in any order, on at most threadsPerTask() threads, fewer if the system allows
/// fewer.
/// @throws the exception of the first call that failed
template <typename Work>
void inParallel(std::size_t count, const Work& work) {
    const auto threads = std::min<std::size_t>(threadsPerTask(), count);
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex mutex;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) work(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> others(threads > 1 ? threads - 1 : 0);
    for (std::thread& thread : others)
        if (!mayStart(thread, run)) break;
    run();
    for (std::thread& thread : others)
        if (thread.joinable()) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace nacre
