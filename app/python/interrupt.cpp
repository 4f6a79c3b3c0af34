#include "app/python/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

#include "app/files/output_file.h"
#include "engine/threads.h"

namespace nacre::python {
namespace {

struct Job {
    std::function<void()> work;
    std::mutex turn;
    std::condition_variable ready;
    bool done = false;
    std::exception_ptr failure;
    std::atomic<bool> given{false};  ///< nobody waits for the work any more
};

thread_local const Job* current = nullptr;
std::atomic<int> strays{0};  ///< jobs that continue although nobody waits for them

#ifdef __GLIBC__
/// They still use drivers and objects that exit() would destroy.
void exitBesideStrays(int status, void*) {
    if (strays == 0) return;
    std::fflush(nullptr);
    _exit(status);
}
#endif

/// At Python's end. Files that these jobs write stay incomplete.
void leaveStrays() {
    if (strays > 0) app::removeUnfinishedFiles();
#ifndef __GLIBC__
    while (strays > 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
#endif
}

/// Call with Python's lock.
void expectStrays() {
    static const bool once = [] {
#ifdef __GLIBC__
        on_exit(exitBesideStrays, nullptr);  // the last one that is registered is called first
#endif
        return Py_AtExit(leaveStrays) == 0;
    }();
    static_cast<void>(once);
}

unsigned long mainThread() {
    static const unsigned long main = [] {
        const pybind11::gil_scoped_acquire lock;
        return pybind11::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
    }();
    return main;
}

}  // namespace

void checkInterrupt() {
    if (current && current->given) throw Interrupted();
}

bool answersSignals() { return PyThread_get_thread_ident() == mainThread(); }

void runBeside(std::function<void()> work) {
    constexpr std::chrono::milliseconds kBetween(50), kGrace(200);
    const auto job = std::make_shared<Job>();
    job->work = std::move(work);
    std::thread thread;
    const auto run = [job] {
        current = job.get();
        try {
            job->work();
        } catch (...) {
            job->failure = std::current_exception();
        }
        const std::lock_guard lock(job->turn);
        job->done = true;
        if (job->given) --strays;
        job->ready.notify_all();
    };
    if (!mayStart(thread, run)) return job->work();
    const auto ends = [&](std::chrono::milliseconds time) {
        std::unique_lock lock(job->turn);
        return job->ready.wait_for(lock, time, [&] { return job->done; });
    };
    while (!ends(kBetween)) {
        const pybind11::gil_scoped_acquire lock;
        if (PyErr_CheckSignals() == 0) continue;
        pybind11::error_already_set interrupt;
        expectStrays();
        {
            const std::lock_guard its(job->turn);
            job->given = true;
            if (!job->done) ++strays;
        }
        const pybind11::gil_scoped_release others;
        if (ends(kGrace))
            thread.join();
        else
            thread.detach();
        throw interrupt;
    }
    thread.join();
    if (job->failure) std::rethrow_exception(job->failure);
}

}  // namespace nacre::python
