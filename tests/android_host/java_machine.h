#pragma once
// A Java machine of a few classes: what the shell asks of an intent and of the provider of its document. It is strict:
// a call with an exception pending, an unknown method or a reference that is not given back is a fault.

#include <jni.h>

#include <memory>
#include <optional>
#include <string>

namespace nacre::test {

/// A document of another app, and how its provider behaves.
struct Document {
    std::string uri = "content://org.example.files/document/7";
    std::string name;  ///< empty: the provider keeps none
    std::string bytes;
    bool hasDescriptor = true;  ///< else it comes as a stream
    bool refuses = false;       ///< throws SecurityException
    double seconds = 0;         ///< that it takes to open
};

class JavaMachine {
public:
    /// @param document of the activity's intent; nothing: it was started from the launcher
    explicit JavaMachine(std::optional<Document> document);
    /// Tells of references that are left.
    ~JavaMachine();
    JavaMachine(const JavaMachine&) = delete;

    JavaVM* vm();
    JNIEnv* env();  ///< of the thread that made the machine
    jobject activity();

    struct Impl;

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace nacre::test
