#include "tests/android_host/host.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace nacre::test {
namespace {

std::int64_t nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

Host::Host(const std::filesystem::path& folder, std::optional<Document> document, const std::string& state,
           std::int32_t density)
    : folder_(folder.string()), java_(std::move(document), folder_ + "/cache") {
    assets_.density = density;
    activity_.callbacks = &callbacks_;
    activity_.vm = java_.vm();
    activity_.env = java_.env();
    activity_.clazz = java_.activity();
    activity_.internalDataPath = folder_.c_str();
    activity_.externalDataPath = nullptr;
    activity_.sdkVersion = 34;
    activity_.assetManager = &assets_;
    // A copy, as the system's goes when the call returns.
    std::vector<char> bytes(state.begin(), state.end());
    ANativeActivity_onCreate(&activity_, bytes.empty() ? nullptr : bytes.data(), bytes.size());
}

Host::~Host() {
    if (alive_) destroy();
}

void Host::start() {
    started_ = true;
    if (callbacks_.onStart) callbacks_.onStart(&activity_);
}

void Host::resume() {
    resumed_ = true;
    if (callbacks_.onResume) callbacks_.onResume(&activity_);
}

void Host::pause() {
    resumed_ = false;
    if (callbacks_.onPause) callbacks_.onPause(&activity_);
}

void Host::stop() {
    started_ = false;
    if (callbacks_.onStop) callbacks_.onStop(&activity_);
}

void Host::destroy() {
    if (resumed_) pause();
    if (started_) stop();
    if (window_) destroyWindow();
    if (queue_) destroyQueue();
    callbacks_.onDestroy(&activity_);
    alive_ = false;
    if (activity_.instance) Faults::add("an instance left behind");
}

void Host::open(std::int32_t width, std::int32_t height, int quarterTurns) {
    start();
    resume();
    createQueue();
    createWindow(width, height, quarterTurns);
}

std::string Host::saveState() {
    std::size_t size = 0;
    void* state = callbacks_.onSaveInstanceState(&activity_, &size);
    const std::string text = state ? std::string(static_cast<const char*>(state), size) : std::string();
    std::free(state);
    return text;
}

void Host::lowMemory() { callbacks_.onLowMemory(&activity_); }

void Host::setDensity(std::int32_t density) {
    assets_.density = density;
    callbacks_.onConfigurationChanged(&activity_);
}

void Host::setContent(const ARect& content) {
    const ARect passing = content;
    callbacks_.onContentRectChanged(&activity_, &passing);
}

void Host::createWindow(std::int32_t width, std::int32_t height, int quarterTurns) {
    window_ = std::make_unique<ANativeWindow>();
    window_->width = width;
    window_->height = height;
    window_->quarterTurns = quarterTurns;
    callbacks_.onNativeWindowCreated(&activity_, window_.get());
    setContent({0, 0, width, height});
    redraw();
}

void Host::resizeWindow(std::int32_t width, std::int32_t height, int quarterTurns) {
    {
        const std::lock_guard lock(window_->mutex);
        window_->width = width;
        window_->height = height;
        window_->quarterTurns = quarterTurns;
    }
    callbacks_.onConfigurationChanged(&activity_);
    callbacks_.onNativeWindowResized(&activity_, window_.get());
    setContent({0, 0, width, height});
    redraw();
}

void Host::redraw() { callbacks_.onNativeWindowRedrawNeeded(&activity_, window_.get()); }

void Host::destroyWindow() {
    callbacks_.onNativeWindowDestroyed(&activity_, window_.get());
    const std::lock_guard lock(window_->mutex);
    window_->alive = false;
    if (window_->surfaces != 0 && !heldUp_) Faults::add("a surface is left of a window that goes");
    gone_.push_back(std::move(window_));
}

bool Host::windowsAreLetGo() const {
    return std::all_of(gone_.begin(), gone_.end(), [](const auto& window) {
        const std::lock_guard lock(window->mutex);
        return window->surfaces == 0 && window->references == 0;
    });
}

void Host::createQueue() {
    queue_ = std::make_unique<AInputQueue>();
    callbacks_.onInputQueueCreated(&activity_, queue_.get());
}

void Host::destroyQueue() {
    callbacks_.onInputQueueDestroyed(&activity_, queue_.get());
    if (queue_->callback) Faults::add("a queue that goes is still attached");
    queue_.reset();
}

bool Host::motion(std::int32_t action, std::vector<AInputEvent::Pointer> pointers, double later) {
    AInputEvent event;
    event.action = action;
    event.pointers = std::move(pointers);
    event.time = nanoseconds() + static_cast<std::int64_t>(later * 1e9);
    return queue_->deliver(std::move(event));
}

// Events say when they happened: a machine that is busy makes no slow hand.

void Host::tap(float x, float y, int times) {
    for (int i = 0; i < times; ++i) {
        motion(AMOTION_EVENT_ACTION_DOWN, {{0, x, y}}, 0.1 * i);
        motion(AMOTION_EVENT_ACTION_UP, {{0, x, y}}, 0.1 * i + 0.02);
    }
}

void Host::drag(float fromX, float fromY, float toX, float toY, int steps) {
    motion(AMOTION_EVENT_ACTION_DOWN, {{0, fromX, fromY}});
    for (int i = 1; i <= steps; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(steps);
        motion(AMOTION_EVENT_ACTION_MOVE, {{0, fromX + t * (toX - fromX), fromY + t * (toY - fromY)}}, 0.01 * i);
    }
    // The hand rests before it lets go: no inertia.
    motion(AMOTION_EVENT_ACTION_UP, {{0, toX, toY}}, 0.01 * steps + 0.5);
}

bool Host::key(std::int32_t code, std::int32_t action, std::int32_t meta) {
    AInputEvent event;
    event.type = AINPUT_EVENT_TYPE_KEY;
    event.source = AINPUT_SOURCE_KEYBOARD;
    event.action = action;
    event.key = code;
    event.meta = meta;
    return queue_->deliver(std::move(event));
}

bool Host::pointer(std::int32_t tool, std::int32_t action, float x, float y, std::int32_t buttons) {
    AInputEvent event;
    event.tool = tool;
    event.source = tool == AMOTION_EVENT_TOOL_TYPE_MOUSE ? AINPUT_SOURCE_MOUSE : AINPUT_SOURCE_STYLUS;
    event.action = action;
    event.pointers = {{0, x, y}};
    event.buttons = buttons;
    event.time = nanoseconds();
    return queue_->deliver(std::move(event));
}

bool Host::back() {
    const bool down = key(AKEYCODE_BACK, AKEY_EVENT_ACTION_DOWN);
    const bool up = key(AKEYCODE_BACK, AKEY_EVENT_ACTION_UP);
    if (down != up) Faults::add("half a back key was taken");
    return up;
}

bool Host::scroll(float steps, float x, float y) {
    AInputEvent event;
    event.source = AINPUT_SOURCE_MOUSE;
    event.action = AMOTION_EVENT_ACTION_SCROLL;
    event.pointers = {{0, x, y}};
    event.scroll = steps;
    event.time = nanoseconds();
    return queue_->deliver(std::move(event));
}

std::uint64_t Host::frames() const {
    const ANativeWindow& window = window_ ? *window_ : *gone_.back();
    const std::lock_guard lock(const_cast<ANativeWindow&>(window).mutex);
    return window.frames;
}

WindowPicture Host::picture() const {
    const std::lock_guard lock(window_->mutex);
    return window_->picture;
}

}  // namespace nacre::test
