// The activity's callbacks, which Android calls on the main thread. Each reports its event to the render thread. Some
// wait for it, a few seconds in total: Android reports an app as not responding after 5.

#include <android/configuration.h>
#include <android/keycodes.h>
#include <android/looper.h>
#include <android/native_activity.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/android/input.h"
#include "app/android/intent.h"
#include "app/android/log.h"
#include "app/android/platform.h"
#include "app/android/render_thread.h"
#include "app/android/session.h"
#include "app/download/database_id.h"
#include "app/viewer/kept_files.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr double kRedrawPatience = 1;  // seconds, for a picture of the window's new size
constexpr double kPointsPerInch = 160;

/// Pixels per point of the activity's display.
double readPixelDensity(const ANativeActivity* activity) {
    AConfiguration* configuration = AConfiguration_new();
    AConfiguration_fromAssetManager(configuration, activity->assetManager);
    const std::int32_t density = AConfiguration_getDensity(configuration);
    AConfiguration_delete(configuration);
    const bool known = density > ACONFIGURATION_DENSITY_DEFAULT && density < ACONFIGURATION_DENSITY_ANY;
    return known ? density / kPointsPerInch : 1;
}

/// The saved view, if its files still exist.
std::optional<PictureDescription> stillThere(std::optional<PictureDescription> view) {
    std::error_code ignored;
    if (!view || view->input.path.starts_with("sample:") || std::filesystem::exists(view->input.path, ignored))
        return view;
    try {
        if (parseDatabaseId(view->input.path)) return view;
    } catch (const std::exception& error) {
        logError(error.what());
    }
    return std::nullopt;
}

std::optional<PictureDescription> restoreView(const void* state, std::size_t size) {
    if (!state || size == 0) return std::nullopt;
    const auto view = viewOfState(std::string(static_cast<const char*>(state), size));
    if (!view) logError("the saved state is not a view");
    return view;
}

class App {
    ~App() = default;  // end()

public:
    App(ANativeActivity* activity, const void* state, std::size_t size)
        : activity_(activity),
          folder_(activity->internalDataPath),
          restored_(stillThere(restoreView(state, size))),
          density_(readPixelDensity(activity)),
          // A restored view shows the copy of the intent's document.
          platform_(activity, told()),
          cache_(platform_.cacheFolder().value_or(folder_)),
          document_(restored_ ? nullptr : openDocument(nullptr)),
          thread_(
              [this] {
                  if (session_) session_->awaitFrame();
              },
              [this] { return step(); }, [this](const char* why) { fail(why); }) {
        const PictureDescription first = firstView();
        {
            // Kept until the first step, which waits for the device.
            const std::lock_guard lock(mutex_);
            if (!first.input.path.empty()) view_ = first;
        }
        thread_.post(
            [this, first, density = density_, system = platform_.system(), validate = wantsValidation(activity)] {
                PhoneHost host;
                host.wake = [this] { thread_.post([] {}); };
                host.log = [](const std::string& text) { logError(text); };
                host.cache = cache_;
                host.system = system;
                host.validate = validate;
                platform_.lend(host);
                session_ = std::make_unique<AndroidSession>(std::move(host), first, density, folder_ + "/view.json");
                session_->onMotion([this](bool moving) { platform_.animate(moving); });
            });
        setHttpFetch([this](const std::string& url, const HttpTake& take) { platform_.fetch(url, take); }, this);
        if (document_) document_->open();
    }

    App(const App&) = delete;

    /// The activity ends. If a driver or the network blocks the session, this object lives until the session continues.
    void end() {
        detach();
        document_.reset();
        platform_.detach();
        setHttpFetch({}, this);
        ended_ = true;
        if (wait(RenderThread::Task([this] { session_.reset(); }))) return delete this;
        std::thread waits;
        const bool started = mayStart(waits, [this] {
            constexpr double kLong = 1e6;
            while (!thread_.call([] {}, kLong)) {
            }
            delete this;
        });
        if (started) waits.detach();  // else this object stays until the process ends
    }

    /// Calls a function of the session, on its thread.
    using Tell = Platform::Tell;
    void post(Tell tell) {
        thread_.post([this, tell = std::move(tell)] { tell(*session_); });
    }
    /// As above, and waits at most this many seconds.
    bool call(double seconds, Tell tell) {
        return thread_.call([this, tell = std::move(tell)] { tell(*session_); }, seconds);
    }
    /// As above within the remaining patience, summed over all waits.
    bool wait(RenderThread::Task task) {
        const double before = steadySeconds();
        const bool done = thread_.call(std::move(task), patience_);
        patience_ = std::max(patience_ - (steadySeconds() - before), 0.0);
        return done;
    }
    bool wait(Tell tell) {
        return wait(RenderThread::Task([this, tell = std::move(tell)] { tell(*session_); }));
    }
    void refillPatience() { patience_ = mainThreadPatience; }

