#pragma once
// What the activity's Java does for the native code (NacreActivity.java), and what it is told of.

#include <android/native_activity.h>
#include <jni.h>

#include <functional>
#include <string>

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

    /// On the main thread, like the destructor. An activity without that Java is left alone.
    Platform(ANativeActivity* activity, Told told);
    ~Platform();
    Platform(const Platform&) = delete;

    // From any thread
    /// What a session may ask of it.
    void lend(PhoneHost& host) const;
    /// As HttpFetch.
    void fetch(const std::string& url, const HttpTake& take) const;
    void controlsChanged() const;

private:
    template <typename... Texts>
    void ask(const char* method, const char* signature, const Texts&... texts) const;
    template <typename Call>
    void call(const Call& call) const;
    void share(const PictureBytes& picture, const std::string& name) const;

    ANativeActivity* activity_;
    Told told_;
    bool there_ = false;
};

}  // namespace nacre::app
