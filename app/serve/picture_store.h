#pragma once
// Pictures shared by several requests: a size-limited disk cache of sent ones, and those being drawn.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "app/serve/workers.h"
#include "engine/storage/disk_cache.h"

namespace nacre::app {

class UnnamedFile;

/// Key of some bytes: 32 hexadecimal digits of their XXH3.
std::string contentKey(std::string_view bytes);
/// Key of a file's bytes. @throws Error
std::string contentKey(const UnnamedFile& file);

class PictureStore {
public:
    /// @param folder  empty: no cache  @param bytes  maximum size
    PictureStore(std::string folder, std::uint64_t bytes);

    /// A stored picture. Removes a damaged one.
    std::optional<std::string> find(const std::string& name) const;
    /// Stores a picture, if possible. Removes the least recently used ones to make room.
    void keep(const std::string& name, const std::string& picture);

private:
    const std::uint64_t slack_;  ///< bytes to add before old pictures are removed
    const DiskCache cache_;
    std::mutex turn_;
    std::uint64_t added_ = 0;  ///< bytes since then
};

/// One drawing for all concurrent requests for the same picture.
class SharedPictures {
public:
    using Shared = std::shared_ptr<const ServedPicture>;

    /// The picture of this name, from `draw` or from the thread that is drawing it. @throws the exception of that
    /// `draw`
    Shared get(const std::string& name, const std::function<ServedPicture()>& draw);

private:
    std::mutex turn_;
    std::map<std::string, std::shared_future<Shared>> drawn_;  ///< currently
};

}  // namespace nacre::app
