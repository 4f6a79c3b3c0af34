#pragma once
// Between the files of the Java machine: its objects, and what it keeps of threads and references.

#include <jni.h>

#include <atomic>
#include <cstdarg>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/android_host/java_machine.h"

namespace nacre::test {

inline constexpr const char* kActivity = "android/app/NativeActivity";

/// An object of the fake machine; jobject and its kin point to these.
struct Object : _jobject {
    std::string type, text;          // of a String, or of what a Throwable says
    std::vector<signed char> bytes;  // of a byte[]
    std::vector<jint> numbers;       // of an int[]
    std::size_t at = 0;              // of an InputStream
};

inline Object* in(jobject reference) { return static_cast<Object*>(reference); }

template <typename Reference>
Reference as(jobject object) {
    return static_cast<Reference>(object);
}

struct Method {
    std::string type, name, signature;
};

struct Thread {
    JNIEnv env{};
    std::vector<std::vector<jobject>> frames{{}};  // local references
    Object* pending = nullptr;
};

struct JavaMachine::Impl {
    Impl(std::optional<Document> d, std::string cache) : document(std::move(d)), cacheFolder(std::move(cache)) {}

    Object* make(const std::string& type, const std::string& text = {}) {
        const std::lock_guard lock(mutex);
        objects.push_back(std::make_unique<Object>());
        objects.back()->type = type;
        objects.back()->text = text;
        return objects.back().get();
    }

    std::optional<Document> document;
    JNINativeInterface functions{};
    JNIInvokeInterface invoke{};
    JavaVM vm{};
    std::mutex mutex;
    std::deque<std::unique_ptr<Object>> objects;
    std::map<std::thread::id, std::unique_ptr<Thread>> threads;
    std::vector<jobject> globals;
    std::deque<Method> methods;
    Object* activity = nullptr;
    JNIEnv* mainEnv = nullptr;
    int opened = 0, closed = 0;  // streams and cursors
    std::map<std::string, void*> natives;
    jlong attached = 0;  // what native code has itself called by
    std::atomic<int> controlChanges{0};
    std::atomic<bool> wantsBack{false}, animated{false};
    std::string gaveUp;                  // under the mutex
    std::pair<double, double> explored;  // likewise
    std::string cacheFolder;
    std::pair<std::string, std::string> asked;  // under the mutex
    std::map<std::string, std::string> web;     // likewise
};

/// The machine of an environment.
JavaMachine::Impl& findMachine(JNIEnv* env);
/// Makes an exception pending.
void raise(JNIEnv* env, const std::string& type, const std::string& words);

// What the classes do (java_classes.cpp). Objects come without a reference.
bool known(const std::string& type, const std::string& name, const std::string& signature);
Object* callObject(JNIEnv* env, Object* of, const std::string& name, va_list arguments);
void callVoid(JNIEnv* env, Object* of, const std::string& name, va_list arguments);
jint callInt(JNIEnv* env, Object* of, const std::string& name, va_list arguments);

}  // namespace nacre::test
