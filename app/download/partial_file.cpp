#include "app/download/partial_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "engine/error.h"
#include "engine/storage/plain_file.h"

namespace nacre::app {
namespace {

/// Whether the path still names the open file.
bool names(const std::string& path, int file) {
    struct stat open {
    }, named{};
    return fstat(file, &open) == 0 && lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

}  // namespace

PartialFile::PartialFile(const DiskCache& cache, const std::string& name, const std::string& url)
    : cache_(cache),
      name_(name),
      url_(url),
      path_(cache.entryPath(name + ".part")),
      tagPath_(cache.entryPath(name + ".tag")) {
    if (!cache.makeFolder()) fail();
    openShared();
    if (!shared_) openOwn();
}

PartialFile::~PartialFile() {
    if (!done_ && (!shared_ || size_ == 0 || validator_.empty())) discard();
    if (file_ >= 0) close(file_);  // this also releases the lock
}

void PartialFile::openShared() {
    constexpr int kAttempts = 10;
    for (int attempt = 0; attempt < kAttempts && !shared_; ++attempt) {
        file_ = openPlain(path_, O_RDWR | O_CREAT, 0600);
        if (file_ < 0) return;
        const bool locked = flock(file_, LOCK_EX | LOCK_NB) == 0;
        // The previous owner of the lock may have renamed the file since.
        shared_ = locked && names(path_, file_);
        if (!shared_) {
            close(file_);
            file_ = -1;
        }
        if (!locked) return;
    }
    if (shared_) readTag();
}

void PartialFile::openOwn() {
    path_ = cache_.entryPath(DiskCache::temporaryName());
    tagPath_.clear();
    file_ = openPlain(path_, O_RDWR | O_CREAT | O_EXCL, 0600);
    if (file_ < 0) fail();
}

void PartialFile::readTag() {
    constexpr std::uint64_t kLongestTag = 1 << 16;
    std::istringstream tag(readPlain(tagPath_, kLongestTag).value_or(""));
    std::string url, validator;
    struct stat status {};
    if (!std::getline(tag, url) || !std::getline(tag, validator) || url != url_ || fstat(file_, &status) != 0) return;
    size_ = static_cast<std::uint64_t>(status.st_size);
    validator_ = validator;
    lseek(file_, 0, SEEK_END);
}

void PartialFile::restart(const std::string& validator) {
    // In this order the tag never describes bytes of another version.
    if (ftruncate(file_, 0) != 0 || lseek(file_, 0, SEEK_SET) != 0) fail();
    size_ = 0;
    validator_ = validator;
    if (!shared_) return;
    const std::string text = url_ + "\n" + validator + "\n";
    const std::string_view parts[] = {text};
    if (validator.empty())
        cache_.remove(name_ + ".tag");
    else if (!cache_.write(name_ + ".tag", parts))
        validator_.clear();
}

void PartialFile::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(file_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail();
        size_ += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string PartialFile::content() const {
    std::string bytes(size_, '\0');
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t got = pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) fail();
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

void PartialFile::commit() {
    if (fsync(file_) != 0 || std::rename(path_.c_str(), cache_.entryPath(name_).c_str()) != 0) fail();
    done_ = true;
    if (shared_) cache_.remove(name_ + ".tag");
    cache_.trim();
}

void PartialFile::discard() {
    done_ = true;
    unlink(path_.c_str());
    if (shared_) cache_.remove(name_ + ".tag");
}

void PartialFile::fail() const { throw Error("cannot write file", path_, std::strerror(errno)); }

}  // namespace nacre::app
