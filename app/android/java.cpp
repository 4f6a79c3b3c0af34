#include "app/android/java.h"

#include "app/files/code_points.h"

namespace nacre::app {
namespace {

constexpr jint kMostReferences = 32;

}  // namespace

Java::Java(JNIEnv* env) : env_(env) {
    if (env_->PushLocalFrame(kMostReferences) != JNI_OK) {
        env_->ExceptionClear();
        throw JavaError("out of memory");
    }
}

Java::~Java() { env_->PopLocalFrame(nullptr); }

jmethodID Java::findMethod(jobject of, const char* method, const char* signature) const {
    if (!of) throw JavaError(std::string("nothing to call ") + method + " of");
    // Streams need many calls: frees the reference to their class at once.
    const jclass type = env_->GetObjectClass(of);
    const jmethodID id = env_->GetMethodID(type, method, signature);
    env_->DeleteLocalRef(type);
    check();
    return id;
}

void Java::check() const {
    const jthrowable thrown = env_->ExceptionOccurred();
    if (!thrown) return;
    env_->ExceptionClear();
    // Does not use object(), which would return here if toString() threw.
    const jmethodID id = env_->GetMethodID(env_->GetObjectClass(thrown), "toString", "()Ljava/lang/String;");
    const jobject words = id ? env_->CallObjectMethod(thrown, id) : nullptr;
    if (env_->ExceptionCheck()) {
        env_->ExceptionClear();
        throw JavaError("an exception without a message");
    }
    throw JavaError(text(words));
}

jstring newString(JNIEnv* env, const std::string& text) {
    const std::u16string units = toUtf16(text);
    return env->NewString(reinterpret_cast<const jchar*>(units.data()), static_cast<jsize>(units.size()));
}

jstring Java::string(const std::string& text) const {
    const jstring made = newString(env_, text);
    check();
    return made;
}

std::string Java::text(jobject string) const {
    if (!string) return {};
    const auto it = static_cast<jstring>(string);
    std::u16string units(static_cast<std::size_t>(env_->GetStringLength(it)), u'\0');
    env_->GetStringRegion(it, 0, static_cast<jsize>(units.size()), reinterpret_cast<jchar*>(units.data()));
    return toUtf8(units);
}

AttachedThread::AttachedThread(JavaVM* machine) : machine_(machine) {
    if (machine_->AttachCurrentThread(&env_, nullptr) != JNI_OK) throw JavaError("no thread");
}

AttachedThread::~AttachedThread() { machine_->DetachCurrentThread(); }

}  // namespace nacre::app
