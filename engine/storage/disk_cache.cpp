#include "engine/storage/disk_cache.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>
#include <vector>

namespace nacre {
namespace fs = std::filesystem;

namespace {

constexpr auto kUnfinishedFor = std::chrono::hours(24);  // then whoever was writing it has gone

bool unfinished(const std::string& name) {
    return name.front() == '.' || (name.size() > 5 && name.compare(name.size() - 5, 5, ".part") == 0);
}

/// A name that no other process or thread takes: the random number is a forked process's, too, and the process's number
/// may be another's on a folder that machines share.
std::string temporaryName() {
    static const std::uint64_t process = (std::uint64_t{std::random_device{}()} << 32) | std::random_device{}();
    static std::atomic<unsigned> count{0};
    char name[64];
    std::snprintf(name, sizeof name, ".new-%016llx-%ld-%u", static_cast<unsigned long long>(process),
                  static_cast<long>(getpid()), count++);
    return name;
}

struct Entry {
    fs::path path;
    std::uint64_t bytes;
    fs::file_time_type used;
    bool unfinished;
};

std::vector<Entry> entriesOf(const std::string& folder) {
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
        std::error_code gone;  // another process may remove it meanwhile
        const bool plain = i->is_regular_file(gone);
        const std::uint64_t bytes = plain && !gone ? i->file_size(gone) : 0;
        const fs::file_time_type used = i->last_write_time(gone);
        if (plain && !gone) entries.push_back({i->path(), bytes, used, unfinished(i->path().filename().string())});
    }
    return entries;
}

}  // namespace

std::string DiskCache::pathOf(std::string_view name) const { return (fs::path(folder_) / name).string(); }

std::optional<std::string> DiskCache::read(std::string_view name) const {
    if (!on()) return std::nullopt;
    const std::string path = pathOf(name);
    // The size is the opened file's: another process may put a new one in its place at any moment.
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const auto size = static_cast<std::streamoff>(file.tellg());
    if (!file || size < 0 || static_cast<std::uint64_t>(size) > maxBytes_) return std::nullopt;
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!file.seekg(0) || !file.read(bytes.data(), size)) return std::nullopt;
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return bytes;
}

bool DiskCache::write(std::string_view name, std::span<const std::string_view> parts) const {
    std::uint64_t size = 0;
    for (const std::string_view part : parts) size += part.size();
    if (!on() || size > maxBytes_ || !makeFolder()) return false;
    const std::string temporary = pathOf(temporaryName());
    std::error_code error;
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    for (const std::string_view part : parts) file.write(part.data(), static_cast<std::streamsize>(part.size()));
    file.close();
    if (file) fs::rename(temporary, pathOf(name), error);
    if (!file || error) {
        fs::remove(temporary, error);
        return false;
    }
    trim();
    return true;
}

void DiskCache::remove(std::string_view name) const {
    std::error_code ignored;
    if (on()) fs::remove(pathOf(name), ignored);
}

bool DiskCache::makeFolder() const {
    std::error_code error;
    fs::create_directories(folder_, error);
    return !error;
}

void DiskCache::trim() const {
    std::vector<Entry> entries = entriesOf(folder_);
    std::uint64_t total = 0;
    for (const Entry& entry : entries) total += entry.bytes;
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
    const fs::file_time_type now = fs::file_time_type::clock::now();
    for (const Entry& entry : entries) {
        const bool stale = entry.unfinished && now - entry.used > kUnfinishedFor;
        if (entry.unfinished ? !stale : total <= maxBytes_) continue;
        std::error_code error;
        if (fs::remove(entry.path, error)) total -= entry.bytes;
    }
}

}  // namespace nacre
