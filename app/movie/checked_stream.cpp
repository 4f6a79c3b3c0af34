#include "app/movie/checked_stream.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/error.h"

namespace nacre::app {

CheckedStream::CheckedStream(const std::string& path, const std::string& extension) : file_(path, extension) {
    stream_ = ::open(file_.temporary().c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
    if (stream_ < 0) throw Error("cannot write file", file_.path(), std::strerror(errno));
}

CheckedStream::~CheckedStream() {
    if (stream_ >= 0) ::close(stream_);
}

void CheckedStream::write(const void* bytes, std::size_t count) {
    writeAt(size_, bytes, count);
    size_ += count;
}

void CheckedStream::writeAt(std::uint64_t offset, const void* bytes, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
        const ssize_t n =
            ::pwrite(stream_, static_cast<const char*>(bytes) + done, count - done, static_cast<off_t>(offset + done));
        if (n > 0) done += static_cast<std::size_t>(n);
        if (n == 0 || (n < 0 && errno != EINTR))
            throw Error("cannot write file", file_.path(), std::strerror(n == 0 ? ENOSPC : errno));
    }
}

void CheckedStream::commit() {
    const int stream = stream_;
    stream_ = -1;
    if (::close(stream) != 0) throw Error("cannot write file", file_.path(), std::strerror(errno));
    file_.commit();
}

}  // namespace nacre::app
