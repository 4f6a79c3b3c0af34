#include "app/python/interrupt.h"

#include <pybind11/pybind11.h>

#include <atomic>

#include "engine/milliseconds.h"

namespace nacre::python {

void checkInterrupt() {
    constexpr std::chrono::milliseconds kBetween(50);  // the lock may be another thread's
    static std::atomic<Clock::duration> last{Clock::duration{}};
    const Clock::duration now = Clock::now().time_since_epoch();
    if (now - last.load() < kBetween) return;
    last = now;
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

}  // namespace nacre::python
