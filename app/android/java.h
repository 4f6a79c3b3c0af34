#pragma once
// Helpers for JNI calls.

#include <jni.h>

#include <stdexcept>
#include <string>

namespace nacre::app {

/// A Java exception, with its message.
class JavaError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A Java string from UTF-8, by way of UTF-16: NewStringUTF takes modified UTF-8 (emoji differ).
jstring newString(JNIEnv* env, const std::string& text);

/// JNI calls on one thread. Frees its local references when destroyed.
class Java {
public:
    explicit Java(JNIEnv* env);
    ~Java();
    Java(const Java&) = delete;

    JNIEnv* env() const { return env_; }
    /// @throws JavaError
    template <typename... Arguments>
    jobject object(jobject of, const char* method, const char* signature, Arguments... arguments) const {
        jobject result = env_->CallObjectMethod(of, findMethod(of, method, signature), arguments...);
        check();
        return result;
    }
    template <typename... Arguments>
    jint integer(jobject of, const char* method, const char* signature, Arguments... arguments) const {
        const jint result = env_->CallIntMethod(of, findMethod(of, method, signature), arguments...);
        check();
        return result;
    }
    template <typename... Arguments>
    bool boolean(jobject of, const char* method, const char* signature, Arguments... arguments) const {
        const jboolean result = env_->CallBooleanMethod(of, findMethod(of, method, signature), arguments...);
        check();
        return result == JNI_TRUE;
    }
    template <typename... Arguments>
    void nothing(jobject of, const char* method, const char* signature, Arguments... arguments) const {
        env_->CallVoidMethod(of, findMethod(of, method, signature), arguments...);
        check();
    }

    jstring string(const std::string& text) const;
    /// Empty for null.
    std::string text(jobject string) const;
    /// Throws a pending exception as JavaError.
    void check() const;

private:
    jmethodID findMethod(jobject of, const char* method, const char* signature) const;

    JNIEnv* env_;
};

/// Attaches this thread to the Java VM while the object lives.
class AttachedThread {
public:
    explicit AttachedThread(JavaVM* machine);
    ~AttachedThread();
    AttachedThread(const AttachedThread&) = delete;
    JNIEnv* env() const { return env_; }

private:
    JavaVM* machine_;
    JNIEnv* env_ = nullptr;
};

}  // namespace nacre::app
