#pragma once
// Ctrl C during long work. Python's main thread alone answers signals, so it waits while another thread works.

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace nacre::python {

/// Thrown by checkInterrupt(); no std::exception, so that nobody takes it for a failure of the work.
struct Interrupted {};

/// In work that nobody waits for any more: ends it. Cheap enough to be called often. @throws Interrupted
void checkInterrupt();

/// Whether this thread answers Python's signals.
bool answersSignals();
/// Runs work in another thread, and answers signals meanwhile. @throws what the work throws; the exception of a
/// signal's handler within a fraction of a second, and then the work ends at its next checkInterrupt()
void runBeside(std::function<void()> work);

/// Runs work without Python's lock. @param work  owns what it uses, and no Python object: after a signal it may outlive
/// the call
template <typename Work>
auto interruptible(Work&& work) {
    const pybind11::gil_scoped_release others;
    if (!answersSignals()) return work();
    const auto result = std::make_shared<std::optional<decltype(work())>>();
    runBeside([work = std::forward<Work>(work), result]() mutable { result->emplace(work()); });
    return std::move(**result);
}

}  // namespace nacre::python