    /// JSON; empty before the first step without an input. If the thread stays busy, the view of its last step.
    std::string lastView() {
        wait(Tell([](AndroidSession&) {}));
        const std::lock_guard lock(mutex_);
        return view_ ? savedViewJson(*view_) : std::string();
    }

    void readDensity() {
        density_ = readPixelDensity(activity_);
        post([density = density_](AndroidSession& s) { s.densityChanged(density); });
    }

    void attach(AInputQueue* queue) {
        queue_ = queue;
        AInputQueue_attachLooper(queue, ALooper_forThread(), ALOOPER_POLL_CALLBACK, &App::takeInput, this);
    }
    void detach() {
        if (queue_) AInputQueue_detachLooper(queue_);
        queue_ = nullptr;
    }

private:
    PictureDescription firstView() const {
        PictureDescription view;
        if (restored_) return *restored_;
        if (document_->present()) return view;
        if (const auto last = stillThere(loadView(folder_ + "/view.json"))) return *last;
        view.input.path = "sample:dna";
        return view;
    }

    /// @param uri  null: of the intent
    std::unique_ptr<IntentDocument> openDocument(jobject uri) {
        return std::make_unique<IntentDocument>(activity_, uri, OpenedFiles(folder_ + "/opened"),
                                                [this](Tell tell) { post(std::move(tell)); });
    }

    Platform::Told told() {
        Platform::Told told;
        told.post = [this](Tell tell) { post(std::move(tell)); };
        told.opened = [this](jobject uri) {
            document_.reset();
            document_ = openDocument(uri);
            document_->open();
        };
        told.controls = [this] {
            // From the first request on, the table is kept up to date.
            if (!read_.exchange(true)) thread_.post([] {});
            const std::lock_guard lock(mutex_);
            return lines_;
        };
        return told;
    }

    /// On the render thread, like the next two.
    double step() {
        if (!session_) return std::numeric_limits<double>::infinity();
        const double wake = session_->turn();
        if (read_) tellControls();
        if (wantsBack_.exchange(session_->wantsBack()) != wantsBack_) platform_.wantsBack(wantsBack_);
        const std::lock_guard lock(mutex_);
        view_ = session_->viewer().restartView();
        return wake;
    }

    void tellControls() {
        const std::string lines = controlLines(session_->spoken());
        {
            const std::lock_guard lock(mutex_);
            if (lines == lines_) return;
            lines_ = lines;
        }
        platform_.controlsChanged();
    }

    /// Without a device, shows only the reason.
    void fail(const char* why) {
        logError(why);
        if (session_) {
            session_->setSeen(false);
            session_->lowMemory();
        }
        if (!ended_ && !platform_.giveUp(why)) ANativeActivity_finish(activity_);
    }

    static int takeInput(int, int, void* app) {
        static_cast<App*>(app)->takeInput();
        return 1;
    }

    void takeInput() {
        AInputEvent* event = nullptr;
        while (queue_ && AInputQueue_getEvent(queue_, &event) >= 0) {
            if (AInputQueue_preDispatchEvent(queue_, event)) continue;
            AInputQueue_finishEvent(queue_, event, handle(event) ? 1 : 0);
        }
    }

    /// @returns whether this handled the event
    bool handle(const AInputEvent* event) {
        if (AInputEvent_getType(event) == AINPUT_EVENT_TYPE_KEY && AKeyEvent_getKeyCode(event) == AKEYCODE_BACK) {
            // Handles down and up alike, or Android takes half a key press for a whole one.
            const bool down = AKeyEvent_getAction(event) == AKEY_EVENT_ACTION_DOWN;
            if (down) ownsBack_ = wantsBack_;
            if (ownsBack_ && !down) post([](AndroidSession& s) { s.back(); });
            return ownsBack_;
        }
        if (const auto key = readKey(event)) {
            post([key = *key](AndroidSession& s) {
                if (const auto command = findCommand(key)) s.run(*command);
            });
            return true;
        }
        if (const auto wheel = readWheel(event, density_)) {
            post([wheel = *wheel](AndroidSession& s) { s.wheel(wheel.steps, wheel.at); });
            return true;
        }
        if (const auto mouse = readMouse(event, density_)) {
            post([mouse = *mouse, when = eventSeconds(event)](AndroidSession& s) {
                s.mouse(mouse.button, mouse.touch, mouse.with, when);
            });
            return true;
        }
        if (isExploring(event)) {
            platform_.explore(readHover(event, 1)->at);
            return true;
        }
        if (const auto hover = readHover(event, density_)) {
            post([hover = *hover](AndroidSession& s) { s.hover(hover.at); });
            return true;
        }
        auto touches = readTouches(event, density_);
        if (touches.empty()) return false;
        post([touches = std::move(touches), when = eventSeconds(event)](AndroidSession& s) {
            for (const TouchEvent& touch : touches) s.touch(touch, when);
        });
        return true;
    }

