#include "tests/android_host/java_machine.h"

#include <algorithm>
#include <chrono>
#include <climits>
#include <clocale>
#include <cstring>
#include <cuchar>

#include "tests/android_host/java_state.h"
#include "tests/android_host/window.h"

namespace nacre::test {
namespace {

using Impl = JavaMachine::Impl;

// JNIEnv has one member: the table, which stands at the machine's start, so that the machine is found by it.
std::map<const JNINativeInterface*, Impl*>& machines() {
    static std::map<const JNINativeInterface*, Impl*> all;
    return all;
}
std::mutex machinesMutex;

}  // namespace

JavaMachine::Impl& findMachine(JNIEnv* env) {
    const std::lock_guard lock(machinesMutex);
    return *machines().at(env->functions);
}

namespace {

Thread& findThread(JNIEnv* env) {
    Impl& machine = findMachine(env);
    const std::lock_guard lock(machine.mutex);
    const auto it = machine.threads.find(std::this_thread::get_id());
    if (it == machine.threads.end() || &it->second->env != env) {
        Faults::add("a JNI call with another thread's environment");
        return *machine.threads.begin()->second;
    }
    return *it->second;
}

jobject local(JNIEnv* env, Object* object) {
    if (!object) return nullptr;
    std::vector<jobject>& frame = findThread(env).frames.back();
    frame.push_back(object);
    constexpr std::size_t kMost = 512;  // Android's table of old
    if (frame.size() > kMost) Faults::add("more than 512 local references");
    return object;
}

void expectNothingPending(JNIEnv* env, const char* call) {
    if (findThread(env).pending) Faults::add(std::string(call) + " with an exception pending");
}

}  // namespace

void raise(JNIEnv* env, const std::string& type, const std::string& words) {
    findThread(env).pending = findMachine(env).make(type, type + ": " + words);
}

namespace {

// --- the table

/// UTF-8 by the C library, which tests switch to it (the constructor).
std::u16string toUnits(const std::string& text) {
    std::u16string units;
    std::mbstate_t state{};
    for (std::size_t at = 0; at < text.size();) {
        char16_t unit = 0;
        const std::size_t used = std::mbrtoc16(&unit, text.data() + at, text.size() - at, &state);
        if (used == std::size_t(-1) || used == std::size_t(-2)) {
            Faults::add("a text that is no UTF-8");
            break;
        }
        units += unit;
        if (used != std::size_t(-3)) at += std::max<std::size_t>(used, 1);
        // The second half of a pair comes with the next call, whatever is left of the text.
        if (at >= text.size() && unit >= 0xd800 && unit < 0xdc00 &&
            std::mbrtoc16(&unit, "", 0, &state) == std::size_t(-3))
            units += unit;
    }
    return units;
}

const Method& findMethod(JNIEnv* env, jobject of, jmethodID id, char result) {
    const auto& method = *reinterpret_cast<const Method*>(id);
    expectNothingPending(env, method.name.c_str());
    if (in(of)->type != method.type) Faults::add(method.name + " called of a " + in(of)->type);
    if (method.signature[method.signature.find(')') + 1] != result)
        Faults::add(method.name + " called as another type");
    return method;
}

void fillObjects(JNINativeInterface& f) {
    f.GetObjectClass = [](JNIEnv* env, jobject of) {
        return as<jclass>(local(env, findMachine(env).make("class", in(of)->type)));
    };
    f.FindClass = [](JNIEnv* env, const char* name) {
        expectNothingPending(env, "FindClass");
        return as<jclass>(local(env, findMachine(env).make("class", name)));
    };
    f.GetMethodID = [](JNIEnv* env, jclass type, const char* name, const char* signature) -> jmethodID {
        expectNothingPending(env, "GetMethodID");
        if (!known(in(type)->text, name, signature)) {
            raise(env, "java.lang.NoSuchMethodError", in(type)->text + "." + name + signature);
            return nullptr;
        }
        Impl& machine = findMachine(env);
        const std::lock_guard lock(machine.mutex);
        machine.methods.push_back({in(type)->text, name, signature});
        return reinterpret_cast<jmethodID>(&machine.methods.back());
    };
    // Java's strings are UTF-16; the objects here keep UTF-8, by the C library's conversion.
    f.NewString = [](JNIEnv* env, const jchar* units, jsize count) {
        std::string text;
        std::mbstate_t state{};
        for (jsize i = 0; i < count; ++i) {
            char part[MB_LEN_MAX];
            const std::size_t bytes = std::c16rtomb(part, units[i], &state);
            if (bytes == std::size_t(-1)) {
                Faults::add("a Java string with half a character");
                state = {};
            } else {
                text.append(part, bytes);
            }
        }
        return as<jstring>(local(env, findMachine(env).make("java/lang/String", text)));
    };
    f.GetStringLength = [](JNIEnv*, jstring string) { return static_cast<jsize>(toUnits(in(string)->text).size()); };
    f.GetStringRegion = [](JNIEnv* env, jstring string, jsize start, jsize count, jchar* to) {
        const std::u16string units = toUnits(in(string)->text);
        if (start < 0 || count < 0 || static_cast<std::size_t>(start + count) > units.size())
            return raise(env, "java.lang.StringIndexOutOfBoundsException", "");
        std::copy_n(units.begin() + start, count, to);
    };
    f.NewObjectArray = [](JNIEnv* env, jsize count, jclass, jobject first) {
        if (count != 1) Faults::add("an array of another size");
        return as<jobjectArray>(local(env, findMachine(env).make("[Ljava/lang/String;", in(first)->text)));
    };
    f.NewByteArray = [](JNIEnv* env, jsize count) {
        Object* array = findMachine(env).make("[B");
        array->bytes.resize(static_cast<std::size_t>(count));
        return as<jbyteArray>(local(env, array));
    };
    f.NewIntArray = [](JNIEnv* env, jsize count) {
        Object* array = findMachine(env).make("[I");
        array->numbers.resize(static_cast<std::size_t>(count));
        return as<jintArray>(local(env, array));
    };
    f.SetIntArrayRegion = [](JNIEnv* env, jintArray array, jsize start, jsize count, const jint* from) {
        if (start < 0 || count < 0 || static_cast<std::size_t>(start + count) > in(array)->numbers.size())
            return raise(env, "java.lang.ArrayIndexOutOfBoundsException", "");
        std::copy_n(from, count, in(array)->numbers.begin() + start);
    };
    f.GetByteArrayRegion = [](JNIEnv* env, jbyteArray array, jsize start, jsize count, jbyte* to) {
        if (start < 0 || count < 0 || static_cast<std::size_t>(start + count) > in(array)->bytes.size())
            return raise(env, "java.lang.ArrayIndexOutOfBoundsException", "");
        std::memcpy(to, in(array)->bytes.data() + start, static_cast<std::size_t>(count));
    };
}

void fillCalls(JNINativeInterface& f) {
    f.CallObjectMethodV = [](JNIEnv* env, jobject of, jmethodID id, va_list arguments) {
        return local(env, callObject(env, in(of), findMethod(env, of, id, 'L').name, arguments));
    };
    f.CallIntMethodV = [](JNIEnv* env, jobject of, jmethodID id, va_list arguments) {
        return callInt(env, in(of), findMethod(env, of, id, 'I').name, arguments);
    };
    f.CallBooleanMethodV = [](JNIEnv* env, jobject of, jmethodID id, va_list) -> jboolean {
        if (findMethod(env, of, id, 'Z').name == "getBooleanExtra") return intentValidates ? JNI_TRUE : JNI_FALSE;
        return findMachine(env).document->name.empty() ? JNI_FALSE : JNI_TRUE;
    };
    f.CallVoidMethodV = [](JNIEnv* env, jobject of, jmethodID id, va_list arguments) {
        callVoid(env, in(of), findMethod(env, of, id, 'V').name, arguments);
    };
    f.RegisterNatives = [](JNIEnv* env, jclass type, const JNINativeMethod* methods, jint count) -> jint {
        if (in(type)->text != kActivity) Faults::add("natives for another class");
        for (jint i = 0; i < count; ++i)
            findMachine(env).natives[std::string(methods[i].name) + methods[i].signature] = methods[i].fnPtr;
        return JNI_OK;
    };
}

void fillReferences(JNINativeInterface& f) {
    f.PushLocalFrame = [](JNIEnv* env, jint) -> jint {
        findThread(env).frames.emplace_back();
        return JNI_OK;
    };
    f.PopLocalFrame = [](JNIEnv* env, jobject) -> jobject {
        findThread(env).frames.pop_back();
        return nullptr;
    };
    f.DeleteLocalRef = [](JNIEnv* env, jobject object) {
        std::vector<jobject>& frame = findThread(env).frames.back();
        const auto it = std::find(frame.begin(), frame.end(), object);
        if (it == frame.end()) return Faults::add("a local reference given back that is none");
        frame.erase(it);
    };
    f.NewGlobalRef = [](JNIEnv* env, jobject object) {
        Impl& machine = findMachine(env);
        const std::lock_guard lock(machine.mutex);
        machine.globals.push_back(object);
        return object;
    };
    f.DeleteGlobalRef = [](JNIEnv* env, jobject object) {
        Impl& machine = findMachine(env);
        const std::lock_guard lock(machine.mutex);
        const auto it = std::find(machine.globals.begin(), machine.globals.end(), object);
        if (it == machine.globals.end()) return Faults::add("a global reference given back that is none");
        machine.globals.erase(it);
    };
    f.ExceptionCheck = [](JNIEnv* env) -> jboolean { return findThread(env).pending ? JNI_TRUE : JNI_FALSE; };
    f.ExceptionOccurred = [](JNIEnv* env) { return as<jthrowable>(local(env, findThread(env).pending)); };
    f.ExceptionClear = [](JNIEnv* env) { findThread(env).pending = nullptr; };
}

jint attach(JavaVM* vm, JNIEnv** env, void*) {
    Impl* machine = nullptr;
    {
        const std::lock_guard lock(machinesMutex);
        for (const auto& [functions, each] : machines())
            if (&each->vm == vm) machine = each;
    }
    const std::lock_guard lock(machine->mutex);
    auto& thread = machine->threads[std::this_thread::get_id()];
    if (!thread) thread = std::make_unique<Thread>();
    thread->env.functions = &machine->functions;
    *env = &thread->env;
    return JNI_OK;
}

jint detach(JavaVM* vm) {
    const std::lock_guard lock(machinesMutex);
    for (const auto& [functions, machine] : machines())
        if (&machine->vm == vm) {
            const std::lock_guard own(machine->mutex);
            const auto it = machine->threads.find(std::this_thread::get_id());
            if (it->second->frames.size() != 1) Faults::add("local frames left on a thread");
            machine->threads.erase(it);
        }
    return JNI_OK;
}

}  // namespace

JavaMachine::JavaMachine(std::optional<Document> document, const std::string& cache)
    : impl_(std::make_unique<Impl>(std::move(document), cache)) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // for the conversions
    fillObjects(impl_->functions);
    fillCalls(impl_->functions);
    fillReferences(impl_->functions);
    impl_->invoke.AttachCurrentThread = attach;
    impl_->invoke.DetachCurrentThread = detach;
    impl_->vm.functions = &impl_->invoke;
    {
        const std::lock_guard lock(machinesMutex);
        machines()[&impl_->functions] = impl_.get();
    }
    impl_->activity = impl_->make(kActivity);
    attach(&impl_->vm, &impl_->mainEnv, nullptr);
}

