// The few classes that the shell calls, and how a document's provider behaves.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "tests/android_host/java_state.h"
#include "tests/android_host/window.h"

namespace nacre::test {
namespace {

using Impl = JavaMachine::Impl;

constexpr struct {
    const char *type, *name, *signature;
} kMethods[] = {
    {kActivity, "getIntent", "()Landroid/content/Intent;"},
    {kActivity, "getContentResolver", "()Landroid/content/ContentResolver;"},
    {kActivity, "getCacheDir", "()Ljava/io/File;"},
    {"java/io/File", "getPath", "()Ljava/lang/String;"},
    {kActivity, "system", "()Ljava/lang/String;"},
    {kActivity, "wantsBack", "(Z)V"},
    {kActivity, "animate", "(Z)V"},
    {kActivity, "copyText", "(Ljava/lang/String;)V"},
    {kActivity, "attach", "(J)V"},
    {kActivity, "pickDocument", "()V"},
    {kActivity, "sharePicture", "([IIILjava/lang/String;)V"},
    {kActivity, "controlsChanged", "()V"},
    {kActivity, "giveUp", "(Ljava/lang/String;)V"},
    {kActivity, "explore", "(FFZ)V"},
    {kActivity, "fetch", "(Ljava/lang/String;J)V"},
    {kActivity, "askText", "(Ljava/lang/String;Ljava/lang/String;)V"},
    {kActivity, "shareText", "(Ljava/lang/String;Ljava/lang/String;)V"},
    {"android/content/Intent", "getData", "()Landroid/net/Uri;"},
    {"android/content/Intent", "getParcelableExtra", "(Ljava/lang/String;)Landroid/os/Parcelable;"},
    {"android/content/Intent", "getBooleanExtra", "(Ljava/lang/String;Z)Z"},
    {"android/net/Uri", "getLastPathSegment", "()Ljava/lang/String;"},
    {"android/content/ContentResolver", "openInputStream", "(Landroid/net/Uri;)Ljava/io/InputStream;"},
    {"android/content/ContentResolver", "openFileDescriptor",
     "(Landroid/net/Uri;Ljava/lang/String;)Landroid/os/ParcelFileDescriptor;"},
    {"android/content/ContentResolver", "query",
     "(Landroid/net/Uri;[Ljava/lang/String;Ljava/lang/String;[Ljava/lang/String;Ljava/lang/String;)Landroid/database/"
     "Cursor;"},
    {"android/database/Cursor", "moveToFirst", "()Z"},
    {"android/database/Cursor", "getString", "(I)Ljava/lang/String;"},
    {"android/database/Cursor", "close", "()V"},
    {"java/io/InputStream", "read", "([B)I"},
    {"java/io/InputStream", "close", "()V"},
    {"android/os/ParcelFileDescriptor", "detachFd", "()I"},
};

Object* openStream(JNIEnv* env) {
    Impl& machine = findMachine(env);
    ++machine.opened;
    return machine.make("java/io/InputStream");
}

bool providerRefuses(JNIEnv* env) {
    const Document& document = *findMachine(env).document;
    std::this_thread::sleep_for(std::chrono::duration<double>(document.seconds));
    if (document.opens.valid()) document.opens.wait();
    if (document.refuses) raise(env, "java.lang.SecurityException", "Permission Denial");
    return document.refuses;
}

/// A descriptor of an unlinked file that holds the document.
int openDescriptor(const Document& document) {
    char path[] = "/tmp/nacre-document-XXXXXX";
    const int file = mkstemp(path);
    unlink(path);
    for (std::size_t done = 0; done < document.bytes.size();) {
        const ssize_t count = write(file, document.bytes.data() + done, document.bytes.size() - done);
        if (count <= 0) break;
        done += static_cast<std::size_t>(count);
    }
    lseek(file, 0, SEEK_SET);
    return file;
}

}  // namespace

bool known(const std::string& type, const std::string& name, const std::string& signature) {
    if (name == "toString" && signature == "()Ljava/lang/String;") return true;
    return std::any_of(std::begin(kMethods), std::end(kMethods),
                       [&](const auto& m) { return type == m.type && name == m.name && signature == m.signature; });
}

Object* callObject(JNIEnv* env, Object* of, const std::string& name, va_list arguments) {
    Impl& machine = findMachine(env);
    if (name == "system") return machine.make("java/lang/String", "Android 16 (36), Example Phone");
    if (name == "getCacheDir") return machine.make("java/io/File", machine.cacheFolder);
    if (name == "getPath") return machine.make("java/lang/String", of->text);
    if (name == "getIntent") return machine.make("android/content/Intent");
    if (name == "getData" || name == "getParcelableExtra") {
        const bool sent = name == "getParcelableExtra";
        if (sent && in(va_arg(arguments, jobject))->text != "android.intent.extra.STREAM") Faults::add("another extra");
        const bool has = machine.document && machine.document->sent == sent;
        return has ? machine.make("android/net/Uri", machine.document->uri) : nullptr;
    }
    if (name == "getContentResolver") return machine.make("android/content/ContentResolver");
    if (name == "toString") return machine.make("java/lang/String", of->text);
    if (name == "getLastPathSegment")
        return machine.make("java/lang/String", of->text.substr(of->text.find_last_of('/') + 1));
    if (name == "getString") return machine.make("java/lang/String", machine.document->name);
    const Object* uri = in(va_arg(arguments, jobject));
    if (!uri || uri->type != "android/net/Uri") {
        raise(env, "java.lang.NullPointerException", "uri");
        return nullptr;
    }
    if (name == "query") {
        if (providerRefuses(env)) return nullptr;
        const Object* columns = in(va_arg(arguments, jobject));
        if (!columns || columns->text != "_display_name") Faults::add("a query for other columns");
        ++machine.opened;
        return machine.make("android/database/Cursor");
    }
    if (providerRefuses(env)) return nullptr;
    if (name == "openInputStream") return openStream(env);
    if (name == "openFileDescriptor") {
        const Object* mode = in(va_arg(arguments, jobject));
        if (!mode || mode->text != "r") Faults::add("openFileDescriptor to do more than read");
        if (machine.document->hasDescriptor) return machine.make("android/os/ParcelFileDescriptor");
        raise(env, "java.io.FileNotFoundException", "this provider only streams");
    }
    return nullptr;
}

/// As HttpURLConnection: in parts of some size.
void fetch(JNIEnv* env, const std::string& url, jlong to) {
    Impl& machine = findMachine(env);
    std::string content;
    void* received = nullptr;
    {
        const std::lock_guard lock(machine.mutex);
        if (const auto found = machine.web.find(url); found != machine.web.end()) content = found->second;
        received = machine.natives.at("received(J[BIJ)Z");
    }
    if (content.empty()) return raise(env, "java.io.IOException", "there is no such entry (404)");
    Object* part = machine.make("[B");
    for (std::size_t at = 0; at < content.size(); at += part->bytes.size()) {
        const std::string some = content.substr(at, 1000);
        part->bytes.assign(some.begin(), some.end());
        using Received = jboolean (*)(JNIEnv*, jclass, jlong, jbyteArray, jint, jlong);
        if (!reinterpret_cast<Received>(received)(env, nullptr, to, as<jbyteArray>(part),
                                                  static_cast<jint>(some.size()), static_cast<jlong>(content.size())))
            return;
    }
}

void callVoid(JNIEnv* env, Object*, const std::string& name, va_list arguments) {
    Impl& machine = findMachine(env);
    if (name == "fetch") {
        const std::string url = in(va_arg(arguments, jobject))->text;
        return fetch(env, url, va_arg(arguments, jlong));
    }
    const std::lock_guard lock(machine.mutex);
    if (name == "close") ++machine.closed;
    if (name == "attach") machine.attached = va_arg(arguments, jlong);
    if (name == "wantsBack") machine.wantsBack = va_arg(arguments, int) != 0;
    if (name == "animate") machine.animated = va_arg(arguments, int) != 0;
    if (name == "controlsChanged") ++machine.controlChanges;
    if (name == "giveUp") machine.gaveUp = in(va_arg(arguments, jobject))->text;
    if (name == "explore") machine.explored = {va_arg(arguments, double), va_arg(arguments, double)};
    if (name != "askText") return;
    machine.asked.first = in(va_arg(arguments, jobject))->text;
    machine.asked.second = in(va_arg(arguments, jobject))->text;
}

jint callInt(JNIEnv* env, Object* of, const std::string& name, va_list arguments) {
    const Document& document = *findMachine(env).document;
    if (name == "detachFd") return openDescriptor(document);
    Object* buffer = in(va_arg(arguments, jobject));  // read([B)
    if (of->at >= document.bytes.size()) return -1;
    // Streams give as much as they like.
    const std::size_t count = std::min({buffer->bytes.size(), document.bytes.size() - of->at, of->at % 3000 + 1000});
    std::memcpy(buffer->bytes.data(), document.bytes.data() + of->at, count);
    of->at += count;
    return static_cast<jint>(count);
}

}  // namespace nacre::test
