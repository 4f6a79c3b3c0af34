#include "app/images/checked_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace nacre::app {

CheckedFile::CheckedFile(int file) : file_(::fcntl(file, F_DUPFD_CLOEXEC, 0)) {
    if (file_ < 0) failure_ = errno;
}

bool CheckedFile::write(const void* bytes, std::size_t size) {
    for (std::size_t done = 0; done < size && failure_ == 0;) {
        const ssize_t n =
            ::pwrite(file_, static_cast<const char*>(bytes) + done, size - done, static_cast<off_t>(place_));
        if (n > 0) {
            done += static_cast<std::size_t>(n);
            place_ += static_cast<std::uint64_t>(n);
        }
        if (n == 0) failure_ = ENOSPC;
        if (n < 0 && errno != EINTR) failure_ = errno;
    }
    return failure_ == 0;
}

int CheckedFile::finish() {
    if (file_ >= 0 && ::close(file_) != 0 && failure_ == 0) failure_ = errno;
    file_ = -1;
    return failure_;
}

}  // namespace nacre::app
