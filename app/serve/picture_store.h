#pragma once
// Cache of sent pictures on disk, limited in size.

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "engine/storage/disk_cache.h"

namespace nacre::app {

/// Key of some bytes: 32 hexadecimal digits of their XXH3.
std::string contentKey(const std::string& bytes);

class PictureStore {
public:
    /// @param folder  empty: no cache  @param bytes  maximum size
    PictureStore(std::string folder, std::uint64_t bytes);

    std::optional<std::string> find(const std::string& name) const;
    /// Stores a picture, if possible. The least recently used ones are removed to make room.
    void keep(const std::string& name, const std::string& picture);

private:
    const std::uint64_t slack_;  ///< bytes that are kept before those are looked for that make room
    const DiskCache cache_;
    std::mutex turn_;
    std::uint64_t added_ = 0;  ///< bytes since then
};

}  // namespace nacre::app
