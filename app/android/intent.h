#pragma once
// The document that the activity was started to show, or one that was picked.

#include <android/native_activity.h>

#include <functional>
#include <string>
#include <thread>

#include "app/android/opened_files.h"

namespace nacre::app {

class IntentDocument {
public:
    using Done = std::function<void(const std::string& path)>;
    using Failed = std::function<void(const std::string& why)>;

    /// Call on the main thread, like all the rest.
    /// @param uri  of the document; null: what the activity was started to show
    /// @param done, failed one of them is called on the other thread
    IntentDocument(ANativeActivity* activity, jobject uri, OpenedFiles files, Done done, Failed failed);
    /// Waits for the thread.
    ~IntentDocument();
    IntentDocument(const IntentDocument&) = delete;

    /// Whether the intent names a document at all.
    bool present() const { return uri_ != nullptr; }
    /// Opens it, on a thread of its own: a provider may fetch it from a network.
    void open();

private:
    void copy() const;

    ANativeActivity* activity_;
    OpenedFiles files_;
    Done done_;
    Failed failed_;
    jobject uri_ = nullptr;  // a global reference
    std::thread thread_;
};

}  // namespace nacre::app
