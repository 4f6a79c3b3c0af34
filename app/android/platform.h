#pragma once
// Functions of the activity's Java part for the native code (NacreActivity.java), and its callbacks.

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

    /// Callbacks from Java, on the main thread.
    struct Told {
        std::function<void(Tell)> post;           ///< runs a report on the session's thread
        std::function<void(jobject uri)> opened;  ///< the user picked a document
        std::function<std::string()> controls;    ///< controlLines()
    };

    /// On the main thread, as detach(). Does nothing for an activity without that Java part.
    Platform(ANativeActivity* activity, Told told);
    ~Platform();
    Platform(const Platform&) = delete;
    /// The activity ends: no more calls or callbacks.
    void detach();
    /// "Android 16, Example Phone"
    std::string system() const;
    /// A folder that the system may empty at any time; empty: unknown.
    std::optional<std::string> cacheFolder() const;

    // Adds the functions that a session may call. Thread-safe.
    void lend(PhoneHost& host) const;
    /// Like HttpFetch.
    void fetch(const std::string& url, const HttpTake& take) const;
    void controlsChanged() const;
    /// Shows why nothing can be drawn, then ends the activity. @returns false if there is no way to show it
    bool giveUp(const std::string& why) const;
    /// A finger explores by touch. On the main thread. @param at  pixels of the window; empty: it left
    void explore(std::optional<glm::dvec2> at) const;
    /// Whether the app handles Back, to close what lies over the picture; otherwise the system does.
    void wantsBack(bool wanted) const;
    /// Whether frames are drawn continuously: requests the display's ticks.
    void animate(bool on) const;

private:
    template <typename... Values>
    bool ask(const char* method, const char* signature, const Values&... values) const;
    template <typename Call>
    bool call(const Call& call) const;
    void share(const PictureBytes& picture, const std::string& name) const;

    std::thread::id main_ = std::this_thread::get_id();
    JNIEnv* env_;  // of the main thread
    JavaVM* machine_;
    jobject object_;  // the activity, as a global reference
    Told told_;
    std::atomic<bool> there_{false};
};

}  // namespace nacre::app
