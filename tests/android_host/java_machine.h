#pragma once
// A Java machine of a few classes: what the shell asks of an intent and of the provider of its document. It is strict:
// a call with an exception pending, an unknown method or a reference that is not given back is a fault.

#include <jni.h>

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace nacre::test {

/// A document of another app, and how its provider behaves.
struct Document {
    std::string uri = "content://org.example.files/document/7";
    std::string name;  ///< empty: the provider keeps none
    std::string bytes;
    bool sent = false;                    ///< by ACTION_SEND, else to be viewed
    bool hasDescriptor = true;            ///< else it comes as a stream
    bool refuses = false;                 ///< throws SecurityException
    double seconds = 0;                   ///< that it takes to open
    std::shared_future<void> opens = {};  ///< when it does, if it has to be waited for
};

/// Whether intents switch the validation layer on.
inline bool intentValidates = false;

class JavaMachine {
public:
    /// @param document of the activity's intent; nothing: it was started from the launcher
    /// @param cache  the app's cache folder
    JavaMachine(std::optional<Document> document, const std::string& cache);
    /// Tells of references that are left.
    ~JavaMachine();
    JavaMachine(const JavaMachine&) = delete;

    JavaVM* vm();
    JNIEnv* env();  ///< of the thread that made the machine
    jobject activity();

    // The activity's Java: what native code asked it for, and what it tells native code. Main thread.
    int controlChanges() const;
    /// Name and text of the field that native code asked to edit last.
    std::pair<std::string, std::string> asked() const;
    void typed(const std::string& name, const std::string& text);
    /// What the network has, by address.
    void serve(const std::string& url, const std::string& bytes);
    void documentPicked(const Document& document);
    std::string controls();
    void press(const std::string& role, const std::string& name);
    void displayRefreshes(float rate, float most);
    /// Another document, by an intent to the activity that is there.
    void newIntent(const Document& document) { documentPicked(document); }
    /// Whether Back is the app's; and the user's Back then.
    bool wantsBack() const;
    void back();
    /// Why the app cannot draw, as it tells the user; empty: it can.
    std::string gaveUp() const;
    /// Where a finger explored the window last, pixels.
    std::pair<double, double> explored() const;
    /// As the system asks for memory: 20 once the window is hidden, 40 in the background.
    void trim(int level);
    /// Whether native code wants to be told of the display's pictures; and one of them, now.
    bool animated() const;
    void tick();

    struct Impl;

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace nacre::test
