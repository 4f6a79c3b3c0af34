#pragma once
// A folder of files that can be made again: limited in size, safe among processes. Knows no Vulkan.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace nacre {

/// An entry is a file that appears whole, by rename. When the folder outgrows its limit, the entries that were used
/// longest ago go. Nothing here throws: a cache that cannot be read or written is one that holds nothing.
/// Names are the caller's to make safe: letters, digits, '-', '_' and '.', not at the start.
class DiskCache {
public:
    /// A cache that holds nothing and keeps nothing.
    DiskCache() = default;
    /// @param folder  made when first written to; empty: as without arguments
    DiskCache(std::string folder, std::uint64_t maxBytes) : folder_(std::move(folder)), maxBytes_(maxBytes) {}

    bool on() const { return !folder_.empty(); }
    const std::string& folder() const { return folder_; }
    std::string pathOf(std::string_view name) const;

    /// The whole entry, which counts as used now; empty if there is none, or none of at most `maxBytes`.
    std::optional<std::string> read(std::string_view name) const;
    /// Makes or replaces an entry from its parts, one after the other. False if it could not be kept.
    bool write(std::string_view name, std::span<const std::string_view> parts) const;
    void remove(std::string_view name) const;

    /// Makes the folder, for whoever writes an entry by other means. False if that fails.
    bool makeFolder() const;
    /// Removes what was used longest ago until the limit holds. What is still being written (names that start with '.'
    /// or end in ".part", changed within the last day) stays, but counts.
    void trim() const;

private:
    std::string folder_;
    std::uint64_t maxBytes_ = 0;
};

}  // namespace nacre
