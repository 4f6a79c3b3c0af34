#include "app/android/intent.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "app/android/java.h"
#include "app/android/log.h"
#include "engine/error.h"

namespace nacre::app {
namespace {

constexpr jint kPiece = 1 << 16;

/// android.provider.OpenableColumns.DISPLAY_NAME of a document, or else the end of its URI.
std::string nameOf(const Java& java, jobject resolver, jobject uri) {
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
        // Not every provider keeps names.
    }
    return java.text(java.object(uri, "getLastPathSegment", "()Ljava/lang/String;"));
}

/// The document's bytes by java.io.InputStream: for providers that have no file to give.
ReadBytes streamOf(const Java& java, jobject resolver, jobject uri) {
    const jobject stream = java.object(resolver, "openInputStream", "(Landroid/net/Uri;)Ljava/io/InputStream;", uri);
    if (!stream) throw JavaError("the provider gives nothing");
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

/// A descriptor that is ours; -1 if the provider has none to give.
int descriptorOf(const Java& java, jobject resolver, jobject uri) {
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

IntentDocument::IntentDocument(ANativeActivity* activity, jobject uri, OpenedFiles files, Post post)
    : activity_(activity), files_(std::move(files)), post_(std::move(post)) {
    try {
        const Java java(activity->env);
        if (!uri) {
            const jobject intent = java.object(activity->clazz, "getIntent", "()Landroid/content/Intent;");
            if (!intent) return;
            uri = java.object(intent, "getData", "()Landroid/net/Uri;");
        }
        if (uri) uri_ = java.env()->NewGlobalRef(uri);
    } catch (const JavaError& error) {
        logError(error.what());
    }
}

IntentDocument::~IntentDocument() {
    if (thread_.joinable()) thread_.join();
    if (uri_) activity_->env->DeleteGlobalRef(uri_);
}

void IntentDocument::open() {
    if (!uri_) return;
    thread_ = std::thread([this] {
        try {
            post_([path = copy()](AndroidSession& session) { session.open(path); });
        } catch (const std::exception& error) {
            post_([why = std::string(error.what())](AndroidSession& session) { session.fail(why); });
        }
    });
}

std::string IntentDocument::copy() const {
    try {
        const AttachedThread thread(activity_->vm);
        const Java java(thread.env());
        const jobject resolver =
            java.object(activity_->clazz, "getContentResolver", "()Landroid/content/ContentResolver;");
        const std::string name = nameOf(java, resolver, uri_);
        const int number = descriptorOf(java, resolver, uri_);
        if (number < 0) return files_.keep(name, streamOf(java, resolver, uri_));
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(number, "rb"), std::fclose);
        return files_.keep(name, [&](char* to, std::size_t most) {
            const std::size_t count = file ? std::fread(to, 1, most, file.get()) : 0;
            if (!file || std::ferror(file.get())) throw Error("cannot open file", "", std::strerror(errno));
            return count;
        });
    } catch (const JavaError& error) {
        throw Error("cannot open file", "", error.what());
    }
}

}  // namespace nacre::app
