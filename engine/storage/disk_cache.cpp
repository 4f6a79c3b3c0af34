#include "engine/storage/disk_cache.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>

#include "engine/storage/plain_file.h"

namespace nacre {
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kUnfinishedSeconds = 24 * 3600;  // after this time the writer is presumed dead
constexpr std::string_view kTemporary = ".new-";

// The Cache Directory Tagging Specification, https://bford.info/cachedir/
constexpr const char* kTagName = "CACHEDIR.TAG";
constexpr std::string_view kTag =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# Nacre keeps here what it can make or download again, and removes what it has not used for long.\n";

bool unfinished(std::string_view name) { return name.starts_with(kTemporary) || name.ends_with(".part"); }

/// Status of the path itself; does not follow a link.
bool readStatus(const std::string& path, struct stat& status) { return lstat(path.c_str(), &status) == 0; }

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

std::vector<std::string> namesIn(const std::string& folder) {
    struct Close {
        void operator()(DIR* open) const { closedir(open); }
    };
    std::vector<std::string> names;
    const std::unique_ptr<DIR, Close> open(opendir(folder.c_str()));
    if (!open) return names;
    while (const dirent* entry = readdir(open.get()))
        if (const std::string name = entry->d_name; name != "." && name != "..") names.push_back(name);
    return names;
}

}  // namespace

struct DiskCache::File {
    std::string path;
    std::uint64_t bytes;
    std::int64_t used;  ///< time of last use, seconds
    std::int64_t nanoseconds;
    bool unfinished;
};

std::string DiskCache::temporaryName() { return std::string(kTemporary) + unforeseenDigits(); }

std::string DiskCache::entryPath(std::string_view name) const { return (fs::path(folder_) / name).string(); }

bool DiskCache::isEntry(std::string_view name) const {
    return name.starts_with(kTemporary) || std::any_of(prefixes_.begin(), prefixes_.end(),
                                                       [&](const auto& prefix) { return name.starts_with(prefix); });
}

/// Whether the folder is one of our caches.
bool DiskCache::isOwn() const { return readPlain(entryPath(kTagName), kTag.size()) == kTag; }

std::vector<DiskCache::File> DiskCache::files() const {
    std::vector<File> files;
    for (const std::string& name : namesIn(folder_)) {
        struct stat status {};
        const std::string path = entryPath(name);
        if (!isEntry(name) || !readStatus(path, status) || !S_ISREG(status.st_mode)) continue;
#ifdef __APPLE__
        const timespec used = status.st_mtimespec;
#else
        const timespec used = status.st_mtim;
#endif
        files.push_back(
            {path, static_cast<std::uint64_t>(status.st_size), used.tv_sec, used.tv_nsec, unfinished(name)});
    }
    return files;
}

std::optional<std::string> DiskCache::read(std::string_view name) const {
    if (!on()) return std::nullopt;
    std::optional<std::string> bytes = readPlain(entryPath(name), maxBytes_);
    if (bytes) utimensat(AT_FDCWD, entryPath(name).c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
    return bytes;
}

bool DiskCache::write(std::string_view name, std::span<const std::string_view> parts, bool trims) const {
    std::uint64_t size = 0;
    for (const std::string_view part : parts) size += part.size();
    if (!on() || size > maxBytes_ || !makeFolder()) return false;
    const std::string temporary = entryPath(temporaryName()), path = entryPath(name);
    const int file = openPlain(temporary, O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (file < 0) return false;
    bool whole = true;
    for (const std::string_view part : parts) whole = whole && writeAll(file, part);
    whole = whole && fsync(file) == 0;
    whole = close(file) == 0 && whole;
    struct stat before {};
    const bool free = !readStatus(path, before) || S_ISREG(before.st_mode);
    if (!whole || !free || std::rename(temporary.c_str(), path.c_str()) != 0) {
        unlink(temporary.c_str());
        return false;
    }
    if (trims) trim();
    return true;
}

void DiskCache::remove(std::string_view name) const {
    struct stat status {};
    if (on() && readStatus(entryPath(name), status) && S_ISREG(status.st_mode)) unlink(entryPath(name).c_str());
}

bool DiskCache::makeFolder() const {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) return false;
    if (isOwn()) return true;
    for (const std::string& name : namesIn(folder_)) {
        struct stat status {};
        if (name != kTagName && (!isEntry(name) || !readStatus(entryPath(name), status) || !S_ISREG(status.st_mode)))
            return false;
    }
    const std::string temporary = entryPath(temporaryName());
    const int file = openPlain(temporary, O_WRONLY | O_CREAT | O_EXCL, 0600);
    if (file < 0) return false;
    const bool whole = writeAll(file, kTag);
    close(file);
    // Never overwrites a foreign tag: it marks another program's cache.
    const bool made = whole && link(temporary.c_str(), entryPath(kTagName).c_str()) == 0;
    unlink(temporary.c_str());
    return made || isOwn();
}

void DiskCache::trim() const {
    if (!on() || !isOwn()) return;
    std::vector<File> all = files();
    std::uint64_t total = 0;
    for (const File& file : all) total += file.bytes;
    std::sort(all.begin(), all.end(), [](const File& a, const File& b) {
        return a.used != b.used ? a.used < b.used : a.nanoseconds < b.nanoseconds;
    });
    const std::int64_t now = time(nullptr);
    for (const File& file : all) {
        const bool stale = file.unfinished && now - file.used > kUnfinishedSeconds;
        if (file.unfinished ? !stale : total <= maxBytes_) continue;
        if (unlink(file.path.c_str()) == 0) total -= file.bytes;
    }
}

}  // namespace nacre
