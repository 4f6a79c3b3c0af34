#pragma once
// The document that the activity was started with, or that the user picked.

#include <android/native_activity.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "app/android/java.h"
#include "app/android/opened_files.h"
#include "app/android/session.h"

namespace nacre::app {

/// Whether the intent enables the validation layer: `adb shell am start -n org.nacre.viewer/.NacreActivity --ez
/// validate true`. Call on the main thread.
bool wantsValidation(ANativeActivity* activity);

class IntentDocument {
public:
    using Post = std::function<void(std::function<void(AndroidSession&)>)>;

    /// Call on the main thread, like all members.
    /// @param uri  of the document; null: the one that started the activity
    /// @param post  reports to the session on its thread: the copy, or the error
    IntentDocument(ANativeActivity* activity, jobject uri, OpenedFiles files, Post post);
    /// Abandons an unfinished copy: a provider may take any time.
    ~IntentDocument();
    IntentDocument(const IntentDocument&) = delete;

    /// Whether the intent names a document.
    bool present() const { return work_->uri != nullptr; }
    /// Copies it on a worker thread: a provider may fetch it from a network.
    void open();

private:
    /// Data of the copying thread, which may outlive the activity.
    struct Work {
        JavaVM* machine = nullptr;
        jobject activity = nullptr, uri = nullptr;  // global references
        OpenedFiles files{""};
        std::mutex mutex;
        Post post;  // empty: the result is not needed
        void run();
        std::string copy(const Java& java) const;
        void release(JNIEnv* env);
    };

    JNIEnv* env_;
    std::shared_ptr<Work> work_;
    bool opened_ = false;
};

}  // namespace nacre::app
