#pragma once
// Ctrl C during long work. Only Python's main thread handles signals, so it waits while another thread works.

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace nacre::python {

/// Thrown by checkInterrupt(). It is no std::exception, so that it is not mistaken for a failure of the work.
struct Interrupted {};

/// Ends work that nobody waits for any more. Cheap enough to be called often. @throws Interrupted
void checkInterrupt();

/// Whether this thread handles Python's signals.
bool answersSignals();
/// Runs work in another thread, and handles signals meanwhile. @throws the work's exception; or, within a fraction of a
/// second, that of a signal's handler, and then the work ends at its next checkInterrupt()
void runBeside(std::function<void()> work);

/// Runs work without Python's lock. @param work  owns its data, and no Python object: after a signal it may outlive the
/// call
template <typename Work>
auto interruptible(Work&& work) {
    const pybind11::gil_scoped_release others;
    if (!answersSignals()) return work();
    const auto result = std::make_shared<std::optional<decltype(work())>>();
    runBeside([work = std::forward<Work>(work), result]() mutable { result->emplace(work()); });
    return std::move(**result);
}

}  // namespace nacre::python
