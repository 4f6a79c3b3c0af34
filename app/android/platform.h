#pragma once
// What the activity's Java does for the native code (NacreActivity.java), and what it is told of.

#include <android/native_activity.h>
#include <jni.h>

#include <functional>
#include <string>

#include "app/download/http_host.h"
#include "engine/results.h"

namespace nacre::app {

class Platform {
public:
    /// Called on the main thread.
    struct Told {
        std::function<void(jobject uri)> opened;  ///< a document was picked
        std::function<void(const std::string& why)> failed;
        std::function<std::string()> controls;  ///< controlLines()
        std::function<void(const std::string& role, const std::string& name)> press;
        std::function<void(const std::string& name, bool up)> adjust;                 ///< a slider
        std::function<void(const std::string& name, const std::string& text)> typed;  ///< into a field
        std::function<void(double rate)> refreshes;  ///< of the display, a second: at first, and when it changes
    };

    /// On the main thread, like the destructor. An activity without that Java is left alone.
    Platform(ANativeActivity* activity, Told told);
    ~Platform();
    Platform(const Platform&) = delete;

    bool there() const { return there_; }
    // From any thread
    /// As HttpFetch.
    void fetch(const std::string& url, const HttpTake& take) const;
    void pickDocument() const;
    /// @param name  of the file, with its end
    void share(const Picture& picture, const std::string& name) const;
    void shareText(const std::string& text, const std::string& name) const;
    void controlsChanged() const;
    /// Shows the keyboard for a field.
    void askText(const std::string& name, const std::string& text) const;

private:
    template <typename Call>
    void call(const Call& call) const;

    ANativeActivity* activity_;
    Told told_;
    bool there_ = false;
};

}  // namespace nacre::app
