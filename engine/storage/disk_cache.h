#pragma once
// A folder of files that can be recreated: limited in size, safe among processes. Makes no Vulkan calls.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// An entry is a file. It is renamed into place once it is completely on disk. When the folder exceeds its limit, the
/// least recently used entries are removed. Never throws: a cache that cannot be read or written behaves as empty.
/// Callers choose safe names: letters, digits, '-', '_' and '.', not at the start.
///
/// The folder may hold other programs' files. So a cache writes and removes only in a folder that it made itself, or
/// found empty or with nothing but its own kind of files (marked by CACHEDIR.TAG, which backup programs know); and only
/// regular files with its own names. It follows no links.
class DiskCache {
public:
    /// A cache that is always empty.
    DiskCache() = default;
    /// @param folder    created on the first write; empty: as without arguments
    /// @param prefixes  beginnings of entries' names
    DiskCache(std::string folder, std::uint64_t maxBytes, std::vector<std::string> prefixes)
        : folder_(std::move(folder)), maxBytes_(maxBytes), prefixes_(std::move(prefixes)) {}

    bool on() const { return !folder_.empty(); }
    const std::string& folder() const { return folder_; }
    std::string entryPath(std::string_view name) const;

    /// The whole entry, which counts as used now; empty if there is none, or it exceeds `maxBytes`.
    std::optional<std::string> read(std::string_view name) const;
    /// Makes or replaces an entry from consecutive parts. @returns false if it could not be stored
    /// @param trims  false: the caller trims later, since trimming visits every entry
    bool write(std::string_view name, std::span<const std::string_view> parts, bool trims = true) const;
    void remove(std::string_view name) const;

    /// Makes the folder, for callers that write an entry themselves. @returns false if it fails, or the folder is not
    /// ours
    bool makeFolder() const;
    /// A temporary name for a file that will become an entry.
    static std::string temporaryName();
    /// Removes the least recently used entries until the limit holds. Files still being written (temporary names, and
    /// names ending in ".part", changed within the last day) stay, but count.
    void trim() const;

private:
    struct File;
    bool isEntry(std::string_view name) const;
    bool isOwn() const;
    std::vector<File> files() const;

    std::string folder_;
    std::uint64_t maxBytes_ = 0;
    std::vector<std::string> prefixes_;
};

}  // namespace nacre
