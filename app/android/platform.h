#pragma once
// What the activity's Java does for the native code (NacreActivity.java), and what it is told of.

#include <android/native_activity.h>
#include <jni.h>

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "app/android/session.h"
#include "app/download/http_host.h"

namespace nacre::app {

class Platform {
public:
    using Tell = std::function<void(AndroidSession&)>;

    /// What Java calls, on the main thread.
    struct Told {
        std::function<void(Tell)> post;           ///< what the session hears of, on its own thread
        std::function<void(jobject uri)> opened;  ///< a document was picked
        std::function<std::string()> controls;    ///< controlLines()
    };

    /// On the main thread, like detach(). An activity without that Java is left alone.
    Platform(ANativeActivity* activity, Told told);
    ~Platform();
    Platform(const Platform&) = delete;
    /// The activity goes: nothing is asked of it any more, and it tells nothing.
    void detach();
    /// "Android 16, Example Phone"
    std::string system() const;
    /// Of what the system may delete at any time. Nothing: it is not told.
    std::optional<std::string> cacheFolder() const;

    // From any thread
    /// What a session may ask of it.
    void lend(PhoneHost& host) const;
    /// As HttpFetch.
    void fetch(const std::string& url, const HttpTake& take) const;
    void controlsChanged() const;
    /// Back is the app's from now on, to close what lies over the picture, or the system's again.
    void wantsBack(bool wanted) const;
    /// Frame after frame is drawn: the display's ticks are wanted.
    void animate(bool on) const;

private:
    template <typename... Values>
    void ask(const char* method, const char* signature, const Values&... values) const;
    template <typename Call>
    void call(const Call& call) const;
    void share(const PictureBytes& picture, const std::string& name) const;

    std::thread::id main_ = std::this_thread::get_id();
    JNIEnv* env_;  // of the main thread
    JavaVM* machine_;
    jobject object_;  // the activity, by a reference of our own
    Told told_;
    std::atomic<bool> there_{false};
};

}  // namespace nacre::app
