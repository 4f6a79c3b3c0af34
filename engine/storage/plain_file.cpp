#include "engine/storage/plain_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <random>

namespace nacre {

int openPlain(const std::string& path, int flags, mode_t mode) {
    const int file = open(path.c_str(), (flags & ~O_TRUNC) | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, mode);
    if (file < 0) return -1;
    struct stat status {};
    const bool plain = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    if (plain && (!(flags & O_TRUNC) || ftruncate(file, 0) == 0)) return file;
    const int why = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    close(file);
    errno = why;
    return -1;
}

std::optional<std::string> readPlain(const std::string& path, std::uint64_t mostBytes) {
    const int file = openPlain(path, O_RDONLY);
    if (file < 0) return std::nullopt;
    struct stat status {};
    std::optional<std::string> bytes;
    if (fstat(file, &status) == 0 && static_cast<std::uint64_t>(status.st_size) <= mostBytes) {
        bytes.emplace(static_cast<std::size_t>(status.st_size), '\0');
        for (std::size_t done = 0; bytes && done < bytes->size();) {
            const ssize_t got = read(file, bytes->data() + done, bytes->size() - done);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0)
                bytes.reset();
            else
                done += static_cast<std::size_t>(got);
        }
    }
    close(file);
    return bytes;
}

std::string unforeseenDigits() {
    std::random_device device;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%08x%08x", static_cast<unsigned>(device()), static_cast<unsigned>(device()));
    return digits;
}

}  // namespace nacre
