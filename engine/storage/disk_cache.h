#pragma once
// A folder of files that can be made again: limited in size, safe among processes. Knows no Vulkan.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// An entry is a file that appears whole, by rename. When the folder outgrows its limit, the entries that were used
/// longest ago go. Nothing here throws: a cache that cannot be read or written is one that holds nothing.
/// Names are the caller's to make safe: letters, digits, '-', '_' and '.', not at the start.
///
/// Someone may have put other things in the folder, or taken a folder of his own for it. So a cache writes and removes
/// only where it made the folder itself, or found it empty or full of what it could have made (then there is a
/// CACHEDIR.TAG, which backups know, too); and of that only plain files with names as it gives them. No link is
/// followed.
class DiskCache {
public:
    /// A cache that holds nothing and keeps nothing.
    DiskCache() = default;
    /// @param folder    made when first written to; empty: as without arguments
    /// @param prefixes  what names of entries begin with
    DiskCache(std::string folder, std::uint64_t maxBytes, std::vector<std::string> prefixes)
        : folder_(std::move(folder)), maxBytes_(maxBytes), prefixes_(std::move(prefixes)) {}

    bool on() const { return !folder_.empty(); }
    const std::string& folder() const { return folder_; }
    std::string pathOf(std::string_view name) const;

    /// The whole entry, which counts as used now; empty if there is none, or none of at most `maxBytes`.
    std::optional<std::string> read(std::string_view name) const;
    /// Makes or replaces an entry from its parts, one after the other. False if it could not be kept.
    bool write(std::string_view name, std::span<const std::string_view> parts) const;
    void remove(std::string_view name) const;

    /// Makes the folder, for whoever writes an entry by other means. False if that fails, or it is not the cache's.
    bool makeFolder() const;
    /// A name for a file that is to become an entry.
    static std::string temporaryName();
    /// Removes what was used longest ago until the limit holds. What is still being written (temporary names, and those
    /// that end in ".part", changed within the last day) stays, but counts.
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
