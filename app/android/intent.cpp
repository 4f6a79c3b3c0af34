#include "app/android/intent.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>

#include "app/android/log.h"
#include "engine/error.h"
#include "engine/threads.h"

namespace nacre::app {
namespace {

constexpr jint kPiece = 1 << 16;

/// android.provider.OpenableColumns.DISPLAY_NAME of a document, else the end of its URI.
std::string findDisplayName(const Java& java, jobject resolver, jobject uri) {
    try {
        const jobject columns =
            java.env()->NewObjectArray(1, java.env()->FindClass("java/lang/String"), java.string("_display_name"));
        java.check();
        const jobject cursor = java.object(resolver, "query",
                                           "(Landroid/net/Uri;[Ljava/lang/String;Ljava/lang/String;[Ljava/lang/"
                                           "String;Ljava/lang/String;)Landroid/database/Cursor;",
                                           uri, columns, nullptr, nullptr, nullptr);
        std::string name;
        if (cursor) {
            if (java.boolean(cursor, "moveToFirst", "()Z"))
                name = java.text(java.object(cursor, "getString", "(I)Ljava/lang/String;", jint{0}));
            java.nothing(cursor, "close", "()V");
        }
        if (!name.empty()) return name;
    } catch (const JavaError&) {
        // Some providers have no names.
    }
    return java.text(java.object(uri, "getLastPathSegment", "()Ljava/lang/String;"));
}

/// The document's bytes through java.io.InputStream, for providers without files.
ReadBytes openStream(const Java& java, jobject resolver, jobject uri) {
    const jobject stream = java.object(resolver, "openInputStream", "(Landroid/net/Uri;)Ljava/io/InputStream;", uri);
    if (!stream) throw JavaError("the other app returned nothing");
    const jbyteArray piece = java.env()->NewByteArray(kPiece);
    java.check();
    return [&java, stream, piece](char* to, std::size_t most) -> std::size_t {
        jint count = 0;
        while (count == 0) count = java.integer(stream, "read", "([B)I", piece);
        if (count < 0) {
            java.nothing(stream, "close", "()V");
            return 0;
        }
        if (static_cast<std::size_t>(count) > most) throw JavaError("a stream that gives more than was asked for");
        java.env()->GetByteArrayRegion(piece, 0, count, reinterpret_cast<jbyte*>(to));
        java.check();
        return static_cast<std::size_t>(count);
    };
}

/// A duplicated descriptor; -1 if the provider has none.
int openDescriptor(const Java& java, jobject resolver, jobject uri) {
    try {
        const jobject file = java.object(resolver, "openFileDescriptor",
                                         "(Landroid/net/Uri;Ljava/lang/String;)Landroid/os/ParcelFileDescriptor;", uri,
                                         java.string("r"));
        return file ? java.integer(file, "detachFd", "()I") : -1;
    } catch (const JavaError&) {
        return -1;
    }
}

}  // namespace

bool wantsValidation(ANativeActivity* activity) {
    try {
        const Java java(activity->env);
        const jobject intent = java.object(activity->clazz, "getIntent", "()Landroid/content/Intent;");
        return intent && java.boolean(intent, "getBooleanExtra", "(Ljava/lang/String;Z)Z", java.string("validate"),
                                      jboolean{JNI_FALSE});
    } catch (const JavaError& error) {
        logError(error.what());
        return false;
    }
}

IntentDocument::IntentDocument(ANativeActivity* activity, jobject uri, OpenedFiles files, Post post)
    : env_(activity->env), work_(std::make_shared<Work>()) {
    work_->machine = activity->vm;
    work_->files = std::move(files);
    work_->post = std::move(post);
    try {
        const Java java(env_);
        if (!uri) {
            const jobject intent = java.object(activity->clazz, "getIntent", "()Landroid/content/Intent;");
            if (!intent) return;
            uri = java.object(intent, "getData", "()Landroid/net/Uri;");
            if (!uri)  // shared with this app
                uri = java.object(intent, "getParcelableExtra", "(Ljava/lang/String;)Landroid/os/Parcelable;",
                                  java.string("android.intent.extra.STREAM"));
        }
        if (!uri) return;
        work_->uri = env_->NewGlobalRef(uri);
        work_->activity = env_->NewGlobalRef(activity->clazz);
    } catch (const JavaError& error) {
        logError(error.what());
    }
}

IntentDocument::~IntentDocument() {
    {
        const std::lock_guard lock(work_->mutex);
        work_->post = {};
    }
    if (!opened_) work_->release(env_);
}

void IntentDocument::open() {
    if (!present()) return;
    std::thread thread;
    opened_ = mayStart(thread, [work = work_] { work->run(); });
    if (opened_)
        thread.detach();
    else
        logError("no thread can be started: the document is not opened");
}

void IntentDocument::Work::release(JNIEnv* env) {
    if (uri) env->DeleteGlobalRef(uri);
    if (activity) env->DeleteGlobalRef(activity);
}

void IntentDocument::Work::run() {
    const AttachedThread thread(machine);
    std::function<void(AndroidSession&)> told;
    try {
        told = [path = copy(Java(thread.env()))](AndroidSession& session) { session.open(path); };
    } catch (const std::exception& error) {
        told = [why = std::string(error.what())](AndroidSession& session) { session.fail(why); };
    }
    {
        const std::lock_guard lock(mutex);
        if (post) post(std::move(told));
    }
    release(thread.env());
}

std::string IntentDocument::Work::copy(const Java& java) const {
    try {
        const jobject resolver = java.object(activity, "getContentResolver", "()Landroid/content/ContentResolver;");
        const std::string name = findDisplayName(java, resolver, uri);
        const int number = openDescriptor(java, resolver, uri);
        if (number < 0) return files.keep(name, openStream(java, resolver, uri));
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(number, "rb"), std::fclose);
        return files.keep(name, [&](char* to, std::size_t most) {
            const std::size_t count = file ? std::fread(to, 1, most, file.get()) : 0;
            if (!file || std::ferror(file.get())) throw Error("cannot open file", "", std::strerror(errno));
            return count;
        });
    } catch (const JavaError& error) {
        throw Error("cannot open file", "", error.what());
    }
}

}  // namespace nacre::app
