#include "app/files/opened_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/files/unnamed_file.h"
#include "engine/error.h"

namespace nacre::app {
namespace fs = std::filesystem;

std::shared_ptr<const OpenFolder> OpenFolder::at(const std::string& path) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    const int folder = error ? -1 : ::open(real.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return nullptr;
    return std::shared_ptr<const OpenFolder>(new OpenFolder(real.string(), folder));
}

OpenFolder::~OpenFolder() { ::close(folder_); }

std::shared_ptr<const OpenedFile> OpenFolder::open(const std::string& name) const {
    if (name.find('\0') != std::string::npos) return nullptr;
    std::error_code error;
    const fs::path root = path_, file = fs::canonical(root / name, error);
    const auto [atRoot, atFile] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (error || atRoot != root.end() || atFile == file.end()) return nullptr;
    // No links are followed from here on, in case somebody replaces a folder by one.
    std::shared_ptr<const OpenFolder> folder = shared_from_this();
    for (auto step = atFile; step != file.end(); ++step) {
        if (*step == "..") return nullptr;
        const bool last = std::next(step) == file.end();
        const int flags = last ? O_NONBLOCK : O_DIRECTORY;
        const int next = openat(folder->folder_, step->c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | flags);
        if (next < 0) return nullptr;
        if (!last) {
            folder =
                std::shared_ptr<const OpenFolder>(new OpenFolder((fs::path(folder->path_) / *step).string(), next));
            continue;
        }
        struct stat status {};
        if (fstat(next, &status) == 0 && S_ISREG(status.st_mode))
            return std::shared_ptr<const OpenedFile>(new OpenedFile(file.string(), next, folder));
        ::close(next);
    }
    return nullptr;
}

std::shared_ptr<const OpenedFile> OpenedFile::of(std::string name, const UnnamedFile& file) {
    const int own = fcntl(file.descriptor(), F_DUPFD_CLOEXEC, 0);
    if (own < 0) throw Error("cannot open file", name, std::strerror(errno));
    return std::shared_ptr<const OpenedFile>(new OpenedFile(std::move(name), own, nullptr));
}

OpenedFile::~OpenedFile() { ::close(file_); }

std::string OpenedFile::path() const { return pathOfDescriptor(file_); }

}  // namespace nacre::app
