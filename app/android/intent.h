#pragma once
// The document that the activity was started to show, or one that was picked.

#include <android/native_activity.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "app/android/java.h"
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
    /// What is still being copied is let go of: a provider may take any time.
    ~IntentDocument();
    IntentDocument(const IntentDocument&) = delete;

    /// Whether the intent names a document at all.
    bool present() const { return work_->uri != nullptr; }
    /// Opens it, on a thread of its own: a provider may fetch it from a network.
    void open();

private:
    /// What the copying thread has, which outlives the activity if it has to.
    struct Work {
        JavaVM* machine = nullptr;
        jobject activity = nullptr, uri = nullptr;  // global references
        OpenedFiles files{""};
        std::mutex mutex;
        Post post;  // empty: nobody waits for it any more
        void run();
        std::string copy(const Java& java) const;
        void release(JNIEnv* env);
    };

    JNIEnv* env_;
    std::shared_ptr<Work> work_;
    bool opened_ = false;
};

}  // namespace nacre::app
