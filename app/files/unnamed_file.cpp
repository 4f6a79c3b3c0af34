#include "app/files/unnamed_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "engine/error.h"

namespace nacre::app {
namespace {

[[noreturn]] void failToHold() { throw Error("cannot hold a temporary file", "", std::strerror(errno)); }

int fileInMemory() {
#ifdef MFD_CLOEXEC
    return memfd_create("nacre", MFD_CLOEXEC);
#else
    return -1;
#endif
}

int unlinkedFile() {
    const char* own = std::getenv("TMPDIR");
    const std::string folder = own && *own ? own : "/tmp";
#ifdef O_TMPFILE
    if (const int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600); file >= 0) return file;
#endif
    std::string name = folder + "/nacre-XXXXXX";
    const int file = mkstemp(name.data());
    if (file < 0) return -1;
    unlink(name.c_str());
    fcntl(file, F_SETFD, FD_CLOEXEC);
    return file;
}

}  // namespace

std::string pathOfDescriptor(int descriptor) {
#ifdef __linux__
    return "/proc/self/fd/" + std::to_string(descriptor);
#else
    return "/dev/fd/" + std::to_string(descriptor);
#endif
}

void failOverFileSize() {
    static const bool once = [] {
        struct sigaction now {};
        if (sigaction(SIGXFSZ, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) std::signal(SIGXFSZ, SIG_IGN);
        return true;
    }();
    static_cast<void>(once);
}

UnnamedFile::UnnamedFile(Place place) : file_(place == Place::memory ? fileInMemory() : -1) {
    failOverFileSize();
    if (file_ < 0) file_ = unlinkedFile();
    if (file_ < 0) failToHold();
}

UnnamedFile::~UnnamedFile() { close(file_); }

std::uint64_t UnnamedFile::size() const {
    struct stat status {};
    return fstat(file_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

void UnnamedFile::append(std::string_view bytes) {
    auto at = static_cast<off_t>(size());
    while (!bytes.empty()) {
        const ssize_t written = pwrite(file_, bytes.data(), bytes.size(), at);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) failToHold();
        at += written;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::size_t UnnamedFile::read(std::uint64_t at, char* to, std::size_t count) const {
    for (;;) {
        const ssize_t got = pread(file_, to, count, static_cast<off_t>(at));
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR) failToHold();
    }
}

void UnnamedFile::eachPiece(const std::function<void(std::string_view)>& take) const {
    std::array<char, 1 << 16> piece;
    std::uint64_t at = 0;
    for (std::size_t got; (got = read(at, piece.data(), piece.size())) > 0; at += got) take({piece.data(), got});
}

std::string UnnamedFile::bytes() const {
    std::string all(size(), '\0');
    for (std::size_t done = 0; done < all.size();) {
        const std::size_t got = read(done, all.data() + done, all.size() - done);
        if (got == 0) all.resize(done);
        done += got;
    }
    return all;
}

}  // namespace nacre::app
