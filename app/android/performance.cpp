#include "app/android/performance.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>

struct APerformanceHintManager;

namespace nacre::app {
namespace {

constexpr double kHeatSeconds = 10;  // between queries; the system answers one per second
constexpr int kForecast = 10;        // seconds

// As the NDK declares them in <android/native_window.h>, <android/thermal.h> and <android/performance_hint.h>.
using SetFrameRate = std::int32_t (*)(ANativeWindow*, float, std::int8_t);
using AcquireThermal = AThermalManager* (*)();
using ReleaseThermal = void (*)(AThermalManager*);
using ThermalHeadroom = float (*)(AThermalManager*, int);
using HintManager = APerformanceHintManager* (*)();
using CreateHints = APerformanceHintSession* (*)(APerformanceHintManager*, const std::int32_t*, std::size_t,
                                                 std::int64_t);
using SetWorkDuration = int (*)(APerformanceHintSession*, std::int64_t);
using CloseHints = void (*)(APerformanceHintSession*);

/// Null: this version of Android lacks it.
template <typename Function>
Function system(const char* name) {
    static void* const library = dlopen("libandroid.so", RTLD_NOW);
    return reinterpret_cast<Function>(dlsym(library ? library : RTLD_DEFAULT, name));
}

std::int64_t nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

}  // namespace

Performance::~Performance() {
    if (const auto release = system<ReleaseThermal>("AThermal_releaseManager"); release && thermal_) release(thermal_);
    if (const auto close = system<CloseHints>("APerformanceHint_closeSession"); close && hints_) close(hints_);
}

void Performance::setFrameRate(ANativeWindow* window, double rate) {
    constexpr std::int8_t kCompatibilityDefault = 0;
    static const auto set = system<SetFrameRate>("ANativeWindow_setFrameRate");
    if (set && window) set(window, static_cast<float>(rate), kCompatibilityDefault);
}

double Performance::heatAt(double now) {
    static const auto headroom = system<ThermalHeadroom>("AThermal_getThermalHeadroom");
    if (!headroom || now < asked_ + kHeatSeconds) return heat_;
    asked_ = now;
    if (!begun_)
        if (const auto acquire = system<AcquireThermal>("AThermal_acquireManager")) thermal_ = acquire();
    begun_ = true;
    const float told = thermal_ ? headroom(thermal_, kForecast) : 0.0f;
    if (std::isfinite(told)) heat_ = told;  // NaN: the device does not know yet
    return heat_;
}

void Performance::worked(double seconds, double target) {
    static const auto report = system<SetWorkDuration>("APerformanceHint_reportActualWorkDuration");
    static const auto update = system<SetWorkDuration>("APerformanceHint_updateTargetWorkDuration");
    if (!report || !update || seconds <= 0) return;
    if (!hintsBegun_) {
        const auto manager = system<HintManager>("APerformanceHint_getManager");
        const auto create = system<CreateHints>("APerformanceHint_createSession");
        const std::int32_t thread = gettid();
        APerformanceHintManager* const hints = manager && create ? manager() : nullptr;
        if (hints) hints_ = create(hints, &thread, 1, nanoseconds(target));
        target_ = target;
    }
    hintsBegun_ = true;
    if (!hints_) return;  // a device without them
    if (target != target_) update(hints_, nanoseconds(target_ = target));
    report(hints_, nanoseconds(seconds));
}

}  // namespace nacre::app