JavaMachine::~JavaMachine() {
    // Threads of the app may outlive the activity; the machine is there for good.
    for (int i = 0; i < 1200; ++i) {
        {
            const std::lock_guard lock(impl_->mutex);
            if (impl_->globals.empty() && impl_->threads.size() == 1) break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    if (!impl_->globals.empty()) Faults::add("global references left");
    if (impl_->threads.size() != 1) Faults::add("threads left attached");
    for (const auto& [id, thread] : impl_->threads) {
        if (thread->frames.size() != 1 || !thread->frames[0].empty()) Faults::add("local references left");
        if (thread->pending) Faults::add("an exception left pending");
    }
    if (impl_->opened != impl_->closed) Faults::add("a cursor or stream left open");
    const std::lock_guard lock(machinesMutex);
    machines().erase(&impl_->functions);
}

int JavaMachine::controlChanges() const { return impl_->controlChanges; }

std::pair<std::string, std::string> JavaMachine::asked() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->asked;
}

namespace {

/// A native method, as Java calls it: with references that go when it returns.
template <typename Result, typename... Arguments>
Result callNative(Impl& machine, const char* name, Arguments... arguments) {
    const auto native = machine.natives.find(name);
    if (native == machine.natives.end() || machine.attached == 0) {
        Faults::add(std::string(name) + " is called and not there");
        return Result();
    }
    using Native = Result (*)(JNIEnv*, jclass, jlong, Arguments...);
    return reinterpret_cast<Native>(native->second)(machine.mainEnv, nullptr, machine.attached, arguments...);
}

}  // namespace

void JavaMachine::documentPicked(const Document& document) {
    impl_->document = document;
    callNative<void>(*impl_, "opened(JLandroid/net/Uri;)V",
                     static_cast<jobject>(impl_->make("android/net/Uri", document.uri)));
    impl_->threads.at(std::this_thread::get_id())->frames.front().clear();
}

std::string JavaMachine::controls() {
    const auto text = callNative<jstring>(*impl_, "controls(J)Ljava/lang/String;");
    impl_->threads.at(std::this_thread::get_id())->frames.front().clear();
    return text ? in(text)->text : "";
}

void JavaMachine::press(const std::string& role, const std::string& name) {
    callNative<void>(*impl_, "press(JLjava/lang/String;Ljava/lang/String;)V",
                     as<jstring>(impl_->make("java/lang/String", role)),
                     as<jstring>(impl_->make("java/lang/String", name)));
}

void JavaMachine::serve(const std::string& url, const std::string& bytes) {
    const std::lock_guard lock(impl_->mutex);
    impl_->web[url] = bytes;
}

void JavaMachine::typed(const std::string& name, const std::string& text) {
    callNative<void>(*impl_, "typed(JLjava/lang/String;Ljava/lang/String;)V",
                     as<jstring>(impl_->make("java/lang/String", name)),
                     as<jstring>(impl_->make("java/lang/String", text)));
}

void JavaMachine::displayRefreshes(float rate, float most) { callNative<void>(*impl_, "refreshes(JFF)V", rate, most); }

bool JavaMachine::wantsBack() const { return impl_->wantsBack; }
std::string JavaMachine::gaveUp() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->gaveUp;
}
std::pair<double, double> JavaMachine::explored() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->explored;
}
void JavaMachine::trim(int level) { callNative<void>(*impl_, "trim(JI)V", level); }
void JavaMachine::back() { callNative<void>(*impl_, "back(J)V"); }
bool JavaMachine::animated() const { return impl_->animated; }
void JavaMachine::tick() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    callNative<void>(*impl_, "tick(JJ)V",
                     static_cast<jlong>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()));
}

JavaVM* JavaMachine::vm() { return &impl_->vm; }
JNIEnv* JavaMachine::env() { return impl_->mainEnv; }
jobject JavaMachine::activity() { return impl_->activity; }

}  // namespace nacre::test
