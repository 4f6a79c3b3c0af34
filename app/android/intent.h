#pragma once
// The document that the activity was started to show, or one that was picked.

#include <android/native_activity.h>

#include <functional>
#include <string>
#include <thread>

#include "app/android/opened_files.h"
#include "app/android/session.h"

namespace nacre::app {

class IntentDocument {
public:
    using Post = std::function<void(std::function<void(AndroidSession&)>)>;

    /// Call on the main thread, like all the rest.
    /// @param uri  of the document; null: what the activity was started to show
    /// @param post  has the session told, on the other thread: of the copy, or why there is none
    IntentDocument(ANativeActivity* activity, jobject uri, OpenedFiles files, Post post);
    /// Waits for the thread.
    ~IntentDocument();
    IntentDocument(const IntentDocument&) = delete;

    /// Whether the intent names a document at all.
    bool present() const { return uri_ != nullptr; }
    /// Opens it, on a thread of its own: a provider may fetch it from a network.
    void open();

private:
    std::string copy() const;

    ANativeActivity* activity_;
    OpenedFiles files_;
    Post post_;
    jobject uri_ = nullptr;  // a global reference
    std::thread thread_;
};

}  // namespace nacre::app
