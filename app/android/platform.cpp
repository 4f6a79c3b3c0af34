#include "app/android/platform.h"

#include <cstdint>
#include <exception>
#include <vector>

#include "app/android/java.h"
#include "app/android/log.h"
#include "app/download/http.h"

namespace nacre::app {
namespace {

const Platform::Told& toldBy(jlong platform) { return *reinterpret_cast<const Platform::Told*>(platform); }

std::string fromJava(JNIEnv* env, jstring text) { return Java(env).text(text); }
bool fromJava(JNIEnv*, jboolean value) { return value == JNI_TRUE; }
double fromJava(JNIEnv*, jfloat value) { return value; }
jint fromJava(JNIEnv*, jint value) { return value; }
jlong fromJava(JNIEnv*, jlong value) { return value; }

jstring toJava(const Java& java, const std::string& text) { return java.string(text); }
jboolean toJava(bool value) { return value ? JNI_TRUE : JNI_FALSE; }
jboolean toJava(const Java&, bool value) { return toJava(value); }

/// Posts a call to one of the session's functions.
template <auto kCall, typename... Values>
void tell([[maybe_unused]] JNIEnv* env, jclass, jlong platform, Values... values) {
    toldBy(platform).post([... told = fromJava(env, values)](AndroidSession& session) { (session.*kCall)(told...); });
}

void opened(JNIEnv*, jclass, jlong platform, jobject uri) { toldBy(platform).opened(uri); }

jstring controls(JNIEnv* env, jclass, jlong platform) {
    // Uses `env`, not Java, whose destructor frees the result.
    return newString(env, toldBy(platform).controls());
}

struct Transfer {
    const HttpTake& take;
    std::exception_ptr failed;  // exceptions must not pass through Java
};

jboolean received(JNIEnv* env, jclass, jlong to, jbyteArray bytes, jint count, jlong all) {
    auto& transfer = *reinterpret_cast<Transfer*>(to);
    std::string part(static_cast<std::size_t>(count), '\0');
    env->GetByteArrayRegion(bytes, 0, count, reinterpret_cast<jbyte*>(part.data()));
    try {
        transfer.take(part, 0, all > 0 ? static_cast<std::uint64_t>(all) : 0);
        return JNI_TRUE;
    } catch (...) {
        transfer.failed = std::current_exception();
        return JNI_FALSE;
    }
}

template <typename Function>
JNINativeMethod native(const char* name, const char* signature, Function function) {
    return {const_cast<char*>(name), const_cast<char*>(signature), reinterpret_cast<void*>(function)};
}

}  // namespace

Platform::Platform(ANativeActivity* activity, Told told)
    : env_(activity->env),
      machine_(activity->vm),
      object_(env_->NewGlobalRef(activity->clazz)),
      told_(std::move(told)) {
    const Java java(env_);
    using S = AndroidSession;
    const JNINativeMethod methods[] = {
        native("opened", "(JLandroid/net/Uri;)V", opened),
        native("failed", "(JLjava/lang/String;)V", tell<&S::fail, jstring>),
        native("controls", "(J)Ljava/lang/String;", controls),
        native("press", "(JLjava/lang/String;Ljava/lang/String;)V", tell<&S::press, jstring, jstring>),
        native("adjust", "(JLjava/lang/String;Z)V", tell<&S::adjust, jstring, jboolean>),
        native("back", "(J)V", tell<&S::back>),
        native("insets", "(JIIII)V", tell<&S::covered, jint, jint, jint, jint>),
        native("textScale", "(JF)V", tell<&S::setTextScale, jfloat>),
        native("refreshes", "(JFF)V", tell<&S::displayRefreshes, jfloat, jfloat>),
        native("trim", "(JI)V", tell<&S::trimMemory, jint>),
        native("tick", "(JJ)V", tell<&S::tick, jlong>),
        native("typed", "(JLjava/lang/String;Ljava/lang/String;)V", tell<&S::typed, jstring, jstring>),
        native("received", "(J[BIJ)Z", received)};
    const jclass type = java.env()->GetObjectClass(object_);
    if (java.env()->RegisterNatives(type, methods, std::size(methods)) != JNI_OK) {
        java.env()->ExceptionClear();
        return;
    }
    try {
        java.nothing(object_, "attach", "(J)V", reinterpret_cast<jlong>(&told_));
        there_ = true;
    } catch (const JavaError& error) {
        logError(error.what());
    }
}

Platform::~Platform() {
    detach();
    if (std::this_thread::get_id() == main_) {
        env_->DeleteGlobalRef(object_);
    } else {
        const AttachedThread thread(machine_);
        thread.env()->DeleteGlobalRef(object_);
    }
}

void Platform::detach() {
    if (!there_.exchange(false)) return;
    try {
        Java(env_).nothing(object_, "attach", "(J)V", jlong{0});
    } catch (const JavaError& error) {
        logError(error.what());
    }
}

std::string Platform::system() const {
    try {
        const Java java(env_);
        return java.text(java.object(object_, "system", "()Ljava/lang/String;"));
    } catch (const JavaError& error) {
        logError(error.what());
        return {};
    }
}

std::optional<std::string> Platform::cacheFolder() const {
    try {
        const Java java(env_);
        const jobject folder = java.object(object_, "getCacheDir", "()Ljava/io/File;");
        return java.text(java.object(folder, "getPath", "()Ljava/lang/String;"));
    } catch (const JavaError& error) {
        logError(error.what());
        return std::nullopt;
    }
}

/// @returns whether Java was called, and threw nothing
template <typename Call>
bool Platform::call(const Call& call) const {
    if (!there_) return false;
    try {
        const AttachedThread thread(machine_);
        call(Java(thread.env()));
        return true;
    } catch (const JavaError& error) {
        logError(error.what());
        return false;
    }
}

void Platform::fetch(const std::string& url, const HttpTake& take) const {
    if (!there_) throw HttpFailure("no network available", false);
    Transfer transfer{take, {}};
    try {
        const AttachedThread thread(machine_);
        const Java java(thread.env());
        java.nothing(object_, "fetch", "(Ljava/lang/String;J)V", java.string(url), reinterpret_cast<jlong>(&transfer));
    } catch (const JavaError& error) {
        throw HttpFailure(error.what(), false);
    }
    if (transfer.failed) std::rethrow_exception(transfer.failed);
}

template <typename... Values>
bool Platform::ask(const char* method, const char* signature, const Values&... values) const {
    return call([&](const Java& java) { java.nothing(object_, method, signature, toJava(java, values)...); });
}

void Platform::wantsBack(bool wanted) const { ask("wantsBack", "(Z)V", wanted); }
void Platform::animate(bool on) const { ask("animate", "(Z)V", on); }

void Platform::controlsChanged() const { ask("controlsChanged", "()V"); }

bool Platform::giveUp(const std::string& why) const { return ask("giveUp", "(Ljava/lang/String;)V", why); }

void Platform::explore(std::optional<glm::dvec2> at) const {
    if (!there_) return;
    try {
        const glm::vec2 pixel(at.value_or(glm::dvec2(0)));
        Java(env_).nothing(object_, "explore", "(FFZ)V", pixel.x, pixel.y, toJava(at.has_value()));
    } catch (const JavaError& error) {
        logError(error.what());
    }
}

void Platform::lend(PhoneHost& host) const {
    if (!there_) return;
    host.downloads = true;
    host.pickDocument = [this] { ask("pickDocument", "()V"); };
    host.askText = [this](const std::string& name, const std::string& text) {
        ask("askText", "(Ljava/lang/String;Ljava/lang/String;)V", name, text);
    };
    host.shareText = [this](const std::string& text, const std::string& name) {
        ask("shareText", "(Ljava/lang/String;Ljava/lang/String;)V", text, name);
    };
    host.copyText = [this](const std::string& text) { ask("copyText", "(Ljava/lang/String;)V", text); };
    host.sharePicture = [this](const PictureBytes& picture, const std::string& name) { share(picture, name); };
}

void Platform::share(const PictureBytes& picture, const std::string& name) const {
    std::vector<jint> pixels(std::size_t{picture.width} * picture.height);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint8_t* code = &picture.rgba[4 * i];
        pixels[i] = static_cast<jint>(std::uint32_t{code[3]} << 24 | std::uint32_t{code[0]} << 16 |
                                      std::uint32_t{code[1]} << 8 | code[2]);
    }
    call([&](const Java& java) {
        const auto count = static_cast<jsize>(pixels.size());
        const jintArray array = java.env()->NewIntArray(count);
        java.check();
        java.env()->SetIntArrayRegion(array, 0, count, pixels.data());
        java.nothing(object_, "sharePicture", "([IIILjava/lang/String;)V", array, static_cast<jint>(picture.width),
                     static_cast<jint>(picture.height), java.string(name));
    });
}

}  // namespace nacre::app