    ANativeActivity* activity_;
    std::string folder_;
    std::optional<PictureDescription> restored_;
    double density_;
    AInputQueue* queue_ = nullptr;
    bool ownsBack_ = false;
    double patience_ = mainThreadPatience;
    std::atomic<bool> ended_{false};
    Platform platform_;
    std::string cache_;
    std::unique_ptr<IntentDocument> document_;
    // Readable by the main thread at any time
    std::atomic<bool> wantsBack_{false};  // the back key is ours, to close the panel or the help
    std::atomic<bool> read_{false};       // a screen reader wants the controls
    std::mutex mutex_;
    std::optional<PictureDescription> view_;  // after the last step; guarded by the mutex
    std::string lines_;                       // likewise: controlLines() as last reported
    RenderThread thread_;
    std::unique_ptr<AndroidSession> session_;  // the thread's
};

App& toApp(ANativeActivity* activity) { return *static_cast<App*>(activity->instance); }

void* saveState(ANativeActivity* activity, std::size_t* size) {
    *size = 0;
    const std::string text = toApp(activity).lastView();
    void* state = text.empty() ? nullptr : std::malloc(text.size());
    if (!state) return nullptr;
    std::memcpy(state, text.data(), text.size());
    *size = text.size();
    return state;
}

void setCallbacks(ANativeActivityCallbacks& on) {
    on.onStart = [](ANativeActivity* a) { toApp(a).post([](AndroidSession& s) { s.started(); }); };
    on.onResume = [](ANativeActivity* a) { toApp(a).refillPatience(); };
    on.onPause = [](ANativeActivity* a) { toApp(a).wait(App::Tell([](AndroidSession& s) { s.paused(); })); };
    on.onStop = [](ANativeActivity* a) { toApp(a).post([](AndroidSession& s) { s.stopped(); }); };
    on.onSaveInstanceState = saveState;
    on.onLowMemory = [](ANativeActivity* a) { toApp(a).post([](AndroidSession& s) { s.lowMemory(); }); };
    on.onConfigurationChanged = [](ANativeActivity* a) { toApp(a).readDensity(); };
    on.onNativeWindowCreated = [](ANativeActivity* a, ANativeWindow* window) {
        toApp(a).post([window](AndroidSession& s) { s.windowCreated(window); });
    };
    on.onNativeWindowResized = [](ANativeActivity* a, ANativeWindow*) {
        toApp(a).post([](AndroidSession& s) { s.windowChanged(); });
    };
    on.onNativeWindowRedrawNeeded = [](ANativeActivity* a, ANativeWindow*) {
        toApp(a).call(kRedrawPatience, [](AndroidSession& s) { s.windowChanged(); });
    };
    on.onNativeWindowDestroyed = [](ANativeActivity* a, ANativeWindow*) {
        toApp(a).wait(App::Tell([](AndroidSession& s) { s.windowDestroyed(); }));
    };
    on.onContentRectChanged = [](ANativeActivity* a, const ARect* content) {
        toApp(a).post([content = *content](AndroidSession& s) { s.contentChanged(content); });
    };
    on.onInputQueueCreated = [](ANativeActivity* a, AInputQueue* queue) { toApp(a).attach(queue); };
    on.onInputQueueDestroyed = [](ANativeActivity* a, AInputQueue*) { toApp(a).detach(); };
    on.onDestroy = [](ANativeActivity* a) {
        toApp(a).end();
        a->instance = nullptr;
    };
}

}  // namespace
}  // namespace nacre::app

extern "C" __attribute__((visibility("default"))) void ANativeActivity_onCreate(ANativeActivity* activity, void* state,
                                                                                std::size_t size) {
    nacre::app::setCallbacks(*activity->callbacks);
    activity->instance = new nacre::app::App(activity, state, size);
}
