#include "engine/molecule/byte_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "engine/molecule/text.h"

namespace nacre {

std::shared_ptr<ByteFile> ByteFile::open(const std::string& path) {
    struct stat status {};
    errno = 0;
    // Opening a pipe may block forever.
    if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return nullptr;
    const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return nullptr;
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(file);
        return nullptr;
    }
    return std::shared_ptr<ByteFile>(new ByteFile(file, static_cast<std::uint64_t>(status.st_size)));
}

std::string ByteFile::whyNotOpened(const std::string& path) {
    if (errno != 0) return std::strerror(errno);
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a plain file";
}

std::shared_ptr<ByteFile> ByteFile::temporary() {
    const char* own = std::getenv("TMPDIR");
    for (const std::string folder : {own && *own ? own : "/var/tmp", "/var/tmp", "/tmp"}) {
        std::string name = folder + "/nacre-XXXXXX";
        const int file = mkstemp(name.data());
        if (file < 0) continue;
        unlink(name.c_str());
        fcntl(file, F_SETFD, FD_CLOEXEC);
        return std::shared_ptr<ByteFile>(new ByteFile(file, 0));
    }
    return nullptr;
}

ByteFile::~ByteFile() { ::close(file_); }

void ByteFile::read(std::uint64_t at, void* to, std::size_t count) const {
    for (std::size_t done = 0; done < count;) {
        const ssize_t got = ::pread(file_, static_cast<char*>(to) + done, count - done, static_cast<off_t>(at + done));
        if (got > 0) done += static_cast<std::size_t>(got);
        if (got == 0) cannotRead("", "the file has become shorter while it was read");
        if (got < 0 && errno != EINTR) cannotRead("", std::strerror(errno));
    }
}

bool ByteFile::append(const void* bytes, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
        const ssize_t written =
            ::pwrite(file_, static_cast<const char*>(bytes) + done, count - done, static_cast<off_t>(size_ + done));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    size_ += count;
    return true;
}

}  // namespace nacre
