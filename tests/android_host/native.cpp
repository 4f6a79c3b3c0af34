#include "tests/android_host/native.h"

#include <android/log.h>

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <set>
#include <utility>

#include "tests/android_host/window.h"

struct AConfiguration {
    std::int32_t density = ACONFIGURATION_DENSITY_DEFAULT;
};

struct ALooper {};

namespace {

using nacre::test::Faults;

std::mutex mutex;
std::vector<std::string> lines;
std::set<const ANativeActivity*> finishes;
std::atomic<int> reports{0}, hintSessions{0}, thermalManagers{0};
std::atomic<std::int64_t> target{0};
ALooper looper;

}  // namespace

namespace nacre::test {

std::vector<std::string> takeLog() {
    const std::lock_guard lock(mutex);
    return std::exchange(lines, {});
}

int workReports() { return reports; }
std::int64_t workTarget() { return target; }

bool finishAsked(const ANativeActivity* activity) {
    const std::lock_guard lock(mutex);
    return finishes.contains(activity);
}

}  // namespace nacre::test

bool AInputQueue::deliver(AInputEvent event) {
    waiting.push_back(std::make_unique<AInputEvent>(std::move(event)));
    const int before = handled;
    if (callback && callback(0, ALOOPER_EVENT_INPUT, data) != 1) Faults::add("the looper was told to call no more");
    if (callback && !waiting.empty()) Faults::add("an event was left in the queue");
    if (!taken.empty()) Faults::add("an event was not finished");
    return handled > before;
}

extern "C" {

int __android_log_print(int, const char* tag, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char text[1024];
    const int length = std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const std::lock_guard lock(mutex);
    lines.push_back(std::string(tag) + ": " + text);
    return length;
}

void ANativeActivity_finish(ANativeActivity* activity) {
    const std::lock_guard lock(mutex);
    finishes.insert(activity);
}

// --- window

void ANativeWindow_acquire(ANativeWindow* window) {
    const std::lock_guard lock(window->mutex);
    if (!window->alive) Faults::add("took a window that is gone");
    ++window->references;
}

void ANativeWindow_release(ANativeWindow* window) {
    const std::lock_guard lock(window->mutex);
    --window->references;
}

int32_t ANativeWindow_getWidth(ANativeWindow* window) {
    const std::lock_guard lock(window->mutex);
    if (window->references < 1) Faults::add("asked the width of a window that may be gone");
    return window->width;
}

int32_t ANativeWindow_getHeight(ANativeWindow* window) {
    const std::lock_guard lock(window->mutex);
    if (window->references < 1) Faults::add("asked the height of a window that may be gone");
    return window->height;
}

// --- what newer systems have, which is looked up by name

struct AThermalManager {};
struct APerformanceHintManager {};
struct APerformanceHintSession {};

int32_t ANativeWindow_setFrameRate(ANativeWindow* window, float rate, int8_t) {
    const std::lock_guard lock(window->mutex);
    window->rate = rate;
    return 0;
}

AThermalManager* AThermal_acquireManager() { return ++thermalManagers, new AThermalManager; }
void AThermal_releaseManager(AThermalManager* manager) { --thermalManagers, delete manager; }
float AThermal_getThermalHeadroom(AThermalManager*, int forecast) {
    if (forecast < 0 || forecast > 60) Faults::add("a forecast that Android does not make");
    return 0;
}

APerformanceHintManager* APerformanceHint_getManager() {
    static APerformanceHintManager only;
    return &only;
}
APerformanceHintSession* APerformanceHint_createSession(APerformanceHintManager*, const int32_t* threads, size_t count,
                                                        int64_t nanoseconds) {
    if (count != 1 || threads[0] <= 0 || nanoseconds <= 0) Faults::add("hints of no thread or no time");
    target = nanoseconds;
    return ++hintSessions, new APerformanceHintSession;
}
int APerformanceHint_updateTargetWorkDuration(APerformanceHintSession*, int64_t nanoseconds) {
    target = nanoseconds;
    return 0;
}
int APerformanceHint_reportActualWorkDuration(APerformanceHintSession*, int64_t nanoseconds) {
    if (nanoseconds <= 0) Faults::add("work that takes no time");
    ++reports;
    return 0;
}
void APerformanceHint_closeSession(APerformanceHintSession* session) { --hintSessions, delete session; }

// --- configuration

AConfiguration* AConfiguration_new() { return new AConfiguration; }
void AConfiguration_delete(AConfiguration* configuration) { delete configuration; }
void AConfiguration_fromAssetManager(AConfiguration* out, AAssetManager* manager) { out->density = manager->density; }
int32_t AConfiguration_getDensity(AConfiguration* configuration) { return configuration->density; }

// --- input

ALooper* ALooper_forThread() { return &looper; }

void AInputQueue_attachLooper(AInputQueue* queue, ALooper* to, int, ALooper_callbackFunc callback, void* data) {
    if (to != &looper || queue->callback) Faults::add("a queue attached twice, or to another looper");
    queue->callback = callback;
    queue->data = data;
}

void AInputQueue_detachLooper(AInputQueue* queue) { queue->callback = nullptr; }

int32_t AInputQueue_getEvent(AInputQueue* queue, AInputEvent** event) {
    if (queue->waiting.empty()) return -1;
    *event = queue->waiting.front().get();
    queue->taken[*event] = std::move(queue->waiting.front());
    queue->waiting.pop_front();
    return 0;
}

int32_t AInputQueue_preDispatchEvent(AInputQueue* queue, AInputEvent* event) {
    if (!queue->inputMethodTakesNext) return 0;
    queue->inputMethodTakesNext = false;
    queue->taken.erase(event);  // the input method finishes it
    return 1;
}

void AInputQueue_finishEvent(AInputQueue* queue, AInputEvent* event, int handled) {
    if (queue->taken.erase(event) == 0) Faults::add("an event finished that was not taken");
    ++(handled ? queue->handled : queue->refused);
}

int32_t AInputEvent_getType(const AInputEvent* event) { return event->type; }
int32_t AInputEvent_getSource(const AInputEvent* event) { return event->source; }
int32_t AKeyEvent_getAction(const AInputEvent* event) { return event->action; }
int32_t AKeyEvent_getKeyCode(const AInputEvent* event) { return event->key; }
int32_t AKeyEvent_getMetaState(const AInputEvent* event) { return event->meta; }
int32_t AMotionEvent_getAction(const AInputEvent* event) { return event->action; }
int32_t AMotionEvent_getToolType(const AInputEvent* event, size_t) { return event->tool; }
int32_t AMotionEvent_getButtonState(const AInputEvent* event) { return event->buttons; }
int32_t AMotionEvent_getMetaState(const AInputEvent* event) { return event->meta; }
int64_t AMotionEvent_getEventTime(const AInputEvent* event) { return event->time; }
size_t AMotionEvent_getPointerCount(const AInputEvent* event) { return event->pointers.size(); }
int32_t AMotionEvent_getPointerId(const AInputEvent* event, size_t i) { return event->pointers.at(i).id; }
float AMotionEvent_getX(const AInputEvent* event, size_t i) { return event->pointers.at(i).x; }
float AMotionEvent_getY(const AInputEvent* event, size_t i) { return event->pointers.at(i).y; }
float AMotionEvent_getAxisValue(const AInputEvent* event, int32_t axis, size_t) {
    return axis == AMOTION_EVENT_AXIS_VSCROLL ? event->scroll : 0;
}

}  // extern "C"
